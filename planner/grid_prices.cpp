#include "planner/grid_prices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/line_energy.h"

namespace headland {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;

// Slopes at which curves are compared: those that were measured, up and down.
std::vector<double> slopes_of(const SlopeCost& cost) {
  std::vector<double> slopes;
  for (const double slope : cost.slope) {
    if (slope != 0.0) slopes.push_back(std::abs(slope));
  }
  std::sort(slopes.begin(), slopes.end());
  slopes.erase(std::unique(slopes.begin(), slopes.end()), slopes.end());
  return slopes;
}

// What a metre takes on average, up and down the same slope, beyond a level one.
double more_on_slope(const SlopeCost& cost, double slope) {
  return 0.5 * (wh_per_m(cost, slope) + wh_per_m(cost, -slope)) - wh_per_m(cost, 0.0);
}

// Least squares through 0: W h a metre of climb_m, which is slope^2 / sqrt(1 + slope^2) a level
// metre.
double climb_price(const SlopeCost& cost) {
  double above = 0.0;
  double below = 0.0;
  for (const double slope : slopes_of(cost)) {
    const double climb = slope * slope / std::hypot(1.0, slope);
    above += climb * more_on_slope(cost, slope);
    below += climb * climb;
  }
  return below > 0.0 ? std::max(above / below, 0.0) : 0.0;
}

// Likewise W h a metre of height: what going up costs more than going down, which comes back.
double height_price(const SlopeCost& cost) {
  double above = 0.0;
  double below = 0.0;
  for (const double slope : slopes_of(cost)) {
    above += slope * 0.5 * (wh_per_m(cost, slope) - wh_per_m(cost, -slope));
    below += slope * slope;
  }
  return below > 0.0 ? above / below : 0.0;
}

// Rise over run from a node in a direction, over as many of the two steps beside it as there are.
double slope_through(const GridGraph& graph, int node, int direction) {
  const int ahead = at(at(graph.beside, node), direction);
  const int behind = at(at(graph.beside, node), opposite(direction));
  const double before_m = at(graph.height_m, behind < 0 ? node : behind);
  const double after_m = at(graph.height_m, ahead < 0 ? node : ahead);
  const int steps = (ahead < 0 ? 0 : 1) + (behind < 0 ? 0 : 1);
  return steps == 0 ? 0.0 : (after_m - before_m) / (steps * graph.cell_m);
}

// From the end of a row, worked to its last cell's edge, to the begin of the column beside that
// cell.
double corner_price(const DriveCost& cost, double cell_m) {
  const double reach_m = 0.5 * cell_m - cost.implement_x_m;
  const Pose row_end{{reach_m, 0.0}, 0.0};
  const Pose column_begin{{0.0, reach_m}, kQuarter_rad};
  return least_turn_wh(cost, nullptr, row_end, column_begin);
}

}  // namespace

GridPrices grid_prices(const DriveCost& cost, double cell_m) {
  GridPrices prices;
  const double working = wh_per_m(cost.working, 0.0);
  const double raised = wh_per_m(cost.raised, 0.0);
  prices.step = cell_m * raised;
  prices.cell = std::max(cell_m * (working - raised), 0.0);
  prices.turn = 0.5 * energy_wh(cost, cheapest_row_turn(cost, cell_m));
  prices.corner = corner_price(cost, cell_m);
  prices.u_turn = energy_wh(cost, cheapest_row_turn(cost, 0.0));
  prices.level_wh_per_m = working;
  prices.climb_wh_per_m = climb_price(cost.working);
  return prices;
}

std::vector<std::array<double, kDirections>> step_prices(const DriveCost& cost,
                                                         const GridGraph& graph) {
  const double level = wh_per_m(cost.raised, 0.0) - wh_per_m(cost.working, 0.0);
  const double height = height_price(cost.working);
  std::vector<std::array<double, kDirections>> prices(graph.cells.size());
  for (int node = 0; node < graph.size(); ++node) {
    for (int direction = 0; direction < kDirections; ++direction) {
      const int next = at(at(graph.beside, node), direction);
      if (next < 0) continue;
      double along = 0.0;
      double across = 0.0;
      if (!graph.height_m.empty()) {
        along = (at(graph.height_m, next) - at(graph.height_m, node)) / graph.cell_m;
        const int left = (direction + kDirections - 1) % kDirections;
        across = 0.5 * (slope_through(graph, node, left) + slope_through(graph, next, left));
      }
      const double slope = std::clamp(along, -kSteepest, kSteepest);
      const double per_m = level + wh_per_m(cost.working, slope, across) - height * slope;
      at(at(prices, node), direction) = std::max(graph.cell_m * per_m, 0.0);
    }
  }
  return prices;
}

}  // namespace headland
