// The fitness of Wu et al. 2023 with weights that adapt, as a form of energy.
#pragma once

#include <vector>

#include "evaluate/plan_runs.h"

namespace headland {

// What each plan costs by weights of its own: the printed ones adapted by the paper's Eqs 2 to 10
// to what it counts, with the mean of the plans on its block in place of its parents' mean.
std::vector<double> adapted_costs(const std::vector<PlanRun>& plans);

// W h a unit of that cost and a free cell: least squares, 0 or more each.
struct AdaptedFit {
  double scale = 0.0;
  double cell_wh = 0.0;
};
AdaptedFit fit_adapted(const std::vector<PlanRun>& plans);

std::vector<double> adapted_energies_wh(const AdaptedFit& fit, const std::vector<PlanRun>& plans);

}  // namespace headland
