// What steps, turns and cells of a grid map take by measured costs.
#pragma once

#include <array>
#include <vector>

#include "planner/drive_cost.h"
#include "planner/grid_graph.h"

namespace headland {

// On cells of one size, as the plan is driven: straight runs with the implement down, turns between
// them with it raised, and what is worked already passed with it raised. W h, but for the last two.
struct GridPrices {
  double step = 0.0;    // on level ground, implement raised; a repeat is no more than that
  double cell = 0.0;    // working a cell instead of only crossing it
  double turn = 0.0;    // a right angle: half of the cheapest turn into the next row
  double corner = 0.0;  // a right angle by itself: the cheapest turn from a row into a column
  double u_turn = 0.0;  // turning back on the spot
  double level_wh_per_m = 0.0;  // the terms of Wang et al. 2025: of level_m,
  double climb_wh_per_m = 0.0;  // and of climb_m: what slopes add, up and down together
};
GridPrices grid_prices(const DriveCost& cost, double cell_m);

// What a step takes by node and direction: GridPrices::step on level ground, and more or less by
// what working costs along and across the slope there, its own height differences and those beside
// it. Directed: uphill is dearer than downhill. Only what climbing costs beyond what going down the
// same height brings back: heights are weighed so that any way down and up again costs what it
// does, and the height that the path's end lies above its begin is not counted. 0 or more.
std::vector<std::array<double, kDirections>> step_prices(const DriveCost& cost,
                                                         const GridGraph& graph);

}  // namespace headland
