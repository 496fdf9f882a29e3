#include "evaluate/plan_runs.h"

#include <fmt/format.h>

#include <cmath>

namespace headland {
namespace {

constexpr const char* kColumns =
    "state, outcome, reason, outcome_detail, grid_steps, grid_repeats, grid_turns, grid_u_turns, "
    "grid_level_m, grid_climb_m, grid_jumps, predicted_energy_wh, predicted_swath_wh, "
    "predicted_headland_pass_wh, predicted_turn_wh, predicted_u_turn_wh, predicted_transit_wh, "
    "energy_wh, energy_wh_per_ha, time_s, delta_soc, coverage_ratio, place";

// Columns one after another.
struct Reader {
  const Statement& row;
  int column = 0;
  std::string text() { return std::string(text_at(row, column++)); }
  double number() { return number_at(row, column++); }
  int count() {
    const double value = number();
    return std::isfinite(value) ? static_cast<int>(value) : 0;
  }
};

std::string fault_of(const std::string& state, const std::string& outcome,
                     const std::string& reason, const std::string& detail) {
  if (state != "driven") return reason.empty() ? state : fmt::format("{}: {}", state, reason);
  if (outcome == "finished") return "";
  return detail.empty() ? outcome : fmt::format("{}: {}", outcome, detail);
}

PlanRun plan_at(const Statement& row) {
  Reader next{row};
  PlanRun plan;
  const std::string state = next.text();
  const std::string outcome = next.text();
  const std::string reason = next.text();
  plan.fault = fault_of(state, outcome, reason, next.text());
  GridCounts& counts = plan.counts;
  for (int* count : {&counts.steps, &counts.repeats, &counts.turns, &counts.u_turns}) {
    *count = next.count();
  }
  counts.distinct_cells = counts.steps + 1 - counts.repeats;
  counts.level_m = next.number();
  counts.climb_m = next.number();
  plan.jumps = next.count() > 0;
  plan.predicted_wh = next.number();
  for (double& wh : plan.predicted_kind_wh) wh = next.number();
  for (double* figure : {&plan.energy_wh, &plan.energy_wh_per_ha, &plan.time_s, &plan.delta_soc,
                         &plan.coverage_ratio}) {
    *figure = next.number();
  }
  plan.place = static_cast<std::size_t>(next.count());
  const bool told = std::isfinite(plan.energy_wh) && plan.energy_wh > 0.0;
  if (plan.fault.empty() && !told) plan.fault = "its energy is no positive number";
  return plan;
}

// The printed weights, and one of them as 1 with the others 0.
GridCost unit_cost(GridObjective form, int term) {
  GridCost cost;
  cost.objective = form;
  const auto unit = [&](int place) { return place == term ? 1.0 : 0.0; };
  cost.weights = {unit(0), unit(1), unit(2)};
  cost.tractor.length_weight = unit(0);
  cost.tractor.height_weight = unit(1);
  cost.tractor.turn_weight = unit(2);
  return cost;
}

}  // namespace

std::vector<PlanRun> plan_runs(const Sweep& sweep, RunStore& store) {
  const std::scoped_lock lock(store.mutex);
  const Statement row = prepare(
      store.database,
      fmt::format("SELECT {} FROM runs WHERE sweep = ? AND place < ? ORDER BY place", kColumns));
  bind_value(row, 1, sweep.name);
  bind_value(row, 2, static_cast<std::int64_t>(cell_count(sweep)));
  std::vector<PlanRun> plans;
  while (step(row)) {
    PlanRun plan = plan_at(row);
    const SweepCell cell = cell_at(sweep, plan.place);
    const Scenario scenario = scenario_at(sweep, plan.place);
    plan.block = fmt::format("{}, {}, {}, seed {}", cell.field, cell.terrain, cell.soil, cell.seed);
    plan.method = cell.planner;
    plan.cell_m =
        scenario.field.grid_map.empty() ? scenario.working_width_m : scenario.field.cell_m;
    plans.push_back(plan);
  }
  return plans;
}

std::vector<std::string> energy_terms(GridObjective form) {
  switch (form) {
    case GridObjective::kLength:
      return {"steps"};
    case GridObjective::kWeighted:
      return {"cells", "repeats", "turns", "U-turns"};
    case GridObjective::kTractor:
      return {"level way", "climb", "turns"};
    case GridObjective::kMeasured:
      break;
  }
  std::vector<std::string> terms;
  terms.reserve(kPredictedKinds);
  for (const PathKind kind : kEveryPathKind) {
    terms.emplace_back(path_kind_name(kind));
  }
  return terms;
}

std::vector<double> energy_terms_of(GridObjective form, const PlanRun& plan) {
  if (form == GridObjective::kMeasured) {
    return {plan.predicted_kind_wh.begin(), plan.predicted_kind_wh.end()};
  }
  if (form == GridObjective::kLength) return {static_cast<double>(plan.counts.steps)};
  std::vector<double> terms;
  if (form == GridObjective::kWeighted) {
    terms.push_back(static_cast<double>(plan.counts.distinct_cells));
  }
  constexpr int kWeights = 3;
  for (int term = 0; term < kWeights; ++term) {
    terms.push_back(cost_of(unit_cost(form, term), plan.counts, plan.cell_m));
  }
  return terms;
}

double printed_cost_of(GridObjective form, const PlanRun& plan) {
  if (form == GridObjective::kMeasured) return plan.predicted_wh;
  GridCost cost;
  cost.objective = form;
  return cost_of(cost, plan.counts, plan.cell_m);
}

}  // namespace headland
