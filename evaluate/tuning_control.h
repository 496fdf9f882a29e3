// The negative control of a tuning: weights fitted to energies that were dealt out anew among the
// plans of each field, which tell nothing of the plans. A permutation test of what fitting saves.
#pragma once

#include <string>
#include <vector>

#include "evaluate/plan_runs.h"

namespace headland {

struct TuningControl {
  std::string fitted;       // the method whose fit was repeated; empty: no control
  int fits = 0;             // to shuffled energies
  int without_weights = 0;  // of them: all weights came out as 0, nothing to plan by
  int as_good = 0;          // of them: whose plans take no more energy than those of `fitted`
  double p = 1.0;           // that chance fits as well: (1 + as_good) / (1 + fits)
};

// Counts `as_good` among the methods "shuffled 1", "shuffled 2" ... of driven held-out plans: those
// that were driven to the end on more fields than `fitted`, or on as many with no more energy, by
// the mean saving where both were. A fit without weights is not as good.
void judge_control(const std::vector<PlanRun>& held_out, TuningControl& control);

// Takes the plans of shuffled fits out of `held_out` and returns them as one method "shuffled": on
// each field the mean of those driven to their end, a fault where none was.
std::vector<PlanRun> take_control(std::vector<PlanRun>& held_out);

}  // namespace headland
