#include "planner/algorithms/region_enumeration.h"

#include <fmt/format.h>

#include <utility>

#include "planner/indexed.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::int64_t kPlansPerCheck = 1 << 18;  // between questions whether to go on

struct Enumeration {
  const RegionProblem& problem;
  PlanSearch& search;
  std::vector<RegionVisit> visits;  // the plan as far as it is made
  std::vector<char> visited;
  std::vector<RegionVisit> best;
  std::int64_t unchecked = 0;
};

// Tries all that can follow; false: the search is over.
bool enumerate(Enumeration& all, const RegionVariant* before, double so_far) {
  const int parts = all.problem.size();
  if (static_cast<int>(all.visits.size()) == parts) {
    ++all.search.evaluations;
    if (note_cost(all.search, so_far + end_cost(all.problem, *before))) all.best = all.visits;
    if (++all.unchecked < kPlansPerCheck) return true;
    all.unchecked = 0;
    return goes_on(all.search);
  }
  for (int part = 0; part < parts; ++part) {
    if (at(all.visited, part) != 0) continue;
    at(all.visited, part) = 1;
    const int variants = static_cast<int>(at(all.problem.parts, part).size());
    for (int variant = 0; variant < variants; ++variant) {
      const RegionVariant& now = variant_of(all.problem, {part, variant});
      const double to_it =
          before == nullptr ? start_cost(all.problem, now) : link_cost(all.problem, *before, now);
      all.visits.push_back({part, variant});
      if (!enumerate(all, &now, so_far + to_it + now.cost)) return false;
      all.visits.pop_back();
    }
    at(all.visited, part) = 0;
  }
  return true;
}

double plans_of(const RegionProblem& problem) {
  double plans = 1.0;
  for (int part = 0; part < problem.size(); ++part) {
    plans *= (part + 1.0) * static_cast<double>(at(problem.parts, part).size());
  }
  return plans;
}

}  // namespace

RegionPlan plan_region_enumeration(const RegionRequest& request) {
  PlanSearch search = begun_search(request);
  const double plans = plans_of(request.problem);
  if (plans > kMostEnumerated) {
    throw InputError(kRegionPlanSource, "parts", fmt::format("{}", request.problem.size()),
                     fmt::format("at most {:g} plans are enumerated, not {:.3g}; region_exact or "
                                 "region_local_search do without",
                                 kMostEnumerated, plans));
  }
  Enumeration all{
      request.problem, search, {}, std::vector<char>(request.problem.parts.size(), 0), {}, 0};
  const bool finished = enumerate(all, nullptr, 0.0);
  RegionPlan plan = finished_plan(request, "region_enumeration", std::move(all.best), search);
  plan.proven = finished;
  return plan;
}

}  // namespace headland
