// The genetic algorithm with chromosome pairs, and what it is compared with.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_iga_parameters();
std::span<const ParameterSpec> grid_ga_parameters();

// Of both: throws InputError(source, "where.elites", ...) for more elites than individuals.
void check_grid_genetic(const Parameters& parameters, const std::string& source,
                        const std::string& where);

// Wu et al. 2023 (10.20944/preprints202305.1306.v1), section 2.2.
// - A chromosome X is an order of all cells, its partner Y the path adjusted() from it (2.2.1).
//   Fitness is taken from Y (Eq 1, fitness_of), evolution works on X.
// - Each generation keeps the `elites` best and fills up with children of parents drawn by
//   roulette (Eq 16): order-preserving crossover (2.2.4) with `crossover`, then mutation (2.2.5)
//   with `mutation`, each a probability.
// - Weights are those of the request, or adapted for each chromosome by Eqs (2) to (10) and
//   inherited from the first parent; plans are compared by the request's weights either way.
// Readings of what the paper leaves open or contradicts: mutation exchanges m random pairs, as its
// text says and its Figure 10 does not, m drawn from 1 to a tenth of the cells, or is 1 with
// `mutation_points` single (the paper's ablation, 3.2), as it always is in plan_grid_ga; crossover
// follows the rule, which its printed example does not; adapted weights start at the request's.
// Elites keep their weights. Counts, Eqs (11) to (15), are count_path's. The second stop rule, a
// fitness less than 0.001 from a target, is left out: no target is given. Given start and end keep
// their places. As described it does not reach the results printed. Throws InputError as
// grid_problem and distance_table, for more elites than individuals; Cancelled.
GridPlan plan_grid_iga(const GridPlanRequest& request);

// 3.3: one chromosome, driven as it is: moves between cells that are no neighbours are `jumps` of
// the plan, which nothing can drive. Fitness counts repeats, turns and U-turns of the single steps;
// a jump counts `jump_cost` (the paper does not say; without it random orders would be perfect).
GridPlan plan_grid_ga(const GridPlanRequest& request);

}  // namespace headland
