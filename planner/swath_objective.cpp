#include "planner/swath_objective.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

double swath_wh(const SwathGrid& grid, const Swath& swath, double most_step_m,
                const DriveCost& cost, const Heightfield* terrain) {
  const double length = swath.to_m - swath.from_m;
  if (terrain == nullptr) return length * wh_per_m(cost.working, 0.0);
  const Eigen::Vector2d along(std::cos(grid.direction_rad), std::sin(grid.direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const int steps = std::max(1, static_cast<int>(std::ceil(length / most_step_m)));
  double sum_wh_per_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d p_W =
        point_on_line(grid, swath.line, swath.from_m + length * (i + 0.5) / steps);
    const Eigen::Vector2d gradient = surface_at(*terrain, p_W.x(), p_W.y()).gradient;
    const double uphill = gradient.dot(along);
    const double sideways = gradient.dot(across);
    sum_wh_per_m += 0.5 * (wh_per_m(cost.working, uphill, sideways) +
                           wh_per_m(cost.working, -uphill, sideways));
  }
  return length * sum_wh_per_m / steps;
}

}  // namespace

SwathGridCost length_and_turns(double turn_m) {
  return [turn_m](const SwathGrid& grid) {
    return length_m(grid) + turn_m * static_cast<double>(grid.swaths.size());
  };
}

SwathGridCost fewest_turns() {
  return [](const SwathGrid& grid) {
    // No grid is so long that its length outweighs a turn.
    constexpr double kPerMetre = 1e-9;
    return static_cast<double>(grid.swaths.size()) + kPerMetre * length_m(grid);
  };
}

SwathGridCost least_length() {
  return [](const SwathGrid& grid) { return length_m(grid); };
}

SwathGridCost least_energy(const DriveCost& cost, const Heightfield* terrain) {
  return [&cost, terrain](const SwathGrid& grid) {
    const double step_m = std::max(kEnergyStep_m, length_m(grid) / kMostEnergySteps);
    const double turn_wh = energy_wh(cost, cheapest_row_turn(cost, grid.spacing_m));
    double sum_wh = turn_wh * static_cast<double>(grid.swaths.size());
    for (const Swath& swath : grid.swaths) sum_wh += swath_wh(grid, swath, step_m, cost, terrain);
    return sum_wh;
  };
}

}  // namespace headland
