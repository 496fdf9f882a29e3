#include "planner/free_space.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "planner/connection.h"
#include "planner/space_cells.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

using Eigen::Vector2d;
constexpr double kRounding_m = 1e-9;

Field wavy_field_with_hole() {
  Field field;
  const int count = 200;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    const double radius_m = 60.0 + 4.0 * std::sin(11.0 * angle);
    field.boundary.emplace_back(radius_m * std::cos(angle), 0.7 * radius_m * std::sin(angle));
  }
  field.holes.push_back({{-5.0, -5.0}, {-8.0, 6.0}, {4.0, 9.0}, {9.0, -2.0}});  // clockwise
  field.obstacles.push_back({ObstacleKind::kTree, {30.0, 5.0}, 0.4, 5.0});
  field.obstacles.push_back({ObstacleKind::kPole, {-30.0, -4.0}, 0.1, 5.0});
  field.obstacles.push_back({ObstacleKind::kWall, {-20.0, 15.0}, 0.2, 1.5, {25.0, 8.0}});
  return field;
}

Hull hull() { return hull_of(made_up_vehicle(2.6, 6.0)); }

// By looking at points all over the hull, closely along its rim: distance to what is nearest,
// negative as soon as one point is out, obstacles kObstacleClearances times nearer than they are.
// Knows nothing of grids, boxes or clipping.
double sampled_clearance_m(const Field& field, const Hull& hull, const Pose& pose, double step_m) {
  double least_m = 1e9;
  const auto look_at = [&](const Obstacle& obstacle, const Vector2d& p) {
    const double gap_m = obstacle_gap_m(obstacle, p);
    least_m = std::min(least_m, gap_m > 0.0 ? gap_m / kObstacleClearances : gap_m);
  };
  const auto world = [&](double x, double y) -> Vector2d {
    return pose.p_W + x * direction_of(pose.heading_rad) + y * left_of(pose.heading_rad);
  };
  const int along = static_cast<int>((hull.front_m + hull.rear_m) / step_m);
  const int across = static_cast<int>(2.0 * hull.half_width_m / step_m);
  for (int i = 0; i <= along; ++i) {
    for (int j = 0; j <= across; ++j) {
      const bool rim = i == 0 || j == 0 || i == along || j == across;
      if (!rim && (i % 4 != 0 || j % 4 != 0)) continue;
      const Vector2d p = world(-hull.rear_m + (hull.front_m + hull.rear_m) * i / along,
                               -hull.half_width_m + 2.0 * hull.half_width_m * j / across);
      least_m = std::min(least_m, field_clearance_m(field, p));
      for (const Obstacle& obstacle : field.obstacles) look_at(obstacle, p);
    }
  }
  const int along_bar = static_cast<int>(2.0 * hull.bar_half_width_m / step_m) + 1;
  for (const Obstacle& obstacle : field.obstacles) {
    for (int i = 0; i <= along_bar; ++i) {
      const double y_m = hull.bar_half_width_m * (2.0 * i / along_bar - 1.0);
      for (const double x_m : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
        look_at(obstacle, world(hull.bar_x_m + x_m * kImplementDepth_m, y_m));
      }
    }
  }
  return least_m;
}

Pose random_pose() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) * 1e-3; };
  return {{number(-70000, 70000), number(-52000, 52000)}, number(-3141, 3142)};
}

RC_GTEST_PROP(FreeSpace, AgreesWithSamplingTheHull, ()) {
  static const Field field = wavy_field_with_hole();
  static const FreeSpace space = free_space(field, hull());
  const double step_m = 0.1;
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random_pose();
    const double clearance_m = *rc::gen::inRange(0, 2000) * 1e-3;
    const double sampled_m = sampled_clearance_m(field, hull(), pose, step_m);
    // Sampling misses what lies between its points, by at most half a step.
    if (fits(space, pose, clearance_m)) RC_ASSERT(sampled_m > clearance_m - kRounding_m);
    if (!fits(space, pose, clearance_m)) RC_ASSERT(sampled_m < clearance_m + 0.5 * step_m);
    const double safe_m = safe_distance_m(space, pose);
    if (safe_m > 0.0) RC_ASSERT(sampled_m >= safe_m - 1e-4);  // float distances of the cells
    const Overrun depth = overrun(space, pose);
    RC_ASSERT((depth.depth_m > 0.0) == !fits(space, pose, 0.0));
    if (sampled_m < -step_m) RC_ASSERT(depth.depth_m > 0.0);
  }
}

