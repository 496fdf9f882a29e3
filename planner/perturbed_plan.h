// Plans made from a plan by random changes of its order.
#pragma once

#include <cstdint>

#include "planner/grid_plan.h"

namespace headland {

struct Perturbation {
  int changes = 0;  // sections of the order turned round; 0: the plan stays as it is
  std::uint64_t seed = 1;
};

// The cells in the order in which `plan`, of this request, comes to them first, with sections of it
// turned round between two places drawn evenly (the weak perturbation of Wang et al. 2025,
// 10.20944/preprints202504.0101.v1, Figure 4, kept whatever it costs), joined as expanded() does.
// Start and end stay as they are where they are given. What the plan says of its search stays, too.
// Throws as OrderTask.
GridPlan perturbed_plan(const GridPlanRequest& request, const GridPlan& plan,
                        const Perturbation& perturbation);

}  // namespace headland
