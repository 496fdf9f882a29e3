#include "evaluate/tuning_control.h"

#include <algorithm>
#include <map>

#include "evaluate/method_savings.h"
#include "evaluate/tuning_run.h"

namespace headland {
namespace {

bool of_control(const PlanRun& run) { return run.method.starts_with(methods::kShuffled); }

// The first run that was driven to its end with the means of all that were.
PlanRun mean_of(const std::vector<PlanRun>& runs) {
  std::vector<PlanRun> driven;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(driven),
               [](const PlanRun& run) { return run.fault.empty(); });
  PlanRun mean = driven.empty() ? runs.front() : driven.front();
  mean.method = methods::kShuffled;
  const auto take_mean = [&](double PlanRun::*value) {
    double sum = 0.0;
    for (const PlanRun& run : driven) sum += run.*value;
    mean.*value = sum / static_cast<double>(driven.size());
  };
  if (driven.empty()) return mean;
  for (const SavedQuantity& quantity : saved_quantities()) take_mean(quantity.value);
  take_mean(&PlanRun::coverage_ratio);
  return mean;
}

}  // namespace

void judge_control(const std::vector<PlanRun>& held_out, TuningControl& control) {
  const std::vector<MethodFigures> all = method_figures(held_out, {control.fitted});
  const auto fitted = std::ranges::find(all, control.fitted, &MethodFigures::method);
  for (const MethodFigures& figures : all) {
    if (!figures.method.starts_with(methods::kShuffled)) continue;
    if (figures.faults != fitted->faults) {
      control.as_good += figures.faults < fitted->faults ? 1 : 0;
      continue;
    }
    const Saving* saving = energy_saving(figures, control.fitted);
    // Without a field that both were driven on neither is better.
    const bool worse = saving != nullptr && saving->ratio.mean < 0.0;
    control.as_good += worse ? 0 : 1;
  }
  control.p = (1.0 + control.as_good) / (1.0 + control.fits);
}

std::vector<PlanRun> take_control(std::vector<PlanRun>& held_out) {
  std::map<std::string, std::vector<PlanRun>> controls;
  for (const PlanRun& run : held_out) {
    if (of_control(run)) controls[run.block].push_back(run);
  }
  std::erase_if(held_out, of_control);
  std::vector<PlanRun> means;
  means.reserve(controls.size());
  for (const auto& [block, runs] : controls) means.push_back(mean_of(runs));
  return means;
}

}  // namespace headland
