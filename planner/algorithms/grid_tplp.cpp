#include "planner/algorithms/grid_tplp.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "planner/greedy_order.h"
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

// Where POP2 and POP3 end.
std::array<double, 2> ends_of_groups(const Parameters& parameters) {
  const double pop2 = number(parameters, "share_2");
  const double pop3 = number(parameters, "share_3");
  const double sum = pop2 + pop3 + number(parameters, "share_4");
  check_grid_tplp(parameters, kGridPlanSource, "");
  return {pop2 / sum, (pop2 + pop3) / sum};
}

struct Tplp {
  TplpRule rule;
  std::array<double, 2> ends;  // of POP2 and POP3, as shares of all but the best

  void operator()(OrderSearch& search, Population& population, int i) const;
};

void Tplp::operator()(OrderSearch& search, Population& population, int i) const {
  Individual& one = at(population, i);
  const int size = static_cast<int>(population.size());
  const auto is_before = [&](double end) { return i < 1 + std::lround((size - 1) * end); };
  const bool is_pop2 = is_before(ends[0]);
  const bool is_pop3 = !is_pop2 && is_before(ends[1]);
  // Of itself an individual has nothing to learn.
  const Individual& teacher = at(population, is_pop3 ? draw_below(search.random, size) : 0);
  const int count = rule.random_places ? kRandomPlaces : search.places.end - search.places.first;
  for (int step = 0; step < count; ++step) {
    const int k = rule.random_places ? draw_place(search) : search.places.first + step;
    if (i == 0) {
      perturb_strongly(search, one, k, rule.others);
    } else if (is_pop2 || is_pop3) {
      learn(search, one, teacher, k, is_pop2 ? rule.pop2 : rule.others);
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

void check_grid_tplp(const Parameters& parameters, const std::string& source,
                     const std::string& where) {
  for (const char* share : {"share_2", "share_3", "share_4"}) {
    if (number(parameters, share) > 0.0) return;
  }
  throw InputError(source, key_path(where, "share_2"), "0",
                   "more than 0, or share_3 or share_4 is: all are zero");
}

Improve learning_perturbation(const Parameters& parameters) {
  return Tplp{rule_of(word(parameters, "rule")), ends_of_groups(parameters)};
}

GridPlan plan_grid_tplp(const GridPlanRequest& request) {
  const double greediness = number(request.parameters, "alpha_g");
  const double lambda = number(request.parameters, "lambda");
  return plan_by_population(
      request, {"grid_tplp", population_of(request.parameters),
                [&](const GridProblem& problem, const DistanceTable& table, SeededRandom& random) {
                  return greedy_order(problem, table, greediness, lambda, random);
                },
                learning_perturbation(request.parameters)});
}

}  // namespace headland
