#include "planner/transit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/continuous_turns.h"
#include "planner/worked_rows.h"
#include "tests/planner/field_shapes.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kSameEnd = 1e-6;   // m and rad, of sums of arcs
constexpr double kSharpness = 0.1;  // 1/m2

Field strip_of_road() { return field_of("road", rectangle_ring(-10, -10, 130, 40)); }

// Out of a field of 40 by 30 m, and along a road that bends by 17 degrees.
TransitRequest out_of_a_field() {
  TransitRequest request;
  request.from = PathPoint{{20, 20}, 0.0, 0.0};
  request.way_W = {{50, 5}, {80, 5}, {118, 17}};
  request.leaving = strip_of_road();
  request.road = strip_of_road();
  request.arriving = strip_of_road();
  return request;
}

// The greatest change of curvature from a point to the next where the vehicle does not stop.
double greatest_jump_per_m(const Path& path) {
  double greatest_per_m = 0.0;
  const PathSegment* before = nullptr;
  for (const PathSegment& segment : path.segments) {
    for (std::size_t i = 1; i < segment.points.size(); ++i) {
      greatest_per_m = std::max(greatest_per_m, std::abs(segment.points[i].curvature_per_m -
                                                         segment.points[i - 1].curvature_per_m));
    }
    if (before != nullptr && before->gear == segment.gear) {
      greatest_per_m = std::max(greatest_per_m, std::abs(segment.points.front().curvature_per_m -
                                                         before->points.back().curvature_per_m));
    }
    before = &segment;
  }
  return greatest_per_m;
}

TEST(Ramps, LeaveLinesAndEndsWhereTheyAre) {
  const std::vector<Arc> road = {{20, 0}, {6, 0.1},  {15, 0},    {0.5, -0.2},
                                 {10, 0}, {8, 0.05}, {1, -0.05}, {9, 0}};
  const std::vector<Arc> ramped = with_ramps(road, kSharpness);
  const Pose end = end_of({}, road);
  const Pose ramped_end = end_of({}, ramped);
  EXPECT_LT((end.p_W - ramped_end.p_W).norm(), kSameEnd);
  EXPECT_NEAR(end.heading_rad, ramped_end.heading_rad, kSameEnd);
  // Two bends have lines before and after them; two that follow each other stay.
  EXPECT_EQ(ramped.size(), road.size() + 2 * 2);
  EXPECT_FALSE(is_continuous(ramped));
  EXPECT_TRUE(is_continuous({ramped.begin(), ramped.begin() + 8}));
  EXPECT_FALSE(is_continuous({road.begin(), road.begin() + 2}));
  // The slight bend turns too little for its curvature: it gets what its ramps come to.
  EXPECT_NEAR(ramped[6].curvature_per_m, -std::sqrt(0.5 * 0.2 * kSharpness), 1e-12);
}

TEST(Ramps, AreLeftOutWhereLinesMeetInNoCorner) {
  for (const double arc_m : {0.0, 10.0 * std::numbers::pi, 40.0}) {  // nothing, half a turn, more
    const std::vector<Arc> road = {{20, 0}, {arc_m, 0.1}, {15, 0}, {6, 0.1}, {12, 0}};
    const std::vector<Arc> ramped = with_ramps(road, kSharpness);
    ASSERT_EQ(ramped.size(), road.size() + 2) << arc_m << " m: the other bend has its ramps";
    EXPECT_EQ(ramped[0].length_m, 20.0);
    EXPECT_EQ(ramped[1].length_m, arc_m);
    const Pose end = end_of({}, ramped);
    EXPECT_LT((end.p_W - end_of({}, road).p_W).norm(), kSameEnd);
  }
}

TEST(Ramps, NeedRoomOnTheLines) {
  const std::vector<Arc> cramped = {{0.1, 0}, {6, 0.1}, {15, 0}};
  EXPECT_EQ(with_ramps(cramped, kSharpness).size(), cramped.size());
}

