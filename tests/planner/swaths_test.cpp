#include "planner/swaths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "planner/swath_objective.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

using std::numbers::pi;

// Millimetres at the bands' edges (see kBandEdge in swaths.cpp).
constexpr double kEdge_m = 2e-3;

PolygonSet swath_ground(const Ring& outer) { return {{PolygonPart{outer, {}}}}; }

SwathGrid lay(const PolygonSet& inner, double direction_rad, double width_m) {
  return lay_swaths({inner, inner}, direction_rad, width_m, 0.0);
}

PolygonSet strips(const SwathGrid& grid, double width_m) {
  std::vector<PolygonSet> sets;
  for (const Swath& swath : grid.swaths) {
    sets.push_back(strip({point_on_line(grid, swath.line, swath.from_m),
                          point_on_line(grid, swath.line, swath.to_m)},
                         width_m));
  }
  return united(sets);
}

TEST(Swaths, RectangleIsLaidOutEvenly) {
  const SwathGrid grid = lay(swath_ground(rectangle_ring(10, 20, 110, 60)), 0.0, 9.0);
  EXPECT_EQ(grid.lines, 5);  // 40 m / 9 m, rounded up
  EXPECT_NEAR(grid.spacing_m, 8.0, 1e-12);
  ASSERT_EQ(grid.swaths.size(), 5U);
  EXPECT_NEAR(length_m(grid), 5.0 * 100.0, 1e-9);
  EXPECT_TRUE(point_on_line(grid, 0, grid.swaths[0].from_m).isApprox(Eigen::Vector2d(10, 24)));
}

TEST(Swaths, WidthThatFitsExactlyNeedsNoExtraLine) {
  EXPECT_EQ(lay(swath_ground(rectangle_ring(0, 0, 100, 36)), 0.0, 9.0).lines, 4);
  EXPECT_EQ(lay(swath_ground(rectangle_ring(0, 0, 100, 36.1)), 0.0, 9.0).lines, 5);
}

TEST(Swaths, SlantedEndsAreReachedByTheWholeWidth) {
  // Ends at 45 degrees: a strip of 8 m reaches 8 m further than a line of no width would.
  const SwathGrid grid = lay(swath_ground({{0, 0}, {100, 0}, {140, 40}, {40, 40}}), 0.0, 8.0);
  ASSERT_EQ(grid.swaths.size(), 5U);
  for (const Swath& swath : grid.swaths) {
    EXPECT_NEAR(swath.from_m, 8.0 * swath.line, kEdge_m);
    EXPECT_NEAR(swath.to_m, 100.0 + 8.0 * (swath.line + 1), kEdge_m);
  }
}

TEST(Swaths, HoleSplitsTheLinesThatMeetIt) {
  PolygonSet inner = swath_ground(rectangle_ring(0, 0, 100, 40));
  inner.parts[0].holes = {reversed(rectangle_ring(40, 15, 60, 25))};
  const SwathGrid grid = lay(inner, 0.0, 10.0);
  // Lines at 5, 15, 25, 35: a hole from 15 to 25 takes half of both middle strips, so both keep
  // ground beside it all along and none is split; a hole through a whole strip splits it.
  EXPECT_EQ(grid.swaths.size(), 4U);
  inner.parts[0].holes = {reversed(rectangle_ring(40, 10, 60, 20))};
  EXPECT_EQ(lay(inner, 0.0, 10.0).swaths.size(), 5U);
}

TEST(Swaths, ShortGapsThatCanBeDrivenAreBridged) {
  PolygonSet inner = swath_ground(rectangle_ring(0, 0, 100, 10));
  inner.parts.push_back(inner.parts[0]);
  for (Eigen::Vector2d& p_W : inner.parts[1].outer) p_W.x() += 105.0;
  const PolygonSet open = swath_ground(rectangle_ring(-5, -5, 210, 15));
  EXPECT_EQ(lay_swaths({inner, open}, 0.0, 10.0, 6.0).swaths.size(), 1U);
  EXPECT_EQ(lay_swaths({inner, open}, 0.0, 10.0, 4.0).swaths.size(), 2U);
  EXPECT_EQ(lay_swaths({inner, inner}, 0.0, 10.0, 6.0).swaths.size(), 2U) << "not drivable";
}

TEST(Swaths, StripsCoverAnyGroundInAnyDirection) {
  rc::check("ground minus strips is empty", [] {
    const auto in_range = [](int low, int high) { return *rc::gen::inRange(low, high) / 10.0; };
    PolygonSet inner =
        swath_ground(regular_ring({0, 0}, in_range(200, 900), *rc::gen::inRange(3, 9)));
    const double hole_m = in_range(10, 80);
    inner = difference(inner, swath_ground(regular_ring({in_range(-30, 30), 2.0}, hole_m, 5)));
    const double width_m = in_range(15, 120);
    const double direction_rad = *rc::gen::inRange(0, 3140) / 1000.0;
    const SwathGrid grid = lay(inner, direction_rad, width_m);
    const double missed_m2 = area_m2(difference(inner, strips(grid, width_m)));
    // A band's edge that no neighbour reaches, at most along each line.
    RC_ASSERT(missed_m2 <= kEdge_m * 180.0);
  });
}

TEST(Swaths, BestDirectionOfARectangleIsItsLongSide) {
  const Field field = moved(field_of("r", rectangle_ring(0, 0, 200, 70)), 0.47, {30.0, -12.0});
  const PolygonSet inner = from_field(field);
  const SwathGrid grid =
      best_swaths(field, {inner, inner}, 9.0, 0.0, length_and_turns(turn_length_m(9.0, 5.0)));
  EXPECT_NEAR(grid.direction_rad, 0.47, 1e-9);
  EXPECT_EQ(grid.lines, 8);
}

TEST(Swaths, BestDirectionBeatsEveryOtherByItsOwnCost) {
  const Field field = field_shapes()[3];
  const PolygonSet inner = from_field(field);
  const double turn_m = turn_length_m(9.0, 5.0);
  const auto cost_m = [&](const SwathGrid& grid) {
    return length_m(grid) + turn_m * static_cast<double>(grid.swaths.size());
  };
  const double best_m = cost_m(best_swaths(field, {inner, inner}, 9.0, turn_m, cost_m));
  // The grid of directions tried turns with the field; between two of its steps the cost may be
  // lower by the part of a swath that half a degree saves.
  for (double angle_rad = 0.0; angle_rad < pi; angle_rad += 0.05) {
    EXPECT_LE(best_m, 1.005 * cost_m(lay_swaths({inner, inner}, angle_rad, 9.0, turn_m)));
  }
}

TEST(Swaths, TurnLengthIsTheUTurnOrTheThreePointTurn) {
  EXPECT_NEAR(turn_length_m(12.0, 5.0), 2.0 + 5.0 * pi, 1e-12);  // two quarters and 2 m between
  EXPECT_NEAR(turn_length_m(2.0, 2.6), 2.6 * pi + 5.2 - 2.0, 1e-12);
  EXPECT_NEAR(turn_length_m(10.0, 5.0), 5.0 * pi, 1e-12) << "half a circle either way";
}

TEST(Swaths, TooManyAreRefused) {
  try {
    lay(swath_ground(rectangle_ring(0, 0, 1000, 1000)), 0.0, 0.01);
    FAIL() << "not refused";
  } catch (const PlanInfeasible& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("0.01 m needs 100000 swaths"));
    EXPECT_THAT(error.what(), testing::HasSubstr("at most 20000"));
  }
}

}  // namespace
}  // namespace headland
