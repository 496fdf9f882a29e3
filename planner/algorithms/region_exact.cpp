#include "planner/algorithms/region_exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/indexed.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();
constexpr std::size_t kSetsPerCheck = 1024;  // between questions whether to go on

// The variants of all parts in a row: `first[part]` to `first[part + 1]`.
struct ExactStates {
  std::vector<RegionVisit> visits;
  std::vector<std::size_t> first;
  std::vector<double> step;  // from state to state: the link and the way in the part
  std::size_t size() const { return visits.size(); }
};

ExactStates exact_states(const RegionProblem& problem) {
  ExactStates states;
  for (int part = 0; part < problem.size(); ++part) {
    states.first.push_back(states.size());
    const int variants = static_cast<int>(at(problem.parts, part).size());
    for (int variant = 0; variant < variants; ++variant) states.visits.push_back({part, variant});
  }
  states.first.push_back(states.size());
  states.step.reserve(states.size() * states.size());
  for (const RegionVisit from : states.visits) {
    for (const RegionVisit to : states.visits) {
      const RegionVariant& next = variant_of(problem, to);
      states.step.push_back(link_cost(problem, variant_of(problem, from), next) + next.cost);
    }
  }
  return states;
}

// Least costs of ways through a set of parts, by set and by the state they end in.
using LeastCosts = std::vector<double>;

void extend_ways(const ExactStates& states, std::size_t set, LeastCosts& least_of) {
  const std::size_t parts = states.first.size() - 1;
  for (std::size_t from = 0; from < states.size(); ++from) {
    const double so_far = least_of[set * states.size() + from];
    if (so_far == kNoWay) continue;
    const double* const step = states.step.data() + from * states.size();
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t bit = std::size_t{1} << part;
      if ((set & bit) != 0) continue;
      double* const onward = least_of.data() + (set | bit) * states.size();
      for (std::size_t to = states.first[part]; to < states.first[part + 1]; ++to) {
        onward[to] = std::min(onward[to], so_far + step[to]);
      }
    }
  }
}

LeastCosts least_costs(const RegionProblem& problem, const ExactStates& states,
                       PlanSearch& search) {
  const std::size_t sets = std::size_t{1} << problem.parts.size();
  LeastCosts least_of(sets * states.size(), kNoWay);
  for (std::size_t state = 0; state < states.size(); ++state) {
    const RegionVariant& first = variant_of(problem, states.visits[state]);
    const std::size_t set = std::size_t{1} << static_cast<unsigned>(states.visits[state].part);
    least_of[set * states.size() + state] = start_cost(problem, first) + first.cost;
  }
  for (std::size_t set = 1; set < sets; ++set) {
    if (set % kSetsPerCheck == 0) stop_if(search.cancelled);
    extend_ways(states, set, least_of);
  }
  return least_of;
}

// Which state the way to a state came from: the steps are looked for again.
std::vector<RegionVisit> way_back(const RegionProblem& problem, const ExactStates& states,
                                  const LeastCosts& least_of) {
  std::size_t set = (std::size_t{1} << problem.parts.size()) - 1;
  const auto costs = [&](std::size_t of_set) { return least_of.data() + of_set * states.size(); };
  std::size_t last = 0;
  double least = kNoWay;
  for (std::size_t state = 0; state < states.size(); ++state) {
    const double whole =
        costs(set)[state] + end_cost(problem, variant_of(problem, states.visits[state]));
    if (whole < least) {
      least = whole;
      last = state;
    }
  }
  std::vector<RegionVisit> visits = {states.visits[last]};
  while (visits.size() < problem.parts.size()) {
    set &= ~(std::size_t{1} << static_cast<unsigned>(states.visits[last].part));
    std::size_t before = 0;
    for (std::size_t state = 0; state < states.size(); ++state) {
      const auto whole = [&](std::size_t from) {
        return costs(set)[from] + states.step[from * states.size() + last];
      };
      if (whole(state) < whole(before)) before = state;
    }
    last = before;
    visits.push_back(states.visits[last]);
  }
  std::ranges::reverse(visits);
  return visits;
}

}  // namespace

double exact_plan_bytes(const RegionProblem& problem) {
  double states = 0.0;
  for (const auto& variants : problem.parts) states += static_cast<double>(variants.size());
  return std::pow(2.0, problem.size()) * states * sizeof(double);
}

RegionPlan plan_region_exact(const RegionRequest& request) {
  PlanSearch search = begun_search(request);
  const RegionProblem& problem = request.problem;
  if (exact_plan_bytes(problem) > kMostExactBytes) {
    constexpr double kGigabyte = 1e9;
    throw InputError(
        kRegionPlanSource, "parts", fmt::format("{}", problem.size()),
        fmt::format("at most {:.1f} GB are taken, not {:.3g} GB; "
                    "region_local_search does without",
                    kMostExactBytes / kGigabyte, exact_plan_bytes(problem) / kGigabyte));
  }
  const ExactStates states = exact_states(problem);
  std::vector<RegionVisit> visits = way_back(problem, states, least_costs(problem, states, search));
  const double parts = problem.size();
  search.evaluations =
      static_cast<std::int64_t>(std::pow(2.0, parts) * static_cast<double>(states.size()));
  note_cost(search, plan_cost(problem, visits));
  RegionPlan plan = finished_plan(request, "region_exact", std::move(visits), search);
  plan.proven = true;
  return plan;
}

}  // namespace headland
