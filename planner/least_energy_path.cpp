#include "planner/least_energy_path.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "planner/polygon.h"

namespace headland {
namespace {

// The parameter's value left to costs, and its values with and without any.
struct LeftToCosts {
  const char* name;
  const char* by_costs;
  const char* without;
};
constexpr LeftToCosts kLeftToCosts[] = {{"swath_objective", "energy", "length_and_turns"},
                                        {"swath_order", "optimised", "boustrophedon"}};

bool allows(const PlannerEntry& planner, const LeftToCosts& parameter, std::string_view value) {
  const auto spec = std::ranges::find(planner.parameters, parameter.name, &ParameterSpec::name);
  return spec != planner.parameters.end() &&
         std::ranges::find(spec->choices, value) != spec->choices.end();
}

std::vector<Parameters> ways_to_plan(const PlannerEntry& planner, const Parameters& parameters) {
  std::vector<Parameters> ways{parameters};
  for (const LeftToCosts& left : kLeftToCosts) {
    const auto given = parameters.find(left.name);
    if (given == parameters.end() || word(parameters, left.name) != "auto") continue;
    std::vector<Parameters> more;
    for (const Parameters& way : ways) {
      for (const char* value : {left.by_costs, left.without}) {
        more.push_back(way);
        if (allows(planner, left, value)) more.back()[left.name] = std::string(value);
      }
    }
    ways = std::move(more);
  }
  return ways;
}

bool same_passes(const Plan& one, const Plan& other) {
  return std::ranges::equal(one.passes, other.passes,
                            [](const Pass& a, const Pass& b) { return a.points_W == b.points_W; });
}

}  // namespace

double chosen_by_wh(const PlannedPath& planned, const Heightfield* terrain, const DriveCost& cost) {
  double unworked_m = 0.0;
  for (const double cut_m : planned.path.cut_back_m) unworked_m += cut_m;
  for (const LeftOutPass& pass : planned.path.left_out) {
    unworked_m += length_m(planned.plan.passes.at(pass.pass).points_W);
  }
  return predicted_energy(planned.path, terrain, cost).energy_wh +
         unworked_m * wh_per_m(cost.working, 0.0);
}

PlannedPath least_energy_path(const PlannerEntry& planner, const PlanRequest& request,
                              const Vehicle& vehicle, const PathOptions& options) {
  std::optional<PlannedPath> best;
  double least_wh = 0.0;
  std::optional<PlanInfeasible> refused;
  std::vector<Plan> made;
  for (const Parameters& parameters : ways_to_plan(planner, request.parameters)) {
    PlanRequest asked = request;
    asked.parameters = parameters;
    try {
      Plan plan = planner.plan(asked);
      const auto known = [&](const Plan& other) { return same_passes(plan, other); };
      if (std::ranges::any_of(made, known)) continue;
      made.push_back(plan);
      PlannedPath planned{std::move(plan), {}};
      planned.path = make_path(request.field, vehicle, planned.plan, options, request.cancelled);
      const double wh = chosen_by_wh(planned, request.terrain, *request.cost);
      if (best && wh >= least_wh) continue;
      least_wh = wh;
      best = std::move(planned);
    } catch (const PlanInfeasible& infeasible) {
      refused = infeasible;
    }
  }
  if (!best) throw PlanInfeasible(*refused);
  return *std::move(best);
}

}  // namespace headland
