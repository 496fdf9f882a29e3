// Ant colony optimization.
#pragma once

#include <span>
#include <vector>

#include "planner/order_task.h"

namespace headland {

std::span<const ParameterSpec> grid_aco_parameters();

// The ant system (Dorigo, Maniezzo, Colorni 1996) with the parameters of Wang et al. 2025
// (10.20944/preprints202504.0101.v1), Table 1: each ant goes to one of the cells not yet visited by
// tau^alpha / d^beta; then pheromone evaporates by `evaporation`, and every ant lays
// `enhancement` / cost on the pairs of its order. Table 1's 'pheromone heuristic factor 0.1', its
// second of the name, is read as evaporation.
// Deviations: an ant chooses among cells at most kAntSteps steps away and goes to a nearest one
// when there is none - with beta = 5 all others together have a share of a few percent - so that no
// table of pheromone over all pairs is needed; pheromone begins at 1.
// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_grid_aco(const GridPlanRequest& request);

inline constexpr int kAntSteps = 3;

// The orders that the first ants find, all pheromone being the same: the paper's second way to
// begin, Table 2. As many as `ants` says.
std::vector<std::vector<int>> first_ants(OrderTask& task, const Parameters& parameters);

// What the colony makes of orders of any origin, of which there is at least one: they lay their
// pheromone, then as many ants run until the task's search ends. The best order of all.
std::vector<int> best_of_ants(OrderTask& task, const Parameters& parameters,
                              const std::vector<std::vector<int>>& first);

}  // namespace headland
