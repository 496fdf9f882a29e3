// CCPP-TPLP: greedy beginnings by transition probability, then learning and perturbation.
#pragma once

#include <span>

#include "planner/order_population.h"

namespace headland {

std::span<const ParameterSpec> grid_tplp_parameters();

// Throws InputError(source, "where.share_2", ...) for shares that are all zero.
void check_grid_tplp(const Parameters& parameters, const std::string& source,
                     const std::string& where);

// Wang et al. 2025 (10.20944/preprints202504.0101.v1), sections 4.1 to 4.3.
// - Individuals are orders of all cells; their path is expanded(). They begin as greedy_order(),
//   Eqs (7) to (9).
// - Each iteration sorts best first. The best (POP1) is perturbed strongly (two cells change
//   places), POP2 learns from the best, POP3 from random individuals, POP4 is perturbed weakly (a
//   section is turned round); `share_2` to `share_4` are the sizes of the last three.
// Readings of what the paper leaves open: an iteration applies the operator at every place k in
// turn, and a change is kept unless it makes the path costlier; `rule` has others. All learn from
// orders as the iteration found them (Step 7), each of POP3 from one individual of them. Learning
// excludes x_k from the section that is turned round, else the learned pair would not become
// neighbours. The best individual is never made worse. Given start and end keep their places
// instead of being repaired. With alpha_g = 1 lambda has no effect; the paper's Table 4 varies it
// there. Throws InputError as grid_problem and distance_table, and for shares that are all zero;
// Cancelled.
GridPlan plan_grid_tplp(const GridPlanRequest& request);

// The learning perturbation operator by these parameters, for evolve() on a population of any
// origin. Throws InputError for shares that are all zero.
Improve learning_perturbation(const Parameters& parameters);

}  // namespace headland
