#include "evaluate/tuning_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "planner/grid_planners.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::size_t kFaultsTold = 5;

struct TuningUnderWay {
  const Tuning& tuning;
  RunStore& store;
  const TuneOptions& options;
  TuneResult result;
};

void tally(const std::vector<PlanRun>& plans, const SweepResult& swept, RunTally& counts) {
  counts.driven_now += static_cast<int>(swept.driven + swept.no_plan + swept.refused);
  counts.runs += static_cast<int>(plans.size());
  for (const PlanRun& plan : plans) {
    if (plan.fault.empty()) continue;
    ++counts.faults;
    if (counts.why.size() < kFaultsTold) {
      counts.why.push_back(fmt::format("{}, {}: {}", plan.block, plan.method, plan.fault));
    }
  }
}

std::vector<PlanRun> drive(TuningUnderWay& running, std::string_view what, const Sweep& sweep,
                           RunTally& counts) {
  ParallelOptions parallel;
  parallel.jobs = running.options.jobs;
  parallel.cancelled = running.options.cancelled;
  parallel.progress = [&](int done, int all) {
    if (running.options.progress) running.options.progress(what, done, all);
  };
  const SweepResult swept = run_sweep(sweep, running.store, {}, parallel);
  if (swept.ended_early) throw Cancelled{};
  if (!swept.failed.empty()) {
    throw std::runtime_error(fmt::format("{}: {}", swept.failed[0].what, swept.failed[0].why));
  }
  std::vector<PlanRun> plans = plan_runs(sweep, running.store);
  tally(plans, swept, counts);
  return plans;
}

std::vector<double> energies(const EnergyFit& fit, const std::vector<PlanRun>& plans,
                             double (*energy_of)(const EnergyFit&, const PlanRun&)) {
  std::vector<double> wh;
  wh.reserve(plans.size());
  for (const PlanRun& plan : plans) wh.push_back(energy_of(fit, plan));
  return wh;
}

void fit_forms(TuningUnderWay& running) {
  const Tuning& tuning = running.tuning;
  const std::vector<PlanRun>& plans = running.result.training_plans;
  for (const GridObjective form : tuning.forms) {
    FormReport report;
    report.fit = fit_energy(form, plans, tuning.bootstrap_draws, tuning.seed, tuning.file.string(),
                            tuning.training_place);
    report.training_printed = prediction_of(plans, energies(report.fit, plans, printed_energy_wh));
    report.training_fitted = prediction_of(plans, energies(report.fit, plans, fitted_energy_wh));
    if (form == GridObjective::kWeighted) {
      report.adapted = fit_adapted(plans);
      report.training_adapted = prediction_of(plans, adapted_energies_wh(*report.adapted, plans));
    }
    running.result.forms.push_back(report);
  }
}

WeightShares shares_of(const GridCost& cost) {
  if (cost.objective == GridObjective::kWeighted) {
    return {cost.weights.repeat, cost.weights.turn, cost.weights.u_turn};
  }
  return {cost.tractor.length_weight, cost.tractor.height_weight, cost.tractor.turn_weight};
}

GridCost cost_with(GridObjective form, const WeightShares& weights) {
  GridCost cost;
  cost.objective = form;
  cost.weights = {weights[0], weights[1], weights[2]};
  cost.tractor.length_weight = weights[0];
  cost.tractor.height_weight = weights[1];
  cost.tractor.turn_weight = weights[2];
  return cost;
}

// Mean W h a hectare of the plans that came to their end, by block.
std::map<std::string, double> usual_energies(const std::vector<PlanRun>& plans) {
  std::map<std::string, std::pair<double, int>> sums;
  for (const PlanRun& plan : plans) {
    auto& [sum, count] = sums[plan.block];
    sum += plan.energy_wh_per_ha;
    ++count;
  }
  std::map<std::string, double> usual;
  for (const auto& [block, sum] : sums) usual[block] = sum.first / sum.second;
  return usual;
}

// Energy of the plans that the planner makes with these weights, over the usual on each field.
double driven_loss(TuningUnderWay& running, GridObjective form, const WeightShares& weights,
                   const std::map<std::string, double>& usual) {
  const Tuning& tuning = running.tuning;
  const TunedMethod method{
      fmt::format("{} {} {} {}", grid_objective_name(form), weights[0], weights[1], weights[2]),
      planner_with(tuning, cost_with(form, weights))};
  const auto what = fmt::format("drives for {} weights", grid_objective_name(form));
  // Named after the weights: another program may search in the same store at the same time.
  const std::string name = fmt::format("{}: search, {}", tuning.name, method.label);
  const std::vector<PlanRun> plans =
      drive(running, what, sweep_by(tuning.training, name, {method}), running.result.search);
  double sum = 0.0;
  int counted = 0;
  for (const PlanRun& plan : plans) {
    const auto block = usual.find(plan.block);
    if (block == usual.end()) continue;
    sum += plan.fault.empty() ? plan.energy_wh_per_ha / block->second : kFaultLoss;
    ++counted;
  }
  return counted > 0 ? sum / counted : kFaultLoss;
}

void search_forms(TuningUnderWay& running) {
  if (running.tuning.evaluations == 0) return;
  const auto usual = usual_energies(running.result.training_plans);
  for (FormReport& report : running.result.forms) {
    const GridObjective form = report.fit.form;
    if (form != GridObjective::kWeighted && form != GridObjective::kTractor) continue;
    GridCost printed;
    printed.objective = form;
    std::vector<WeightShares> starts = {shares_of(printed)};
    if (const auto fitted = fitted_cost(report.fit)) starts.push_back(shares_of(*fitted));
    report.search = search_weights(
        [&](const WeightShares& weights) { return driven_loss(running, form, weights, usual); },
        starts, running.tuning.evaluations, running.tuning.seed);
  }
}