RC_GTEST_PROP(FreeSpace, DiscAgreesWithExactDistance, ()) {
  static const Field field = wavy_field_with_hole();
  static const FreeSpace space = free_space(field, hull());
  const Vector2d p_W = random_pose().p_W;
  const double radius_m = *rc::gen::inRange(1, 5000) * 1e-3;
  double exact_m = field_clearance_m(field, p_W);
  for (const Obstacle& obstacle : field.obstacles) {
    exact_m = std::min(exact_m, obstacle_gap_m(obstacle, p_W));
  }
  RC_ASSERT(disc_fits(space, p_W, radius_m) == (exact_m > radius_m));
}

Field square_field();  // below

TEST(FreeSpace, ObstaclesAreKeptThreeTimesAsFarAsEdges) {
  Field field = square_field();
  constexpr double kTree_m = 0.3;
  constexpr double kAsked_m = 0.1;
  field.obstacles.push_back({ObstacleKind::kTree, {25.0, 25.0}, kTree_m, 5.0});
  const FreeSpace space = free_space(field, hull());
  const auto before_tree = [&](double gap_m) {
    return Pose{{25.0 - kTree_m - gap_m - hull().front_m, 25.0}, 0.0};
  };
  EXPECT_TRUE(fits(space, before_tree(3.01 * kAsked_m), kAsked_m));
  EXPECT_FALSE(fits(space, before_tree(2.99 * kAsked_m), kAsked_m));
  EXPECT_TRUE(fits(space, before_tree(0.01), 0.0));
  EXPECT_NEAR(clearance_m(space, before_tree(0.15), 1.0), 0.05, kRounding_m);
  const Pose before_edge{{50.0 - hull().front_m - 1.01 * kAsked_m, 25.0}, 0.0};
  EXPECT_TRUE(fits(space, before_edge, kAsked_m));
}

// The implement is met by what stands ahead of or behind its working line too.
TEST(FreeSpace, TheImplementIsAsDeepAsItIsInPhysics) {
  Field field = square_field();
  constexpr double kPole_m = 0.05;
  const Pose pose{{25.0, 25.0}, 0.0};
  const double aside_m = hull().bar_half_width_m - 0.5;
  const auto depth_m = [&](double ahead_m) {
    field.obstacles = {
        {ObstacleKind::kPole, {25.0 + hull().bar_x_m + ahead_m, 25.0 + aside_m}, kPole_m, 5.0}};
    return overrun(free_space(field, hull()), pose).depth_m;
  };
  const double touching_m = 0.5 * kImplementDepth_m + kPole_m;
  EXPECT_NEAR(depth_m(touching_m - 0.02), 0.02, kRounding_m);
  EXPECT_NEAR(depth_m(-touching_m + 0.02), 0.02, kRounding_m);
  EXPECT_EQ(depth_m(touching_m + 0.001), 0.0);
}

TEST(FreeSpace, CellsKnowTheDistanceFromTheirCentres) {
  const Field field = wavy_field_with_hole();
  const FreeSpace space = free_space(field, hull());
  constexpr double kFloat_m = 1e-4;
  for (int row = 0; row < space.rows; row += 7) {
    for (int column = 0; column < space.columns; column += 5) {
      const Vector2d centre_W = centre_of(space, column, row);
      const FreeSpace::Cell& cell = space.cells[cell_at(space, column, row)];
      EXPECT_NEAR(cell.edge_distance_m, field_clearance_m(field, centre_W), kFloat_m);
      double obstacle_m = std::numeric_limits<double>::max();
      for (const Obstacle& obstacle : field.obstacles) {
        obstacle_m = std::min(obstacle_m, obstacle_gap_m(obstacle, centre_W));
      }
      EXPECT_NEAR(cell.obstacle_distance_m, obstacle_m, kFloat_m);
      EXPECT_NEAR(nearest_edge(space, centre_W).distance_m, std::abs(cell.edge_distance_m),
                  kFloat_m);
    }
  }
}

RC_GTEST_PROP(FreeSpace, FitsAlongIsFittingAtEveryPlace, ()) {
  static const FreeSpace space = free_space(wavy_field_with_hole(), hull());
  for (int i = 0; i < 20; ++i) {
    const Pose from = random_pose();
    const double clearance_m = *rc::gen::inRange(-10, 500) * 1e-3;
    std::vector<Arc> arcs;
    bool every = fits(space, from, clearance_m);
    for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
      const Pose start = end_of(from, arcs);
      arcs.push_back({*rc::gen::inRange(1, 12000) * 1e-3, *rc::gen::inRange(-1, 2) / 3.0,
                      *rc::gen::element(Gear::kForward, Gear::kReverse)});
      const double length_m = arcs.back().length_m;
      const int steps = static_cast<int>(std::ceil(length_m / kLookSpacing_m));
      for (int step = 1; step <= steps; ++step) {
        every = every &&
                fits(space, pose_along(start, arcs.back(), length_m / steps * step), clearance_m);
      }
    }
    RC_ASSERT(fits_along(space, from, arcs, clearance_m) == every);
  }
}

