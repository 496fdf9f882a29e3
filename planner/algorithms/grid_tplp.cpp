#include "planner/algorithms/grid_tplp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "planner/greedy_order.h"
#include "planner/order_population.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kRandomPlaces = 100;  // tried an iteration by rule `random_places`

// What is kept of those that learn from the best, and of the others.
struct TplpRule {
  Keep pop2 = Keep::kNotWorse;
  Keep others = Keep::kNotWorse;
  bool random_places = false;
};

TplpRule rule_of(const std::string& name) {
  if (name == "better") return {Keep::kBetter, Keep::kBetter, false};
  if (name == "pop2_not_worse") return {Keep::kNotWorse, Keep::kBetter, false};
  return {Keep::kNotWorse, Keep::kNotWorse, name == "random_places"};
}

// Where POP2, POP3 and POP4 end in the sorted population.
std::array<int, 3> ends_of_groups(int population, const Parameters& parameters) {
  const std::array<double, 3> shares = {
      number(parameters, "share_2"), number(parameters, "share_3"), number(parameters, "share_4")};
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(sum > 0.0)) {
    throw InputError(kGridPlanSource, "share_2", "0",
                     "more than 0, or share_3 or share_4 is: all are zero");
  }
  const auto end_after = [&](double share) {
    return 1 + static_cast<int>(std::lround((population - 1) * share / sum));
  };
  return {end_after(shares[0]), end_after(shares[0] + shares[1]), population};
}

void improve_one(OrderSearch& search, std::vector<Individual>& population, int i,
                 const Individual& best, const std::array<int, 3>& ends, const TplpRule& rule) {
  Individual& one = at(population, i);
  const int count = rule.random_places ? kRandomPlaces : search.places.end - search.places.first;
  for (int step = 0; step < count; ++step) {
    const int k = rule.random_places ? draw_place(search) : search.places.first + step;
    if (i == 0) {
      perturb_strongly(search, one, k, rule.others);
    } else if (i < ends[0]) {
      learn(search, one, best, k, rule.pop2);
    } else if (i < ends[1]) {
      const int teacher = draw_below(search.random, static_cast<int>(population.size()));
      if (teacher != i) learn(search, one, at(population, teacher), k, rule.others);
    } else {
      perturb_weakly(search, one, k, rule.others);
    }
  }
}

}  // namespace

std::span<const ParameterSpec> grid_tplp_parameters() {
  static const std::array kSpecs{
      ParameterSpec{"population", 50.0, 2.0, 1000.0, {}, "individuals (Num)", true},
      ParameterSpec{"alpha_g", 1.0, 0.0, 1.0, {}, "probability of the greedy choice"},
      ParameterSpec{"lambda", 5.0, 0.0, 50.0, {}, "exponent of the transition probability"},
      ParameterSpec{"share_2", 2.0, 0.0, 100.0, {}, "share of those that learn from the best"},
      ParameterSpec{"share_3", 2.0, 0.0, 100.0, {}, "share of those that learn from any"},
      ParameterSpec{"share_4", 1.0, 0.0, 100.0, {}, "share of those perturbed weakly"},
      ParameterSpec{"rule",
                    std::string("not_worse"),
                    0.0,
                    0.0,
                    {"not_worse", "better", "random_places", "pop2_not_worse"},
                    "which changes are kept, and at which places they are tried"},
  };
  return kSpecs;
}

GridPlan plan_grid_tplp(const GridPlanRequest& request) {
  const Parameters& parameters = request.parameters;
  const double greediness = number(parameters, "alpha_g");
  const double lambda = number(parameters, "lambda");
  const int size = static_cast<int>(number(parameters, "population"));
  const std::array<int, 3> ends = ends_of_groups(size, parameters);
  const TplpRule rule = rule_of(word(parameters, "rule"));
  return plan_by_population(
      request,
      {"grid_tplp", size,
       [&](const GridProblem& problem, const DistanceTable& table, SeededRandom& random) {
         return greedy_order(problem, table, greediness, lambda, random);
       },
       [&](OrderSearch& search, std::vector<Individual>& population, int i,
           const Individual& best) { improve_one(search, population, i, best, ends, rule); }});
}

}  // namespace headland
