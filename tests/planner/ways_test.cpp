// Ways inside a field: their lengths, orders by them, and ways out of tight places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/connection.h"
#include "planner/long_route.h"
#include "planner/pass_order.h"
#include "planner/turns.h"
#include "planner/way_lengths.h"
#include "planner/way_to_room.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

constexpr double kEnd = 1e-6;          // m and rad
constexpr double kGridDetour = 1.085;  // of ways over square cells with diagonals

// Two rooms with a wall between them that leaves 10 m in the north.
Field two_rooms() {
  return field_of("two rooms",
                  {{0, 0}, {49, 0}, {49, 90}, {51, 90}, {51, 0}, {100, 0}, {100, 100}, {0, 100}});
}

FreeSpace space_of(const Field& field) {
  return free_space(field, hull_of(made_up_vehicle(2.6, 2.0)));
}

TEST(WayLengths, AreStraightWhereNothingIsBetween) {
  const WayLengths ways(space_of(two_rooms()), {{10, 10}, {40, 50}},
                        {{40, 50}, {10, 10}, {10, 50}});
  EXPECT_NEAR(ways.between_m(0, 0), 50.0, 1e-3);
  EXPECT_NEAR(ways.between_m(1, 1), 50.0, 1e-3);
  EXPECT_NEAR(ways.between_m(0, 2), 40.0, 1e-3);
  EXPECT_NEAR(ways.between_m(1, 2), 30.0, 1e-3);
  EXPECT_EQ(ways.between_m(1, 0), 0.0);
}

TEST(WayLengths, GoAroundWalls) {
  const WayLengths ways(space_of(two_rooms()), {{40, 10}}, {{60, 10}});
  // Around the wall's end, with the hull's half width from it.
  const double shortest_m = 2.0 * std::hypot(9.0, 80.0) + 2.0;
  EXPECT_GT(ways.between_m(0, 0), shortest_m);
  EXPECT_LT(ways.between_m(0, 0), kGridDetour * shortest_m + 4.0);
}

TEST(WayLengths, ThereIsNoneThroughAGapNarrowerThanTheHull) {
  Field field = two_rooms();
  for (Eigen::Vector2d& p_W : field.boundary) {
    if (p_W.y() == 90.0) p_W.y() = 99.0;
  }
  const WayLengths ways(space_of(field), {{40, 10}}, {{60, 10}});
  EXPECT_EQ(ways.between_m(0, 0), kNoWay_m);
}

double driven_m(const std::vector<Pass>& passes) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < passes.size(); ++i) {
    sum_m += (passes[i].points_W.front() - passes[i - 1].points_W.back()).norm();
  }
  return sum_m;
}

TEST(PassOrder, KeepsAllPassesAndShortensTheWay) {
  std::vector<Pass> passes;
  for (int i = 0; i < 30; ++i) {
    const double x_m = 5.0 + (i * 37) % 90;
    const double y_m = 5.0 + (i * 53) % 90;
    passes.push_back({PassKind::kSwath, {{x_m, y_m}, {x_m + 2.0, y_m}}, true});
  }
  const Field field = field_of("square", rectangle_ring(0, 0, 100, 100));
  const std::vector<Pass> made = ordered(passes, Eigen::Vector2d(0.0, 0.0), space_of(field), 2.6);
  ASSERT_EQ(made.size(), passes.size());
  for (const Pass& pass : passes) {
    EXPECT_TRUE(std::ranges::any_of(
        made, [&](const Pass& other) { return other.points_W == pass.points_W; }));
  }
  EXPECT_LT(driven_m(made), 0.5 * driven_m(passes));
}

