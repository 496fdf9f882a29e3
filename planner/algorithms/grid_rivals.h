// The four population algorithms that CCPP-TPLP is compared with, made to work on orders of cells.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

// Wang et al. 2025 (10.20944/preprints202504.0101.v1), Table 1, gives these algorithms' parameters
// and says nothing about how they act on orders. Ours act like CCPP-TPLP does, so that they differ
// in who learns from whom and not in the budget: orders begin as greedy_order(), and an iteration
// tries one change at every place of every order - learn, perturb_weakly, or one of swap, shift and
// symmetry - and keeps it unless it costs more. All throw InputError as grid_problem and
// distance_table; Cancelled.

std::span<const ParameterSpec> grid_gwo_parameters();
std::span<const ParameterSpec> grid_spbo_parameters();
std::span<const ParameterSpec> grid_djaya_parameters();
std::span<const ParameterSpec> grid_dtsa_parameters();

// Grey wolf optimizer (Mirjalili, Mirjalili, Lewis 2014). a falls from 2 to 0 over the search
// (share_over); at each place A = a (2 r - 1) is drawn. |A| < 1 attacks: learns from one of the
// three best, each as likely; else searches: is perturbed weakly.
GridPlan plan_grid_gwo(const GridPlanRequest& request);

// Student psychology based optimization (Das, Mukherjee, Das 2020). Sorted into four groups as
// equal as can be (1:1:1:1): the best students learn from any, good ones from the best, average
// ones from any that is better, the others are perturbed weakly.
GridPlan plan_grid_spbo(const GridPlanRequest& request);

// Discrete Jaya (Gunduz, Aslan 2021), for which going to the best and away from the worst is made
// of transformations. With probability st1 learns from the best; with probability st2, or where the
// pair at the place is one of the worst's too, a transformation is tried: swap, shift or symmetry
// by the probabilities given.
GridPlan plan_grid_djaya(const GridPlanRequest& request);

// Discrete tree-seed algorithm (Cinar, Korkmaz, Kiran 2020). At each place a seed comes with
// probability st1 from the best tree, else from any tree (learn); then, with probability st2, from
// the tree itself by swap, shift or symmetry.
GridPlan plan_grid_dtsa(const GridPlanRequest& request);

}  // namespace headland