std::string_view author_of(GridObjective form) {
  return form == GridObjective::kWeighted ? "Wu et al." : "Wang et al.";
}

std::string fitted_label(GridObjective form) { return fmt::format("{} fitted", author_of(form)); }

void add_tuned_methods(TuningUnderWay& running) {
  TuneResult& result = running.result;
  const auto add = [&](const std::string& label, const GridCost& cost) {
    result.methods.push_back({label, planner_with(running.tuning, cost)});
  };
  double least_loss = kFaultLoss;
  for (const FormReport& report : result.forms) {
    const GridObjective form = report.fit.form;
    if (form != GridObjective::kWeighted && form != GridObjective::kTractor) continue;
    const auto fitted = fitted_cost(report.fit);
    if (fitted) {
      add(fitted_label(form), *fitted);
    } else {
      result.notes.push_back(fitted_label(form) + ": left out, all weights are 0");
    }
    if (fitted && result.best_label.empty()) {
      result.best = *fitted;
      result.best_label = fitted_label(form);
    }
    if (!report.search) continue;
    const std::string label = fmt::format("{} searched", author_of(form));
    const GridCost cost = cost_with(form, report.search->weights);
    add(label, cost);
    if (report.search->loss >= least_loss) continue;
    least_loss = report.search->loss;
    result.best = cost;
    result.best_label = label;
  }
}

// Fitted like the first form with weights, to energies that have nothing to do with the plans.
void add_controls(TuningUnderWay& running) {
  const Tuning& tuning = running.tuning;
  TuneResult& result = running.result;
  const auto form = std::find_if(result.forms.begin(), result.forms.end(), [](const FormReport& r) {
    return fitted_cost(r.fit).has_value();
  });
  if (form == result.forms.end()) return;
  TuningControl& control = result.control;
  control.fitted = fitted_label(form->fit.form);
  for (int i = 1; i <= tuning.shuffles; ++i) {
    const std::string label = fmt::format("{} {}", methods::kShuffled, i);
    const EnergyFit fit = fit_energy(
        form->fit.form,
        with_shuffled_energies(result.training_plans, tuning.seed + static_cast<std::uint64_t>(i)),
        tuning.bootstrap_draws, tuning.seed, tuning.file.string());
    ++control.fits;
    if (const auto cost = fitted_cost(fit)) {
      result.methods.push_back({label, planner_with(tuning, *cost)});
    } else {
      ++control.without_weights;
    }
  }
}

void add_methods(TuningUnderWay& running) {
  const Tuning& tuning = running.tuning;
  const auto add = [&](std::string_view label, GridObjective objective) {
    GridCost cost;
    cost.objective = objective;
    running.result.methods.push_back({std::string(label), planner_with(tuning, cost)});
  };
  add(methods::kRows, GridObjective::kLength);
  PlannerChoice& rows = running.result.methods.back().planner;
  rows.name = "grid_boustrophedon";
  rows.parameters.clear();
  add(methods::kLength, GridObjective::kLength);
  add(methods::kWu, GridObjective::kWeighted);
  add(methods::kWang, GridObjective::kTractor);
  add_tuned_methods(running);
  add(methods::kMeasured, GridObjective::kMeasured);
  add_controls(running);
}

void prove(TuningUnderWay& running) {
  const Tuning& tuning = running.tuning;
  TuneResult& result = running.result;
  result.held_out_plans =
      drive(running, "held-out drives",
            sweep_by(tuning.held_out, tuning.name + ": held out", result.methods), result.held_out);
  judge_control(result.held_out_plans, result.control);
  const std::vector<PlanRun> control = take_control(result.held_out_plans);
  std::vector<std::string> references;
  for (const std::string_view label :
       {methods::kRows, methods::kLength, methods::kWu, methods::kWang}) {
    references.emplace_back(label);
  }
  std::vector<PlanRun> plans = result.held_out_plans;
  plans.insert(plans.end(), control.begin(), control.end());
  result.figures = method_figures(plans, references);
  const std::vector<PlanRun> fitting = fit_plans(result.held_out_plans);
  for (FormReport& report : result.forms) {
    report.held_out_printed =
        prediction_of(fitting, energies(report.fit, fitting, printed_energy_wh));
    report.held_out_fitted =
        prediction_of(fitting, energies(report.fit, fitting, fitted_energy_wh));
    if (!report.adapted) continue;
    report.held_out_adapted = prediction_of(fitting, adapted_energies_wh(*report.adapted, fitting));
  }
}

}  // namespace

TuneResult run_tuning(const Tuning& tuning, RunStore& store, const TuneOptions& options) {
  TuningUnderWay running{tuning, store, options, {}};
  check_design(tuning, options);
  running.result.training_plans = fit_plans(
      drive(running, "training drives",
            sweep_by(tuning.training, tuning.name + ": training", training_methods(tuning)),
            running.result.training));
  const RunTally& counts = running.result.training;
  if (running.result.training_plans.empty() && !counts.why.empty()) {
    throw InputError(tuning.file.string(), tuning.training_place, "no plan could be driven",
                     counts.why.front());
  }
  fit_forms(running);
  search_forms(running);
  add_methods(running);
  prove(running);
  return std::move(running.result);
}

}  // namespace headland
