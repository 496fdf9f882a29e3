#include "planner/drivable_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>

#include "planner/arcs.h"
#include "planner/connection.h"
#include "planner/free_space.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"
#include "tests/planner/path_fixture.h"

namespace headland {
namespace {

using test::expect_continuous;
using test::expect_inside;
using test::kRounding;
using test::rectangle;
using test::ring_m;
using test::up_and_down;

TEST(MakePath, OmegaTurnsJoinNarrowSwathsInsideTheField) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  const Plan plan = up_and_down(40.0, 60.0, 2.0, 10.0);
  const Path path = make_path(field, vehicle, plan, {});
  EXPECT_TRUE(path.violations.empty());
  ASSERT_EQ(path.segments.size(), 2 * plan.passes.size() - 1) << "no cusps where there is room";
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const PathSegment& segment = path.segments[i];
    EXPECT_EQ(segment.kind, i % 2 == 0 ? PathKind::kSwath : PathKind::kUTurn);
    EXPECT_EQ(segment.implement_down, i % 2 == 0);
    EXPECT_EQ(segment.manoeuvre, static_cast<int>(i));
  }
}

TEST(MakePath, ImplementWorksFromEndToEndOfEachSwath) {
  const Vehicle vehicle = made_up_vehicle(2.6, 6.0);
  const Plan plan = up_and_down(40.0, 60.0, 6.0, 10.0);
  const Path path = make_path(rectangle(40.0, 60.0), vehicle, plan, {});
  std::size_t pass = 0;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind != PathKind::kSwath) continue;
    const auto implement = [&](const PathPoint& axle) -> Eigen::Vector2d {
      return axle.p_W + vehicle.implement.x_B_m * direction_of(axle.heading_rad);
    };
    const auto& points = plan.passes.at(pass++).points_W;
    EXPECT_LT((implement(segment.points.front()) - points.front()).norm(), kRounding);
    EXPECT_LT((implement(segment.points.back()) - points.back()).norm(), kRounding);
  }
  EXPECT_EQ(pass, plan.passes.size());
}

TEST(MakePath, ThreePointTurnsWhereOmegasDoNotFit) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  const Path path = make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, 6.0), {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  int reversed = 0;
  for (const PathSegment& segment : path.segments) {
    if (segment.gear != Gear::kReverse) continue;
    ++reversed;
    EXPECT_EQ(segment.kind, PathKind::kUTurn);
    EXPECT_FALSE(segment.implement_down);
  }
  EXPECT_GT(reversed, 0);
}

// Out of a lane that is no wider than its hull is long a vehicle only comes in reverse. Where it
// must it does, for what is optional it does not.
TEST(MakePath, NoOptionalPassIsWorthBackingFar) {
  const Vehicle vehicle = made_up_vehicle(2.6, 1.6);
  Field field;
  field.boundary = {{0, 0}, {50, 0}, {50, 19}, {110, 19}, {110, 21}, {50, 21}, {50, 40}, {0, 40}};
  const auto path_with = [&](bool optional) {
    Plan plan;
    plan.passes.push_back({PassKind::kSwath, {{20.0, 20.0}, {100.0, 20.0}}});
    plan.passes.push_back({PassKind::kSwath, {{20.0, 5.0}, {40.0, 5.0}}, optional});
    return make_path(field, vehicle, plan, {});
  };
  const auto backed_m = [](const Path& path) {
    double sum_m = 0.0;
    for (const PathSegment& segment : path.segments) {
      if (segment.gear == Gear::kReverse) sum_m += length_m(segment);
    }
    return sum_m;
  };
  const Path must = path_with(false);
  EXPECT_GT(backed_m(must), 40.0);
  EXPECT_TRUE(must.left_out.empty());
  const Path may = path_with(true);
  EXPECT_EQ(backed_m(may), 0.0);
  EXPECT_EQ(may.left_out.size(), 1U);
}

TEST(MakePath, BeginsAtTheFreePoseNearestToTheEntry) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Field field = rectangle(40.0, 60.0);
  field.entry_W = Eigen::Vector2d(40.0, 30.0);
  const Path path = make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, 10.0), {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  ASSERT_FALSE(path.segments.empty());
  EXPECT_EQ(path.segments.front().kind, PathKind::kTransit);
  EXPECT_FALSE(path.segments.front().implement_down);
  // The hull is 1.4 m wide and reaches 0.6 m behind the axle: it fits within a metre of the gate.
  const double shift_m = (path.segments.front().points.front().p_W - *field.entry_W).norm();
  EXPECT_GT(shift_m, 0.6);
  EXPECT_LE(shift_m, 1.0);
}

