#include "planner/swath_objective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

PolygonSet ground_of(const Field& field) { return from_field(field); }

SwathGrid best(const Field& field, double width_m, const SwathGridCost& cost) {
  const PolygonSet ground = ground_of(field);
  return best_swaths(field, {ground, ground}, width_m, 0.0, cost);
}

// A plane that rises to the east by `slope`.
Heightfield rising_east(double slope) {
  Heightfield terrain;
  terrain.origin_W = {-10.0, -10.0};
  terrain.cell_m = 10.0;
  terrain.columns = 30;
  terrain.rows = 30;
  for (int row = 0; row < terrain.rows; ++row) {
    for (int column = 0; column < terrain.columns; ++column) {
      terrain.height_m.push_back(slope * 10.0 * column);
    }
  }
  return terrain;
}

// 200 m x 60 m: 10 swaths of 6 m along it, 34 across.
TEST(SwathObjective, FewestTurnsGoAlongTheLongSide) {
  const Field field = field_of("long", rectangle_ring(0, 0, 200, 60));
  const SwathGrid grid = best(field, 6.0, fewest_turns());
  EXPECT_EQ(grid.swaths.size(), 10U);
  EXPECT_NEAR(std::sin(grid.direction_rad), 0.0, 1e-9);
}

// 100 m x 31 m: 6 swaths of 6 m along it work 5 m of 36 m twice, 17 across it 2 m of 102 m.
TEST(SwathObjective, LeastLengthWorksLeastGroundTwice) {
  const Field field = field_of("strip", rectangle_ring(0, 0, 100, 31));
  const SwathGrid shortest = best(field, 6.0, least_length());
  const SwathGrid fewest = best(field, 6.0, fewest_turns());
  EXPECT_EQ(shortest.swaths.size(), 17U);
  EXPECT_NEAR(length_m(shortest), 17.0 * 31.0, 1e-6);
  EXPECT_EQ(fewest.swaths.size(), 6U);
  EXPECT_NEAR(length_m(fewest), 6.0 * 100.0, 1e-6);
  EXPECT_LT(length_m(shortest), length_m(fewest));
  // No swaths are shorter than the ground is large.
  EXPECT_GE(length_m(shortest) * 6.0, area_m2(ground_of(field)));
}

// On a square all else is the same: up and down a slope takes more than level along it, as far as a
// side slope is not dearer still.
TEST(SwathObjective, LeastEnergyGoesAlongTheContours) {
  const Field field = field_of("square", rectangle_ring(0, 0, 120, 120));
  DriveCost cost = made_up_cost();
  cost.working.across_wh_per_m = 0.0;
  const Heightfield terrain = rising_east(0.1);
  const SwathGrid level = best(field, 6.0, least_energy(cost, &terrain));
  EXPECT_NEAR(std::cos(level.direction_rad), 0.0, 1e-9);
  cost.working.across_wh_per_m = 100.0;  // where a side slope is what costs
  const SwathGrid uphill = best(field, 6.0, least_energy(cost, &terrain));
  EXPECT_NEAR(std::sin(uphill.direction_rad), 0.0, 1e-9);
}

// 20 swaths of 120 m up a slope of 0.1 and down it again: 1.8 and 0.4 Wh/m in turn, and 20 turns.
TEST(SwathObjective, EnergyIsWhatTheTableSays) {
  DriveCost cost = made_up_cost();
  cost.working.across_wh_per_m = 0.0;
  const Heightfield terrain = rising_east(0.1);
  const PolygonSet ground = ground_of(field_of("square", rectangle_ring(0, 0, 120, 120)));
  const SwathGrid grid = lay_swaths({ground, ground}, 0.0, 6.0, 0.0);
  const double turn_wh = energy_wh(cost, cheapest_row_turn(cost, 6.0));
  EXPECT_NEAR(least_energy(cost, &terrain)(grid), 20.0 * (120.0 * 1.1 + turn_wh), 1e-3);
  EXPECT_NEAR(least_energy(cost, nullptr)(grid), 20.0 * (120.0 * 1.0 + turn_wh), 1e-9);
}

}  // namespace
}  // namespace headland
