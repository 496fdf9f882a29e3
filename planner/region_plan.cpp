#include "planner/region_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

void check_problem(const RegionProblem& problem) {
  if (problem.parts.empty()) {
    throw InputError(kRegionPlanSource, "parts", "0", "at least one part is needed");
  }
  const auto check_finite = [](const Eigen::Vector2d& p_W, const std::string& where) {
    if (p_W.allFinite()) return;
    throw InputError(kRegionPlanSource, where, fmt::format("({}, {})", p_W.x(), p_W.y()),
                     "finite coordinates");
  };
  for (std::size_t part = 0; part < problem.parts.size(); ++part) {
    const std::string where = fmt::format("parts[{}]", part);
    if (problem.parts[part].empty()) {
      throw InputError(kRegionPlanSource, where, "0", "at least one variant is needed");
    }
    for (const RegionVariant& variant : problem.parts[part]) {
      check_finite(variant.entry_W, where + ".entry_W");
      check_finite(variant.exit_W, where + ".exit_W");
      if (variant.cost >= 0.0 && std::isfinite(variant.cost)) continue;
      throw InputError(kRegionPlanSource, where + ".cost", fmt::format("{}", variant.cost),
                       "a finite number from 0 up");
    }
  }
  if (problem.start_W) check_finite(*problem.start_W, "start_W");
  if (problem.end_W) check_finite(*problem.end_W, "end_W");
}

}  // namespace

double plan_cost(const RegionProblem& problem, std::span<const RegionVisit> visits) {
  double sum = 0.0;
  const RegionVariant* before = nullptr;
  for (const RegionVisit visit : visits) {
    const RegionVariant& now = variant_of(problem, visit);
    sum += before == nullptr ? start_cost(problem, now) : link_cost(problem, *before, now);
    sum += now.cost;
    before = &now;
  }
  return before == nullptr ? sum : sum + end_cost(problem, *before);
}

double start_cost(const RegionProblem& problem, const RegionVariant& first) {
  if (problem.links) return problem.links->from_start_wh[first.number];
  return problem.start_W ? (first.entry_W - *problem.start_W).norm() : 0.0;
}

double end_cost(const RegionProblem& problem, const RegionVariant& last) {
  if (problem.links) return problem.links->to_end_wh[last.number];
  return problem.end_W ? (last.exit_W - *problem.end_W).norm() : 0.0;
}

int most_variants(const RegionProblem& problem) {
  std::size_t most = 0;
  for (const auto& variants : problem.parts) most = std::max(most, variants.size());
  return static_cast<int>(most);
}

PlanSearch begun_search(const RegionRequest& request) {
  check_stop(request.stop, kRegionPlanSource);
  check_problem(request.problem);
  PlanSearch search;
  search.stop = request.stop;
  search.cancelled = request.cancelled;
  return search;
}

RegionPlan finished_plan(const RegionRequest& request, const std::string& planner,
                         std::vector<RegionVisit> visits, const PlanSearch& search) {
  RegionPlan plan;
  plan.planner = planner;
  plan.cost = plan_cost(request.problem, visits);
  plan.visits = std::move(visits);
  plan.convergence = search.convergence;
  plan.iterations = search.iteration;
  plan.evaluations = search.evaluations;
  plan.stopped_by = search.stopped_by.value_or(StopReason::kNothingBetter);
  return plan;
}

}  // namespace headland
