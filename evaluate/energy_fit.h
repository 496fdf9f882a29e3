// Energy models fitted to driven plans, and how well they tell the energy of plans.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/nonnegative_fit.h"
#include "evaluate/plan_runs.h"

namespace headland {

struct FittedTerm {
  std::string name;
  double coefficient = 0.0;  // W h for each of it; of `measured`: W h for each predicted W h
  Interval interval;         // 95 %, bootstrap over the blocks
};

struct EnergyFit {
  GridObjective form = GridObjective::kWeighted;
  int plans = 0;
  std::vector<FittedTerm> terms;
  // What the printed weights need to tell an energy at all: W h a unit of cost and, of `weighted`,
  // which counts nothing for work itself, a free cell. Fitted, too; 1 and 0 of `measured`.
  double printed_scale = 1.0;
  double printed_cell_wh = 0.0;
};

// Plans that can be fitted: driven to their end, without jumps, with a predicted energy.
std::vector<PlanRun> fit_plans(const std::vector<PlanRun>& plans);

// Throws InputError(source, place) when there are fewer plans than the form has terms to fit and,
// naming them, for terms that the plans do not tell apart. Energies may be unknown.
void check_fittable(GridObjective form, const std::vector<PlanRun>& plans,
                    const std::string& source, const std::string& place);

// Least squares of energy a free cell, so that large fields count as small ones, with coefficients
// of 0 or more. Of `measured`, kinds of movement that no plan has are left out and keep 1. Throws
// as check_fittable.
EnergyFit fit_energy(GridObjective form, const std::vector<PlanRun>& plans, int bootstrap_draws,
                     std::uint64_t seed, const std::string& source,
                     const std::string& place = "training");

// W h of a plan, by the fitted coefficients and by the printed weights.
double fitted_energy_wh(const EnergyFit& fit, const PlanRun& plan);
double printed_energy_wh(const EnergyFit& fit, const PlanRun& plan);

// How well energies are told. NaN where there are too few plans or they are all alike.
struct Prediction {
  int plans = 0;
  double r2 = 0.0;                   // 1 - residual over total sum of squares; below 0: worse than
                                     // the mean
  double spearman = 0.0;             // over all plans, most of which is the fields' size
  double spearman_in_block = 0.0;    // mean over the blocks: do better plans come out better
  double mean_absolute_error = 0.0;  // ratio
};
Prediction prediction_of(const std::vector<PlanRun>& plans,
                         const std::vector<double>& predicted_wh);

// The weights to plan by: those of `weighted` or `tractor`; nullopt for other forms, whose plans do
// not depend on them, and when all are 0.
std::optional<GridCost> fitted_cost(const EnergyFit& fit);

// The negative control's data: in every block its energies dealt out anew to its plans.
std::vector<PlanRun> with_shuffled_energies(std::vector<PlanRun> plans, std::uint64_t seed);

}  // namespace headland