// With its front in a corner the vehicle cannot turn; the way leads to where it can. Beside it is
// as much room as the rear corner needs to swing out in a gentle curve.
TEST(WayToRoom, LeadsOutOfACorner) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const FreeSpace space = space_of(field_of("square", rectangle_ring(0, 0, 60, 60)));
  const double radius_m = planning_turning_radius_m(vehicle);
  const Pose cornered{{60.0 - 2.4 - 0.1 - 1e-3, 0.7 + 0.1 + 0.1}, 0.0};
  ASSERT_TRUE(fits(space, cornered, 0.1));
  const auto way = way_to_room(space, cornered, radius_m, 0.1);
  ASSERT_TRUE(way.has_value());
  ASSERT_FALSE(way->empty());
  EXPECT_TRUE(fits_along(space, cornered, *way, 0.1));
  const Pose there = end_of(cornered, *way);
  const Pose back = end_of(there, driven_back(*way));
  EXPECT_LT((back.p_W - cornered.p_W).norm(), kEnd);
  EXPECT_LT(std::abs(wrap_angle(back.heading_rad - cornered.heading_rad)), kEnd);
  EXPECT_TRUE(fits_along(space, there, driven_back(*way), 0.1));
  // In the open there is room at once.
  const auto open = way_to_room(space, {{30, 30}, 0.0}, radius_m, 0.1);
  ASSERT_TRUE(open.has_value());
  EXPECT_TRUE(open->empty());
}

TEST(LongRoute, LeadsAroundAWall) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const FreeSpace space = space_of(two_rooms());
  RouteOptions options;
  options.radius_m = planning_turning_radius_m(vehicle);
  options.clearance_m = 0.1;
  options.max_nodes = 20000;
  const Pose from{{20, 20}, 0.0};
  const Pose to{{80, 20}, 0.0};
  int expanded = 0;
  const auto route = find_long_route(space, from, to, options, &expanded);
  ASSERT_TRUE(route.has_value());
  EXPECT_TRUE(fits_along(space, from, *route, 0.1));
  const Pose end = end_of(from, *route);
  EXPECT_LT((end.p_W - to.p_W).norm(), kEnd);
  EXPECT_LT(std::abs(wrap_angle(end.heading_rad - to.heading_rad)), kEnd);
  EXPECT_GT(length_m(*route), 2.0 * std::hypot(29.0, 70.0));
  EXPECT_LT(length_m(*route), 1.3 * (2.0 * std::hypot(29.0, 70.0) + 2.0));
}

TEST(BackingTurns, EndWhereTheyShould) {
  const Pose from{{0, 0}, 0.0};
  const Pose to{{3, 4}, kPi / 2.0};
  const std::vector<Turn> found = backing_turns(from, to, 2.6, {1.0, -1.0});
  ASSERT_FALSE(found.empty());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Pose end = end_of(from, found[i].arcs);
    EXPECT_LT((end.p_W - to.p_W).norm(), kEnd);
    EXPECT_LT(std::abs(wrap_angle(end.heading_rad - to.heading_rad)), kEnd);
    EXPECT_NEAR(found[i].cost_m, cost_m(found[i].arcs), kEnd);
    EXPECT_FALSE(has_odd_run(found[i].arcs, true));
    if (i > 0) {
      EXPECT_LE(found[i - 1].cost_m, found[i].cost_m + kEnd);
    }
  }
}

TEST(OddRuns, AreVeryShortOnesBetweenGearChangesAndLongOnesInReverse) {
  constexpr Gear F = Gear::kForward;
  constexpr Gear B = Gear::kReverse;
  EXPECT_FALSE(has_odd_run({{3, 0, F}, {2, 0, B}, {3, 0, F}}, false));
  EXPECT_TRUE(has_odd_run({{3, 0, F}, {0.05, 0, B}, {3, 0, F}}, false));
  EXPECT_FALSE(has_odd_run({{3, 0, F}, {0.05, 0, B}, {0.2, 0.1, B}, {3, 0, F}}, false));
  EXPECT_TRUE(has_odd_run({{3, 0, F}, {kLongestBacking_m + 1.0, 0, B}}, false));
  // A short way forwards at an end goes on from the pass before it.
  EXPECT_TRUE(has_odd_run({{0.05, 0, F}, {3, 0, B}}, false));
  EXPECT_FALSE(has_odd_run({{0.05, 0, F}, {3, 0, B}, {0.05, 0, F}}, true));
}

}  // namespace
}  // namespace headland
