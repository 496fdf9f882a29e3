#include "planner/headland_rings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/ring_smoothing.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

using std::numbers::pi;

// The filter shortens a corner by sigma^2 / (2 R^2) = 0.5 % of its arc, chords by less.
constexpr double kRingLengthRatio = 2e-3;
// Rings are rounded with 3 % more than the turning radius, see headland_rings.cpp.
constexpr double kCornerRounding = 1.03;

PlanRequest ring_request(const Field& field) { return tractor_request(field, "boustrophedon"); }

std::ptrdiff_t rings_of_round(const Headland& headland, int round) {
  return std::ranges::count(headland.rings, round, &HeadlandRing::round);
}

TEST(HeadlandRings, TurningDepthFollowsItsFormula) {
  const Field square = field_of("square", rectangle_ring(0, 0, 150, 150));
  // The implement reaches further than the hull's corner: 1.6 + 5 + 4.5, and the clearance.
  EXPECT_DOUBLE_EQ(turning_depth_m(ring_request(square)), 11.1 + 0.1);
  EXPECT_EQ(rounds_for_turning(ring_request(square)), 2);
  // The hull's front corner reaches further: 0.9 + hypot(2.6 + 0.6, 2.3).
  const PlanRequest narrow = transplanter_request(square, "boustrophedon");
  EXPECT_DOUBLE_EQ(turning_depth_m(narrow), 0.9 + std::hypot(3.2, 2.3) + 0.1);
  EXPECT_EQ(rounds_for_turning(narrow), 3);
}

TEST(HeadlandRings, FirstRoundKeepsTheSwingingFrontCornerInside) {
  PlanRequest request = ring_request(field_of("square", rectangle_ring(0, 0, 150, 150)));
  EXPECT_DOUBLE_EQ(first_round(request).distance_m, 4.5);  // the implement reaches further
  EXPECT_DOUBLE_EQ(first_round(request).radius_m, request.turning_radius_m);
  request.working_width_m = 1.5;
  const FirstRound round = first_round(request);
  EXPECT_DOUBLE_EQ(round.distance_m, std::hypot(round.radius_m + request.vehicle_width_m / 2.0,
                                                request.vehicle_front_m) -
                                         round.radius_m + request.clearance_m + kRingMargin_m);
  // Corners wider than the turning radius cut more off but keep the whole ring nearer.
  EXPECT_GT(round.radius_m, request.turning_radius_m);
  const Headland headland = make_headland(request, 2);
  EXPECT_DOUBLE_EQ(headland.width_m, round.distance_m + 1.5 + 0.75);
}

TEST(HeadlandRings, SquareHasRoundedSquaresOneWidthApart) {
  const Headland headland =
      make_headland(ring_request(field_of("s", rectangle_ring(0, 0, 150, 150))), 2);
  ASSERT_EQ(headland.rings.size(), 2U);
  EXPECT_DOUBLE_EQ(headland.width_m, 18.0);
  EXPECT_NEAR(area_m2(headland.inner), 114.0 * 114.0, 1e-3);
  for (int round = 0; round < 2; ++round) {
    const double side_m = 150.0 - 9.0 - 18.0 * round;
    const double radius_m = kCornerRounding * 5.0;
    const double expected_m = 4.0 * side_m - (8.0 - 2.0 * pi) * radius_m;
    EXPECT_NEAR(length_m(headland.rings[static_cast<std::size_t>(round)].line_W), expected_m,
                kRingLengthRatio * expected_m);
  }
}

TEST(HeadlandRings, RoundHoleIsGoneAroundAtConstantDistance) {
  Field field = field_of("holed", rectangle_ring(-100, -100, 100, 100));
  field.holes = {reversed(regular_ring({0, 0}, 20.0, 128))};
  const Headland headland = make_headland(ring_request(field), 1);
  const auto ring = std::ranges::find(headland.rings, true, &HeadlandRing::around_hole);
  ASSERT_NE(ring, headland.rings.end());
  for (const Eigen::Vector2d& p_W : ring->line_W) {
    EXPECT_NEAR(p_W.norm(), 24.5, 0.01 * 5.0);  // rounding: 1 % of the radius
  }
}

TEST(HeadlandRings, TreeThinnerThanTheTurningCircleIsGoneAroundOnThatCircle) {
  Field field = field_of("tree", rectangle_ring(-60, -60, 60, 60));
  field.obstacles = {{ObstacleKind::kTree, {0, 0}, 0.3, 5.0}};
  const PlanRequest request = transplanter_request(field, "boustrophedon");
  const Headland headland = make_headland(request, 1);
  const auto ring = std::ranges::find(headland.rings, true, &HeadlandRing::around_hole);
  ASSERT_NE(ring, headland.rings.end());
  for (const Eigen::Vector2d& p_W : ring->line_W) {
    EXPECT_GE(p_W.norm(), request.turning_radius_m);
    EXPECT_LE(p_W.norm(), 1.1 * kCornerRounding * request.turning_radius_m);
  }
}