TEST(Transits, BendNoFasterThanTheWheelsTurnWhereAsked) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const double step_per_m = turning_sharpness_per_m2(vehicle) * kPathSpacing_m;
  PathOptions options;
  const Path plain = transit_path(out_of_a_field(), vehicle, options);
  EXPECT_GT(greatest_jump_per_m(plain), 1.5 * step_per_m) << "as it is when not asked";
  EXPECT_EQ(plain.abrupt_turns, 0) << "nobody asked";
  options.continuous_turns = true;
  const Path path = transit_path(out_of_a_field(), vehicle, options);
  EXPECT_EQ(path.abrupt_turns, 0);
  EXPECT_LT(greatest_jump_per_m(path), (1.0 + 1e-6) * step_per_m);
  EXPECT_EQ(path.abrupt_joints, 0);
  // Ends of passes that bend are told, where the turns themselves do not jump.
  TransitRequest off_bends = out_of_a_field();
  off_bends.from->curvature_per_m = 2.0 * kJointJump_per_m;
  off_bends.to = PathPoint{{120, 5}, 0.0, -2.0 * kJointJump_per_m};
  off_bends.way_W = {{50, 5}, {80, 5}};
  EXPECT_EQ(transit_path(off_bends, vehicle, options).abrupt_turns, 0);
  EXPECT_EQ(transit_path(off_bends, vehicle, options).abrupt_joints, 2);
  off_bends.to->curvature_per_m = 0.5 * kJointJump_per_m;
  EXPECT_EQ(transit_path(off_bends, vehicle, options).abrupt_joints, 1);
  options.continuous_turns = false;
  EXPECT_EQ(transit_path(off_bends, vehicle, options).abrupt_joints, 0) << "nobody asked";
  options.continuous_turns = true;
  // A road without a straight before its bend leaves none for a ramp.
  TransitRequest bent = out_of_a_field();
  bent.from.reset();
  bent.way_W.clear();
  for (int i = 0; i <= 20; ++i) {
    bent.way_W.emplace_back(30 * std::sin(0.05 * i) + 50, 35 - 30 * std::cos(0.05 * i));
  }
  EXPECT_GT(transit_path(bent, vehicle, options).abrupt_turns, 0);
}

TEST(Transits, KeepOffRowsWhereAWayDoes) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const TransitRequest over = out_of_a_field();
  TransitRequest off = over;
  // Rows between the vehicle and the road, with room to pass on their left.
  WorkedGround rows = ground_to_work(off.leaving);
  const double half_m = 10.0;
  work(rows, between_bars({30, 5}, {34, 5}, {0, half_m}, {0, half_m}));
  off.rows = &rows;
  FreeSpace wheels;
  wheels.hull = hull_of(vehicle);
  wheels.worked = &rows;
  const auto over_rows = [&](const Path& path) {
    int count = 0;
    for (const PathSegment& segment : path.segments) {
      count += static_cast<int>(std::ranges::count_if(segment.points, [&](const PathPoint& point) {
        return !keeps_off_worked(wheels, pose_of(point));
      }));
    }
    return count;
  };
  const Path plain = transit_path(over, vehicle, {});
  EXPECT_GT(over_rows(plain), 5);
  const Path kept = transit_path(off, vehicle, {});
  EXPECT_EQ(over_rows(kept), 0);
  EXPECT_GT(length_m(kept), length_m(plain));
  // Shut in by rows it drives as if there were none.
  work(rows, between_bars({-10, 15}, {130, 15}, {0, 25}, {0, 25}));
  EXPECT_NEAR(length_m(transit_path(off, vehicle, {})), length_m(plain), 1e-9);
  PathOptions options;
  options.allow_overrun = true;
  EXPECT_TRUE(transit_path(over, vehicle, options).violations.empty());
  const Path told = transit_path(off, vehicle, options);
  ASSERT_EQ(told.violations.size(), 1U);
  EXPECT_EQ(told.violations[0].what, "onto the road: no way keeps the wheels off the rows worked");
  EXPECT_EQ(told.violations[0].overrun_m, 0.0);
}

// Two walls between the vehicle and the road, which no turn leads around, and rows in the way.
TEST(Transits, SearchOverRowsWithAsMuchAsWhereThereAreNone) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  TransitRequest request = out_of_a_field();
  request.way_W = {{50, 5}, {80, 5}, {118, 17}};
  request.leaving.holes = {reversed(rectangle_ring(30, -9, 31, 28)),
                           reversed(rectangle_ring(41, 2, 42, 39))};
  request.nodes = 100;
  const Path plain = transit_path(request, vehicle, {});
  WorkedGround rows = ground_to_work(request.leaving);
  // Between them a lane is left that is as wide as the hull and bends at right angles.
  work(rows, between_bars({31, 35.5}, {41, 35.5}, {0, 4.5}, {0, 4.5}));
  work(rows, between_bars({31, 9}, {34, 9}, {0, 19}, {0, 19}));
  work(rows, between_bars({36.5, 12}, {41, 12}, {0, 19}, {0, 19}));
  request.rows = &rows;
  EXPECT_NEAR(length_m(transit_path(request, vehicle, {})), length_m(plain), 1e-9);
  request.nodes = 1;
  EXPECT_THROW(transit_path(request, vehicle, {}), PlanInfeasible) << "it takes a search";
}

}  // namespace
}  // namespace headland
