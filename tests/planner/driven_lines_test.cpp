// Which passes are driven where gaps part a field.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "planner/algorithms/boustrophedon.h"
#include "planner/drivable_path.h"
#include "planner/part_ways.h"
#include "planner/planned_vehicle.h"
#include "planner/roomy_parts.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"
#include "tests/planner/path_fixture.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using test::rectangle;
using testing::HasSubstr;

constexpr double kEntryRoom_m = 3.0;  // a path begins where the hull fits near the entry

// A wall from south to north in the middle of 80 by 40 m, with gaps at both its ends.
Field with_wall(double gap_m) {
  Field field = rectangle(80.0, 40.0);
  field.holes.push_back({{40.0, gap_m}, {40.0, 40.0 - gap_m}, {41.0, 40.0 - gap_m}, {41.0, gap_m}});
  return field;
}

// 20 m west of the wall, then 30 m east of it.
Plan on_both_sides() {
  Plan plan;
  plan.passes.push_back({PassKind::kSwath, {{10.0, 20.0}, {30.0, 20.0}}, true});
  plan.passes.push_back({PassKind::kSwath, {{52.0, 10.0}, {67.0, 10.0}}, true});
  plan.passes.push_back({PassKind::kSwath, {{67.0, 20.0}, {52.0, 20.0}}, true});
  return plan;
}

std::vector<std::size_t> left_out(const Path& path) {
  std::vector<std::size_t> passes;
  for (const LeftOutPass& pass : path.left_out) passes.push_back(pass.pass);
  std::ranges::sort(passes);
  return passes;
}

TEST(DrivenLines, BeginWhereMostIsToBeDriven) {
  const Field field = with_wall(1.0);
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Path path = make_path(field, vehicle, on_both_sides(), {});
  EXPECT_EQ(left_out(path), std::vector<std::size_t>{0});
  EXPECT_THAT(path.left_out.at(0).why, HasSubstr("tight gaps to pass 1 (swath)"));
  test::expect_continuous(path, vehicle);
}

TEST(DrivenLines, BeginWhereTheFieldIsEntered) {
  Field field = with_wall(1.0);
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  PathOptions options;
  options.allow_overrun = true;  // else refused: less than half of the passes is driven
  for (const bool west : {true, false}) {
    field.entry_W = Eigen::Vector2d(west ? 2.0 : 78.0, 2.0);
    const Path path = make_path(field, vehicle, on_both_sides(), options);
    EXPECT_EQ(left_out(path),
              west ? (std::vector<std::size_t>{1, 2}) : std::vector<std::size_t>{0});
    EXPECT_LT((path.segments.front().points.front().p_W - *field.entry_W).norm(), kEntryRoom_m);
    test::expect_continuous(path, vehicle);
    test::expect_inside(path, field, vehicle, options.clearance_m);
  }
}

TEST(DrivenLines, GoThroughGapsThatAreWideEnough) {
  const Field field = with_wall(8.0);
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Path path = make_path(field, vehicle, on_both_sides(), {});
  EXPECT_TRUE(path.left_out.empty());
  test::expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
}

TEST(RoomyParts, AreJoinedByWideGapsAlone) {
  const Hull hull = hull_of(made_up_vehicle(2.6, 2.0));
  const Pose west{{20.0, 20.0}, 0.0};
  const Pose east{{60.0, 20.0}, 0.0};
  constexpr double kClearance_m = 0.1;
  const double wide_m = 2.0 * (hull.half_width_m + kClearance_m + kTightGap_m);
  for (const double gap_m : {0.7 * wide_m, 1.3 * wide_m}) {
    const RoomyParts parts = roomy_parts(free_space(with_wall(gap_m), hull), kClearance_m);
    EXPECT_GE(parts.at(west), 0);
    EXPECT_GE(parts.at(east), 0);
    EXPECT_EQ(parts.at(west) == parts.at(east), gap_m > wide_m) << gap_m;
  }
}