// At a corner that sticks into the field the arc of half the working width is too tight: the ring
// swings out there, and only there.
TEST(HeadlandRings, RingSwingsOutAtACornerIntoTheField) {
  const Field field = field_of("l", {{0, 0}, {100, 0}, {100, 50}, {50, 50}, {50, 100}, {0, 100}});
  const PlanRequest request = transplanter_request(field, "boustrophedon");
  const Headland headland = make_headland(request, 1);
  ASSERT_EQ(headland.rings.size(), 1U);
  EXPECT_GE(tightest_radius_m(headland.rings[0].line_W, 0.5), request.turning_radius_m);
  const double distance_m = first_round(request).distance_m;
  double nearest_m = 100.0;
  for (const Eigen::Vector2d& p_W : headland.rings[0].line_W) {
    const double clearance_m = field_clearance_m(field, p_W);
    nearest_m = std::min(nearest_m, clearance_m);
    // 10 m from any corner the side's distance is as if there were none; filter and rounding in mm.
    const bool straight = p_W.x() > 62.0 && p_W.x() < 90.0 && p_W.y() > 25.0;
    if (straight) {
      EXPECT_NEAR(clearance_m, distance_m, 0.01);
    }
  }
  EXPECT_GE(nearest_m, distance_m - 0.035 * request.turning_radius_m);
}

TEST(HeadlandRings, RoundsSplitWhereTheGroundIsNarrow) {
  // Two squares joined by a passage of 26 m: the second round is 27 m narrower than the ground.
  const Field field = field_of("neck", {{0, 0},
                                        {100, 0},
                                        {100, 37},
                                        {140, 37},
                                        {140, 0},
                                        {240, 0},
                                        {240, 100},
                                        {140, 100},
                                        {140, 63},
                                        {100, 63},
                                        {100, 100},
                                        {0, 100}});
  const Headland headland = make_headland(ring_request(field), 2);
  EXPECT_EQ(rings_of_round(headland, 0), 1);
  EXPECT_EQ(rings_of_round(headland, 1), 2);
}

TEST(HeadlandRings, RoundsOfAHoleNearTheBoundaryBecomeOneAroundBoth) {
  Field field = field_of("near", rectangle_ring(0, 0, 150, 150));
  field.holes = {reversed(rectangle_ring(60, 115, 90, 130))};
  const Headland headland = make_headland(ring_request(field), 2);
  EXPECT_EQ(rings_of_round(headland, 0), 2);
  EXPECT_EQ(rings_of_round(headland, 1), 1);
}

TEST(HeadlandRings, GroundNoRoundReachesIsLeftToSwaths) {
  // 24 m wide: one round takes 18 m, a second one would be 3 m from itself.
  const Headland headland =
      make_headland(ring_request(field_of("t", rectangle_ring(0, 0, 240, 24))), 2);
  EXPECT_EQ(headland.rings.size(), 1U);
  // 6 m by 222 m inside the first round, less what its arcs cut.
  EXPECT_NEAR(area_m2(headland.inner), 6.0 * 222.0, 0.01 * 6.0 * 222.0);
}

TEST(HeadlandRings, TooNarrowForTheTurningRadiusSaysWhatWidthItTakes) {
  try {
    make_headland(ring_request(field_of("lane", rectangle_ring(0, 0, 240, 16))), 1);
    FAIL() << "not refused";
  } catch (const PlanInfeasible& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the turning radius fits nowhere"));
    EXPECT_THAT(error.what(), testing::HasSubstr("ground 19.3 m wide"));
  }
}

TEST(RingSmoothing, CircleKeepsItsRadiusButForTheFilter) {
  const double radius_m = 6.0;
  const double sigma_m = 0.6;
  const Polyline smooth = smoothed_ring(regular_ring({10, -5}, radius_m, 400), sigma_m);
  EXPECT_EQ(smooth.front(), smooth.back());
  const double shrunk_m = radius_m * std::exp(-sigma_m * sigma_m / (2.0 * radius_m * radius_m));
  for (const Eigen::Vector2d& p_W : smooth) {
    EXPECT_NEAR((p_W - Eigen::Vector2d(10, -5)).norm(), shrunk_m, 2e-3);  // chords of 0.25 m
  }
  EXPECT_NEAR(tightest_radius_m(smooth, 1.0), shrunk_m, 2e-3 * radius_m);
}

// Negative control: a ring with a sharp corner must not pass as drivable.
TEST(RingSmoothing, TightestRadiusSeesASharpCorner) {
  const Polyline square = smoothed_ring(rectangle_ring(0, 0, 50, 50), 0.05);
  EXPECT_LT(tightest_radius_m(square, 1.0), 1.5);
}

// Ground around holes that closing comes too near to is looked at place by place.
TEST(RingSmoothing, SwingsOutAroundEveryHoleAsAroundOneAlone) {
  const auto lost_m2 = [](int holes) {
    Field field = field_of("holes", rectangle_ring(0, 0, 400, 60));
    for (int i = 0; i < holes; ++i) {
      const double x_m = 30.0 + 45.0 * i;
      field.holes.push_back(  // clockwise
          {{x_m, 30.0}, {x_m, 32.0}, {x_m + 1.0, 32.0}, {x_m + 1.0, 30.0}});
    }
    const PolygonSet limit = from_field(field);
    const PolygonSet ground = buffered(limit, -2.0, Join::kMitre);
    const PolygonSet passed = passable(ground, {6.0, 6.0, limit, 2.0});
    EXPECT_EQ(passed.parts.size(), 1U);
    return 400.0 * 60.0 - area_m2(passed);
  };
  const double none_m2 = lost_m2(0);
  const double one_m2 = lost_m2(1) - none_m2;
  EXPECT_GT(one_m2, pi * 2.0 * 2.0);
  constexpr double kChords_m2 = 0.01;
  EXPECT_NEAR(lost_m2(8) - none_m2, 8.0 * one_m2, 8.0 * kChords_m2);
}

}  // namespace
}  // namespace headland
