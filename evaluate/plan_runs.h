// Driven plans on grid maps as a store of runs has them, and what energy models make of them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/sweep.h"
#include "planner/grid_cost.h"
#include "planner/grid_path.h"
#include "planner/path_energy.h"

namespace headland {

// One run of a sweep. Where `fault` says why there are none, figures are 0 or NaN.
struct PlanRun {
  std::string block;   // field, terrain, soil, seed: what plans are compared on
  std::string method;  // the planner's label
  std::size_t place = 0;
  std::string fault;   // no plan, not finished, no finite energy; empty: driven to its end
  bool jumps = false;  // the plan has moves that its counts do not tell of
  GridCounts counts;
  double cell_m = 0.0;
  double predicted_wh = 0.0;  // by measured costs; NaN: not told
  std::array<double, kPredictedKinds> predicted_kind_wh{};
  double energy_wh = 0.0;
  double energy_wh_per_ha = 0.0;
  double time_s = 0.0;
  double delta_soc = 0.0;
  double coverage_ratio = 0.0;
};

// Every run of the sweep, in its order. Throws InputError as the store does.
std::vector<PlanRun> plan_runs(const Sweep& sweep, RunStore& store);

// The energy models whose coefficients are fitted: the fitnesses of three papers (length: Wang et
// al. 2025, 2.3, and the third paper's) and headland's measured costs.
std::vector<std::string> energy_terms(GridObjective form);

// What each term of a plan is, such that coefficients times terms is an energy in W h: of
// `weighted` free cells, repeats, turns, U-turns; of `tractor` the paper's three sums with weights
// of 1; of `length` steps; of `measured` the predicted W h of each kind of movement.
std::vector<double> energy_terms_of(GridObjective form, const PlanRun& plan);

// What the form's printed weights make of the plan: the fitness's denominator; of `measured` the
// predicted W h.
double printed_cost_of(GridObjective form, const PlanRun& plan);

}  // namespace headland