TEST(PartWays, AreTakenToBeApartAfterSearchesInARowAlone) {
  PartWays ways;
  const auto search = [&](int times) {
    for (int i = 0; i < times; ++i) note_search(ways, 0, 1, false);
  };
  search(kSearchesBetween - 1);
  EXPECT_FALSE(are_apart(ways, 0, 1));
  note_search(ways, 0, 1, true);
  search(kSearchesBetween - 1);
  EXPECT_FALSE(are_apart(ways, 0, 1));
  search(1);
  EXPECT_TRUE(are_apart(ways, 0, 1));
  EXPECT_FALSE(are_apart(ways, 1, 0)) << "one way has not been searched for";
  for (int i = 0; i < 2 * kSearchesBetween; ++i) {
    note_search(ways, 1, 1, false);
    note_search(ways, kNoPart, 1, false);
  }
  EXPECT_FALSE(are_apart(ways, 1, 1)) << "within a part nothing is learned";
  EXPECT_FALSE(are_apart(ways, kNoPart, 1));
}

// Lanes so narrow that the vehicle cannot turn in them, nor get from one to another.
TEST(DrivenLines, ThereIsAlwaysOneAndThatOfALaneThatTheEntryLeadsTo) {
  constexpr int kLanes = 7;
  constexpr double kLane_m = 2.4;
  Field field = rectangle(30.0, kLanes * kLane_m);
  Plan plan;
  for (int lane = 0; lane < kLanes; ++lane) {
    const double y = (lane + 0.5) * kLane_m;
    if (lane > 0) {
      const double wall = lane * kLane_m;
      field.holes.push_back(
          {{1.0, wall - 0.2}, {1.0, wall + 0.2}, {29.0, wall + 0.2}, {29.0, wall - 0.2}});
    }
    plan.passes.push_back({PassKind::kSwath, {{10.0, y}, {20.0, y}}, true});
  }
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  PathOptions options;
  options.allow_overrun = true;
  for (const int entered : {-1, kLanes - 1}) {
    if (entered >= 0) field.entry_W = Eigen::Vector2d(3.0, (entered + 0.5) * kLane_m);
    const Path path = make_path(field, vehicle, plan, options);
    ASSERT_FALSE(path.segments.empty());
    EXPECT_EQ(path.left_out.size(), plan.passes.size() - 1U);
    if (entered < 0) continue;
    EXPECT_FALSE(std::ranges::any_of(path.left_out, [&](const LeftOutPass& left_out) {
      return left_out.pass == static_cast<std::size_t>(entered);
    })) << entered;
    test::expect_continuous(path, vehicle);
    test::expect_inside(path, field, vehicle, 0.0);
    EXPECT_TRUE(path.violations.empty());
  }
}

Path covered_path(const Field& field, const Vehicle& vehicle) {
  PlanRequest request = transplanter_request(field, "boustrophedon");
  set_vehicle(request, vehicle);
  request.parameters["headland_corners"] = std::string("covered");
  return make_path(field, vehicle, plan_boustrophedon(request), {});
}

// A transplanter passes gaps from 1.9 m on and cannot turn in them.
TEST(DrivenLines, APassableGapDoesNotMakePlansLeaveMore) {
  const auto left_out_behind_m2 = [](double gap_m) {
    const double half_m = 0.5 * gap_m;
    const Field field = field_of("bay", {{0, -10},
                                         {30, -10},
                                         {30, -half_m},
                                         {31, -half_m},
                                         {31, -5},
                                         {41, -5},
                                         {41, 5},
                                         {31, 5},
                                         {31, half_m},
                                         {30, half_m},
                                         {30, 10},
                                         {0, 10}});
    return left_out_m2(covered_path(field, load_vehicle("transplanter")));
  };
  const double closed_m2 = left_out_behind_m2(1.5);
  EXPECT_GT(closed_m2, 90.0) << "negative control: the bay of 100 m2 cannot be reached";
  EXPECT_LT(left_out_behind_m2(1.95), closed_m2);
  EXPECT_EQ(left_out_behind_m2(2.5), 0.0);
}

// Its implement is no wider than its hull and the clearance need.
TEST(DrivenLines, LeadAwayFromEdgesOfANarrowImplement) {
  const Field field = field_of("square", rectangle_ring(0, 0, 24, 24));
  const Path path = covered_path(field, load_vehicle("horticultural_tractor"));
  EXPECT_LT(left_out_m2(path), 1.0);
}

}  // namespace
}  // namespace headland