TEST(MakePath, HeadlandRingIsDrivenSmoothlyAndClosesOverItsBeginning) {
  const Vehicle vehicle = made_up_vehicle(4.0, 2.0);
  const double radius_m = 5.0;
  Plan plan;
  plan.passes.push_back({PassKind::kHeadlandPass, ring_m(3.0, 57.0, radius_m)});
  const Field field = rectangle(60.0, 60.0);
  const Path path = make_path(field, vehicle, plan, {});
  expect_continuous(path, vehicle);
  ASSERT_EQ(path.segments.size(), 1U);
  const PathSegment& ring = path.segments.front();
  EXPECT_EQ(ring.kind, PathKind::kHeadlandPass);
  EXPECT_TRUE(ring.implement_down);
  const double around_m = 4.0 * (54.0 - 2.0 * radius_m) + 2.0 * kPi * radius_m;
  const double smoothing_m = 0.2;  // corners are cut by 1 cm, the chords are shorter than the arc
  EXPECT_NEAR(length_m(ring), around_m, smoothing_m);
  EXPECT_LT((ring.points.front().p_W - ring.points.back().p_W).norm(), smoothing_m);
  // Headings are those of the chords and curvatures those of the arcs.
  double total_rad = 0.0;
  for (std::size_t i = 1; i < ring.points.size(); ++i) {
    const Eigen::Vector2d chord = ring.points[i].p_W - ring.points[i - 1].p_W;
    EXPECT_GT(chord.dot(direction_of(ring.points[i].heading_rad)), 0.995 * chord.norm());
    EXPECT_LT(std::abs(ring.points[i].curvature_per_m), 1.1 / radius_m);
    total_rad += ring.points[i].curvature_per_m * chord.norm();
  }
  EXPECT_NEAR(total_rad, 2.0 * kPi, 0.05) << "curvature adds up to one turn";
}

TEST(MakePath, GoesAroundAHoleBetweenPasses) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Field field = rectangle(80.0, 80.0);
  field.holes.push_back({{30.0, 5.0}, {30.0, 60.0}, {50.0, 60.0}, {50.0, 5.0}});
  Plan plan;
  plan.passes.push_back({PassKind::kSwath, {{20.0, 60.0}, {20.0, 30.0}}});
  plan.passes.push_back({PassKind::kSwath, {{60.0, 30.0}, {60.0, 60.0}}});
  const Path path = make_path(field, vehicle, plan, {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  EXPECT_EQ(path.segments[1].kind, PathKind::kTransit);
}

TEST(MakePath, GoesAroundTheEndOfAWallBetweenPasses) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Field field = rectangle(80.0, 80.0);
  field.obstacles.push_back({ObstacleKind::kWall, {40.0, -1.0}, 0.2, 1.5, {0.0, 66.0}});
  Plan plan;
  plan.passes.push_back({PassKind::kSwath, {{20.0, 60.0}, {20.0, 30.0}}});
  plan.passes.push_back({PassKind::kSwath, {{60.0, 30.0}, {60.0, 60.0}}});
  const Path path = make_path(field, vehicle, plan, {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      const bool at_the_wall = std::abs(point.p_W.x() - 40.0) < kPathSpacing_m;
      EXPECT_TRUE(!at_the_wall || point.p_W.y() > 65.2) << point.p_W.transpose();
    }
  }
}

TEST(MakePath, RaisedImplementSwingsClearOfTrees) {
  const Vehicle vehicle = made_up_vehicle(2.6, 6.0);
  Field field = rectangle(60.0, 60.0);
  const Plan plan = up_and_down(60.0, 60.0, 6.0, 12.0);
  const Path before = make_path(field, vehicle, plan, {});
  const PathSegment& turn = before.segments[1];
  ASSERT_EQ(turn.kind, PathKind::kUTurn);
  const PathPoint& middle = turn.points[turn.points.size() / 2];
  // Beside the hull, under the bar, on the outer side of the turn.
  field.obstacles.push_back({ObstacleKind::kPole,
                             middle.p_W +
                                 vehicle.implement.x_B_m * direction_of(middle.heading_rad) +
                                 2.0 * left_of(middle.heading_rad),
                             0.1, 5.0});
  const Path after = make_path(field, vehicle, plan, {});
  expect_continuous(after, vehicle);
  expect_inside(after, field, vehicle, PathOptions{}.clearance_m);
  EXPECT_FALSE(fits(free_space(field, hull_of(vehicle)), {middle.p_W, middle.heading_rad}, 0.0))
      << "the pole is where the turn was";
}

// Any two swaths in a field with a hole and a tree are joined continuously and inside it.
RC_GTEST_PROP(MakePath, JoinsAnySwathsContinuously, ()) {
  const Vehicle vehicle = made_up_vehicle(3.0, 3.0);
  Field field = rectangle(100.0, 80.0);
  field.holes.push_back({{45.0, 30.0}, {45.0, 50.0}, {55.0, 50.0}, {55.0, 30.0}});
  field.obstacles.push_back({ObstacleKind::kTree, {80.0, 40.0}, 0.5, 6.0});
  const FreeSpace space = free_space(field, hull_of(vehicle));
  // One drawn seed, because a loop that draws until poses fit need not end at small sizes.
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto number = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  Plan plan;
  while (plan.passes.size() < 4) {
    const Pose begin{{number(4.0, 96.0), number(4.0, 76.0)}, number(-kPi, kPi)};
    const Arc line{12.0, 0.0, Gear::kForward};
    if (!fits_along(space, begin, {{14.0, 0.0, Gear::kForward}}, 0.2)) continue;
    plan.passes.push_back(
        {PassKind::kSwath, {begin.p_W, pose_along(begin, line, line.length_m).p_W}});
  }
  const Path path = make_path(field, vehicle, plan, {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, 0.0);
  RC_ASSERT(!testing::Test::HasFailure());
  RC_ASSERT(path.violations.empty());
  int down = 0;
  for (const PathSegment& segment : path.segments) {
    RC_ASSERT(segment.implement_down == (segment.kind == PathKind::kSwath));
    if (segment.implement_down) ++down;
  }
  RC_ASSERT(down == 4);
}

}  // namespace
}  // namespace headland