Field square_field() {
  Field field;
  field.boundary = {{0.0, 0.0}, {50.0, 0.0}, {50.0, 50.0}, {0.0, 50.0}};
  return field;
}

TEST(FreeSpace, OverrunIsTheDepthOfTheFrontBeyondTheBoundary) {
  const FreeSpace space = free_space(square_field(), hull());
  const Overrun worst = overrun(space, {{20.0, 50.0 - hull().front_m + 0.3}, kPi / 2.0});
  EXPECT_NEAR(worst.depth_m, 0.3, kRounding_m);
  EXPECT_EQ(worst.limit, Limit::kBoundary);
  EXPECT_NEAR(worst.p_W.y(), 50.3, kRounding_m);
  EXPECT_EQ(overrun(space, {{20.0, 50.0 - hull().front_m - 0.001}, kPi / 2.0}).depth_m, 0.0);
}

TEST(FreeSpace, FarOutsideIsAnOverrunToo) {
  const FreeSpace space = free_space(square_field(), hull());
  const Pose pose{{-100.0, 20.0}, 0.0};
  EXPECT_FALSE(fits(space, pose, 0.0));
  EXPECT_NEAR(overrun(space, pose).depth_m, 100.0 + hull().rear_m, kRounding_m);
}

TEST(FreeSpace, RaisedImplementMayHangOverTheBoundaryButNotOverATree) {
  Field field = square_field();
  const double beside_m = hull().half_width_m + 0.5;  // under the 6 m bar, beside the hull
  const Pose along_edge{{beside_m, 25.0}, kPi / 2.0};
  EXPECT_TRUE(fits(free_space(field, hull()), along_edge, 0.1));
  field.obstacles.push_back(
      {ObstacleKind::kTree, {beside_m + 2.5, 25.0 + hull().bar_x_m}, 0.2, 5.0});
  const FreeSpace space = free_space(field, hull());
  EXPECT_FALSE(fits(space, along_edge, 0.1));
  EXPECT_EQ(overrun(space, along_edge).limit, Limit::kObstacle);
  EXPECT_TRUE(fits(space, {{beside_m, 27.0}, kPi / 2.0}, 0.1)) << "the bar is past the tree";
}

TEST(FreeSpace, ThinHoleAcrossTheHullIsFound) {
  Field field = square_field();
  field.holes.push_back({{10.0, 25.0}, {10.0, 25.1}, {40.0, 25.1}, {40.0, 25.0}});
  const FreeSpace space = free_space(field, hull());
  const Pose over{{25.0, 24.5}, kPi / 2.0};
  EXPECT_FALSE(fits(space, over, 0.0));
  EXPECT_EQ(overrun(space, over).limit, Limit::kHole);
  EXPECT_GT(overrun(space, over).depth_m, 0.5);
}

// Grid maps put hulls on the borders of the cells in which edges are listed.
TEST(FreeSpace, PlacesOnBordersOfItsCellsAreInside) {
  Field field;
  field.boundary = {{-4.0, -4.0}, {20.0, -4.0}, {20.0, 22.0}, {-4.0, 22.0}};
  const FreeSpace space = free_space(field, hull());
  for (double x = -3.5; x < 20.0; x += space.cell_m) {
    for (double y = -3.5; y < 22.0; y += space.cell_m) {
      for (const double to : {-100.0, 100.0}) {
        const Vector2d beside(std::nextafter(x, to), std::nextafter(y, to));
        EXPECT_TRUE(inside(space, beside)) << x << ", " << y;
      }
    }
  }
  EXPECT_FALSE(inside(space, {20.1, 5.0}));
}

TEST(FreeSpace, RayMeetsTheFirstEdgeAhead) {
  Field field = square_field();
  field.holes.push_back({{20.0, 20.0}, {20.0, 30.0}, {30.0, 30.0}, {30.0, 20.0}});
  const FreeSpace space = free_space(field, hull());
  const EdgeAhead hole = edge_ahead(space, {5.0, 25.0}, 0.0);
  EXPECT_NEAR(hole.distance_m, 15.0, kRounding_m);
  EXPECT_NEAR((hole.outward - Vector2d(1.0, 0.0)).norm(), 0.0, kRounding_m);
  const EdgeAhead boundary = edge_ahead(space, {5.0, 25.0}, kPi);
  EXPECT_NEAR(boundary.distance_m, 5.0, kRounding_m);
  EXPECT_NEAR((boundary.outward - Vector2d(-1.0, 0.0)).norm(), 0.0, kRounding_m);
}

}  // namespace
}  // namespace headland
