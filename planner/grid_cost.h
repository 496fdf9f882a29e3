// What grid planners minimise.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "planner/drive_cost.h"
#include "planner/grid_graph.h"
#include "planner/grid_path.h"

namespace headland {

enum class GridObjective {
  kLength,    // steps; Wang et al. 2025, Eq (2)
  kWeighted,  // repeats, turns and U-turns; Wu et al. 2023, Eq (1)
  kTractor,   // energy by Wang et al. 2025, Eqs (12) to (21)
  kMeasured   // energy by measured costs, see grid_prices.h
};

// "length", "weighted", "tractor", "measured".
std::string_view grid_objective_name(GridObjective objective);

// Wu et al. 2023. The paper's 3.1 has 0.3 / 0.5 / 0.2, a slip: its fitness values are those of
// 2.2.2, as here.
struct GridWeights {
  double repeat = 0.3;
  double turn = 0.2;
  double u_turn = 0.5;
};

// Wang et al. 2025, 5.4.3, as printed there. `turn_current` in A, of which the paper's U I t1 makes
// an energy in W h: its Table 9 fits 50 / 3600 A h a second. Slopes are those of the steps, not of
// a cell's height (Eq 15), and the sums run over steps. A U-turn counts as two turns: t1 (Eq 19) is
// the time of a quarter circle.
struct TractorEnergy {
  double mass_kg = 0.5;
  double friction = 0.25;
  double gravity_m_s2 = 9.8;
  double turn_speed_m_s = 0.8;
  double voltage_v = 46.2;
  double turn_current_a = 50.0;
  double length_weight = 0.5;
  double height_weight = 0.25;
  double turn_weight = 0.25;
};

struct GridCost {
  GridObjective objective = GridObjective::kLength;
  GridWeights weights;
  TractorEnergy tractor;
  // What kMeasured counts by. Where it is given, the terms of kWeighted and kTractor take their
  // measured values in W h instead of weights and quantities: the two papers' terms, and no others.
  std::optional<DriveCost> measured;
};

// What a repeat, a turn and a U-turn weigh: as given, or their measured values.
GridWeights weights_of(const GridCost& cost, double cell_m);

// Throws InputError(source, "where. ...") for weights that are negative, not finite or all zero,
// for quantities of the tractor that are not positive, and for kMeasured without measured costs.
void check_grid_cost(const GridCost& cost, const std::string& source, const std::string& where);

// The same as shares: cost = constant + steps * step + level_m * level + climb_m * climb + turns *
// turn + u_turns * u_turn + row_changes * row_change. Where the graph has step_wh their sum stands
// for steps * step, and step is the least of them.
struct CostShares {
  double constant = 0.0;
  double step = 0.0;
  double level = 0.0;  // 0 unless steps differ in slope
  double climb = 0.0;
  double turn = 0.0;
  double u_turn = 0.0;
  double row_change = 0.0;  // 0 or less: what the second of two turns into the next row saves
};
CostShares cost_shares(const GridCost& cost, const GridGraph& graph);

// Of a path that visits every cell, from its counts and the side of a cell.
double cost_of(const GridCost& cost, const GridCounts& counts, double cell_m);

// 1 / cost, Eq (1) of Wu et al. and (21) of Wang et al.; a path that costs less than kLeastCost,
// for which they divide by zero, has the fitness of that.
double fitness_of(double cost);
inline constexpr double kLeastCost = 1e-3;

}  // namespace headland
