#include <fmt/format.h>

#include <cmath>

#include "evaluate/tuning.h"
#include "planner/grid_planners.h"
#include "planner/seeded_random.h"

namespace headland {
namespace {

// Weights whose ratios are drawn evenly on a logarithmic scale, over a factor of kSpread squared.
constexpr double kSpread = 10.0;
double drawn_weight(SeededRandom& random) {
  return std::pow(kSpread, 2.0 * draw_unit(random) - 1.0);
}

GridCost drawn_cost(int variation, SeededRandom& random) {
  // The last two have no weights: once more by them would be the same plan once more.
  constexpr GridObjective kTurns[] = {GridObjective::kWeighted, GridObjective::kTractor,
                                      GridObjective::kMeasured, GridObjective::kLength};
  constexpr int kAll = 4;
  constexpr int kWithWeights = 2;
  GridCost cost;
  cost.objective = kTurns[variation < kAll ? variation : variation % kWithWeights];
  for (double* weight :
       {&cost.weights.repeat, &cost.weights.turn, &cost.weights.u_turn, &cost.tractor.length_weight,
        &cost.tractor.height_weight, &cost.tractor.turn_weight}) {
    *weight *= drawn_weight(random);
  }
  return cost;
}

// Plans of those methods that few or many changes of their order make worse.
void add_perturbed(const Tuning& tuning, SeededRandom& random, std::vector<TunedMethod>& methods) {
  constexpr int kMostChanges = 8;
  const int made = static_cast<int>(methods.size());
  for (int i = 1; i <= tuning.perturbed; ++i) {
    TunedMethod method = at(methods, draw_below(random, made));
    method.label += fmt::format(", perturbed {}", i);
    method.planner.grid->perturb = {1 + draw_below(random, kMostChanges), draw_bits(random)};
    methods.push_back(method);
  }
}

}  // namespace

Sweep sweep_by(const Sweep& set, const std::string& name, const std::vector<TunedMethod>& methods) {
  Sweep sweep = set;
  sweep.name = name;
  sweep.planners.clear();
  sweep.scenarios.clear();
  for (const TunedMethod& method : methods) sweep.planners.push_back(method.label);
  for (const Scenario& drive : set.scenarios) {
    for (const TunedMethod& method : methods) {
      Scenario& scenario = sweep.scenarios.emplace_back(drive);
      scenario.planner = method.planner;
    }
  }
  return sweep;
}

PlannerChoice planner_with(const Tuning& tuning, const GridCost& cost) {
  PlannerChoice planner = tuning.planner;
  planner.grid->cost = cost;
  planner.predict_file = tuning.costs;
  if (cost.objective == GridObjective::kMeasured) planner.cost_file = tuning.costs;
  return planner;
}

std::vector<TunedMethod> training_methods(const Tuning& tuning) {
  std::vector<TunedMethod> methods;
  SeededRandom random(tuning.seed);
  for (const std::string& name : tuning.plan_planners) {
    const GridPlannerEntry& entry = find_grid_planner(name, tuning.file.string());
    // Rows up and down take no weights.
    const int variations = name == "grid_boustrophedon" ? 1 : tuning.variations;
    for (int variation = 0; variation < variations; ++variation) {
      PlannerChoice planner = planner_with(tuning, drawn_cost(variation, random));
      planner.name = name;
      planner.parameters = resolve_parameters(entry.parameters, {}, tuning.file.string(), "plans");
      planner.grid->stop = SearchStop{};
      planner.grid->stop.iterations = tuning.plan_iterations;
      methods.push_back(
          {variations == 1 ? name : fmt::format("{} {}", name, variation + 1), planner});
    }
  }
  add_perturbed(tuning, random, methods);
  return methods;
}

}  // namespace headland
