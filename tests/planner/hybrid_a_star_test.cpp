#include "planner/hybrid_a_star.h"

#include <gtest/gtest.h>

#include <numbers>

#include "planner/connection.h"
#include "planner/tight_pose.h"
#include "planner/turns.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

constexpr double kEnd = 1e-6;  // m and rad

// A square field with a wall from the south side, 2 m thick, that leaves `gap_m` in the north.
Field walled(double side_m, double gap_m) {
  Field field;
  const double middle_m = 0.5 * side_m;
  field.boundary = {{0.0, 0.0},
                    {middle_m - 1.0, 0.0},
                    {middle_m - 1.0, side_m - gap_m},
                    {middle_m + 1.0, side_m - gap_m},
                    {middle_m + 1.0, 0.0},
                    {side_m, 0.0},
                    {side_m, side_m},
                    {0.0, side_m}};
  return field;
}

struct Scene {
  Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  FreeSpace space;
  RouteOptions options;
  explicit Scene(const Field& field) : space(free_space(field, hull_of(vehicle))) {
    options.radius_m = planning_turning_radius_m(vehicle);
    options.clearance_m = 0.1;
  }
};

void expect_drivable(const Scene& scene, const Pose& from, const Pose& to,
                     const std::vector<Arc>& arcs) {
  EXPECT_TRUE(fits_along(scene.space, from, arcs, scene.options.clearance_m));
  const Pose end = end_of(from, arcs);
  EXPECT_LT((end.p_W - to.p_W).norm(), kEnd);
  EXPECT_LT(std::abs(wrap_angle(end.heading_rad - to.heading_rad)), kEnd);
  for (const Arc& arc : arcs) {
    EXPECT_LE(std::abs(arc.curvature_per_m), 1.0 / scene.options.radius_m + kEnd);
  }
}

TEST(HybridAStar, GoesAroundAWall) {
  const Scene scene(walled(60.0, 10.0));
  const Pose from{{10.0, 10.0}, kPi / 2.0};
  const Pose to{{50.0, 10.0}, -kPi / 2.0};
  int expanded = 0;
  const auto route = find_route(scene.space, from, to, scene.options, &expanded);
  ASSERT_TRUE(route.has_value());
  expect_drivable(scene, from, to, *route);
  // The shortest way of a point: to the wall's corners, 50 m up, and back.
  const double shortest_m = 2.0 * std::hypot(19.0, 40.0) + 2.0;
  EXPECT_GT(length_m(*route), shortest_m);
  EXPECT_LT(length_m(*route), 1.15 * shortest_m) << "not a detour";
  EXPECT_EQ(cusp_count(*route), 0) << "there is room to stay in forward gear";
  EXPECT_LT(expanded, 2000);
}

TEST(HybridAStar, GoesStraightWhereNothingIsInTheWay) {
  const Scene scene(walled(60.0, 59.0));
  const Pose from{{5.0, 30.0}, 0.0};
  const Pose to{{55.0, 30.0}, 0.0};
  const auto route = find_route(scene.space, from, to, scene.options, nullptr);
  ASSERT_TRUE(route.has_value());
  EXPECT_NEAR(length_m(*route), 50.0, kEnd);
}

TEST(HybridAStar, SameInputSameRoute) {
  const Scene scene(walled(60.0, 8.0));
  const Pose from{{25.0, 10.0}, 0.0};
  const Pose to{{35.0, 12.0}, 0.3};
  const auto first = find_route(scene.space, from, to, scene.options, nullptr);
  const auto second = find_route(scene.space, from, to, scene.options, nullptr);
  ASSERT_TRUE(first.has_value() && second.has_value());
  ASSERT_EQ(first->size(), second->size());
  for (std::size_t i = 0; i < first->size(); ++i) {
    EXPECT_EQ((*first)[i].length_m, (*second)[i].length_m);
    EXPECT_EQ((*first)[i].curvature_per_m, (*second)[i].curvature_per_m);
  }
}

TEST(HybridAStar, ReversesOutOfADeadEnd) {
  // A lane 2.4 m wide and 20 m deep: too narrow to turn round in.
  Field field;
  field.boundary = {{0.0, 0.0},   {2.4, 0.0},    {2.4, 20.0},   {30.0, 20.0},
                    {30.0, 50.0}, {-30.0, 50.0}, {-30.0, 20.0}, {0.0, 20.0}};
  const Scene scene(field);
  const Pose from{{1.2, 3.0}, -kPi / 2.0};
  const Pose into{{1.2, 4.0}, -kPi / 2.0};
  ASSERT_FALSE(fits(scene.space, {{1.2, 2.0}, -kPi / 2.0}, 0.0)) << "the hull ends at the wall";
  const Pose to{{0.0, 40.0}, kPi / 2.0};
  const auto out = find_route(scene.space, into, to, scene.options, nullptr);
  ASSERT_TRUE(out.has_value());
  expect_drivable(scene, into, to, *out);
  EXPECT_EQ(out->front().gear, Gear::kReverse);
  EXPECT_GT(reverse_length_m(*out), 12.0);
  EXPECT_TRUE(find_route(scene.space, to, from, scene.options, nullptr).has_value());
}

// A bay as wide as the hull, with open ground before it: no step of the search ends straight in it.
TEST(HybridAStar, BacksIntoABayAsWideAsTheHull) {
  Field field;
  const Hull hull = hull_of(made_up_vehicle(2.6, 2.0));
  const double half_m = hull.half_width_m + 0.005;
  field.boundary = {{-half_m, 0.0}, {half_m, 0.0}, {half_m, 8.0}, {25.0, 8.0},
                    {25.0, 33.0},   {-25.0, 33.0}, {-25.0, 8.0},  {-half_m, 8.0}};
  Scene scene(field);
  scene.options.clearance_m = 0.0;
  scene.options.max_nodes = 2000;
  const Pose outside{{10.3, 20.2}, 0.7};
  const Pose bay{{0.0, 2.0}, kPi / 2.0};
  ASSERT_TRUE(fits(scene.space, bay, 0.0));
  ASSERT_FALSE(fits(scene.space, bay, kGateRoom_m));
  const auto in = find_route(scene.space, outside, bay, scene.options, nullptr);
  ASSERT_TRUE(in.has_value());
  expect_drivable(scene, outside, bay, *in);
  EXPECT_EQ(in->back().gear, Gear::kReverse);
  const auto out = find_route(scene.space, bay, outside, scene.options, nullptr);
  ASSERT_TRUE(out.has_value());
  expect_drivable(scene, bay, outside, *out);
  EXPECT_EQ(out->front().gear, Gear::kForward);
}

TEST(HybridAStar, SaysWhenThereIsNoWay) {
  const Scene scene(walled(60.0, 1.0));
  const Pose from{{10.0, 10.0}, kPi / 2.0};
  const Pose to{{50.0, 10.0}, -kPi / 2.0};
  int expanded = -1;
  EXPECT_FALSE(find_route(scene.space, from, to, scene.options, &expanded).has_value());
  EXPECT_EQ(expanded, 0) << "the grid already knows that a gap of 1 m is too narrow";
}

TEST(HybridAStar, StopsAtItsNodeLimit) {
  Scene scene(walled(60.0, 3.0));
  scene.options.max_nodes = 5;
  int expanded = 0;
  EXPECT_FALSE(
      find_route(scene.space, {{20.0, 5.0}, 0.0}, {{40.0, 5.0}, 0.0}, scene.options, &expanded)
          .has_value());
  EXPECT_EQ(expanded, 5);
}

}  // namespace
}  // namespace headland
