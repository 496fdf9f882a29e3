#include "terrains/field.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_ring.h"

namespace headland {
namespace {

// Coordinates up to 1e6 m carry 1e-10 m of rounding; areas up to 1e4 m2 then about 1e-6 m2.
constexpr double kRounding_m2 = 1e-5;
constexpr double kRounding_m = 1e-9;

Ring square_ring(double left, double bottom, double side) {
  return {
      {left, bottom}, {left + side, bottom}, {left + side, bottom + side}, {left, bottom + side}};
}

Ring clockwise(Ring ring) {
  std::ranges::reverse(ring);
  return ring;
}

Field square_with_hole() {
  Field field;
  field.boundary = square_ring(0.0, 0.0, 100.0);
  field.holes = {clockwise(square_ring(40.0, 40.0, 20.0))};
  return field;
}

// Another method: the angle that the ring turns around the point.
bool wound_around(const Ring& ring, const Eigen::Vector2d& p_W) {
  double turned_rad = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - p_W;
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - p_W;
    turned_rad += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned_rad) > std::numbers::pi;
}

TEST(Field, AreaOfASquareWithAHole) {
  EXPECT_DOUBLE_EQ(signed_area_m2(square_ring(0.0, 0.0, 100.0)), 1e4);
  EXPECT_DOUBLE_EQ(field_area_m2(square_with_hole()), 1e4 - 400.0);
}

TEST(Field, AreaOfDegenerateRingsIsZero) {
  EXPECT_EQ(signed_area_m2({}), 0.0);
  EXPECT_EQ(signed_area_m2({{1.0, 1.0}, {2.0, 2.0}}), 0.0);
}

TEST(Field, ReversingARingNegatesItsArea) {
  EXPECT_TRUE(rc::check([] {
    const Ring ring = any_ring();
    RC_ASSERT(signed_area_m2(ring) > 0.0);
    RC_ASSERT(std::abs(signed_area_m2(ring) + signed_area_m2(clockwise(ring))) < kRounding_m2);
  }));
}

TEST(Field, AreaStaysWhenTheFieldMovesAndTurns) {
  EXPECT_TRUE(rc::check([] {
    const Ring ring = any_ring();
    const Eigen::Vector2d shift(any_number(-1e6, 1e6), any_number(-1e6, 1e6));
    const Eigen::Rotation2D<double> turn(any_number(0.0, 6.0));
    Ring moved;
    for (const Eigen::Vector2d& p_W : ring) moved.push_back(turn * p_W + shift);
    RC_ASSERT(std::abs(signed_area_m2(ring) - signed_area_m2(moved)) < kRounding_m2);
  }));
}

TEST(Field, InsideAgreesWithTheWindingNumber) {
  EXPECT_TRUE(rc::check([] {
    Field field;
    field.boundary = any_ring();
    const Eigen::Vector2d p_W(any_number(-110.0, 110.0), any_number(-110.0, 110.0));
    RC_ASSERT(inside_field(field, p_W) == wound_around(field.boundary, p_W));
  }));
}

TEST(Field, HoleIsOutside) {
  const Field field = square_with_hole();
  EXPECT_TRUE(inside_field(field, {20.0, 50.0}));
  EXPECT_FALSE(inside_field(field, {50.0, 50.0}));
  EXPECT_FALSE(inside_field(field, {-1.0, 50.0}));
}

TEST(Field, InsideHoldsLevelWithAVertex) {
  // The horizontal ray passes exactly through corners of the diamond.
  Field field;
  field.boundary = {{0.0, -10.0}, {10.0, 0.0}, {0.0, 10.0}, {-10.0, 0.0}};
  EXPECT_TRUE(inside_field(field, {0.0, 0.0}));
  EXPECT_FALSE(inside_field(field, {-11.0, 0.0}));
  EXPECT_FALSE(inside_field(field, {-5.0, 10.0}));
}

TEST(Field, ClearanceOfASquareWithAHole) {
  const Field field = square_with_hole();
  EXPECT_DOUBLE_EQ(field_clearance_m(field, {10.0, 50.0}), 10.0);
  EXPECT_DOUBLE_EQ(field_clearance_m(field, {35.0, 50.0}), 5.0);
  EXPECT_DOUBLE_EQ(field_clearance_m(field, {45.0, 50.0}), -5.0);
  EXPECT_DOUBLE_EQ(field_clearance_m(field, {-3.0, -4.0}), -5.0);
}

TEST(Field, ClearanceIsTheNearestOfDenseEdgePoints) {
  EXPECT_TRUE(rc::check([] {
    constexpr int kSteps = 400;
    Field field;
    field.boundary = any_ring();
    const Eigen::Vector2d p_W(any_number(-110.0, 110.0), any_number(-110.0, 110.0));
    double nearest_m = 1e9;
    double longest_step_m = 0.0;
    for (std::size_t i = 0; i < field.boundary.size(); ++i) {
      const Eigen::Vector2d a = field.boundary[i];
      const Eigen::Vector2d edge = field.boundary[(i + 1) % field.boundary.size()] - a;
      longest_step_m = std::max(longest_step_m, edge.norm() / kSteps);
      for (int step = 0; step < kSteps; ++step) {
        nearest_m = std::min(nearest_m, (a + edge * step / kSteps - p_W).norm());
      }
    }
    const double clearance_m = field_clearance_m(field, p_W);
    RC_ASSERT(std::abs(clearance_m) <= nearest_m + kRounding_m);
    RC_ASSERT(std::abs(clearance_m) >= nearest_m - longest_step_m);
    RC_ASSERT((clearance_m > 0.0) == inside_field(field, p_W));
  }));
}

TEST(Field, ObstacleKindsHaveNames) {
  EXPECT_EQ(obstacle_kind_name(ObstacleKind::kTree), "tree");
  EXPECT_EQ(obstacle_kind_name(ObstacleKind::kPole), "pole");
  EXPECT_EQ(obstacle_kind_name(ObstacleKind::kRock), "rock");
}

}  // namespace
}  // namespace headland
