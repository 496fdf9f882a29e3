#include "planner/algorithms/grid_rivals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "planner/greedy_order.h"
#include "planner/order_population.h"

namespace headland {
namespace {

using Population = std::vector<Individual>;

std::vector<int> nearest_cell_order(const GridProblem& problem, const DistanceTable& table,
                                    SeededRandom& random) {
  return greedy_order(problem, table, 1.0, 1.0, random);
}

int population_of(const GridPlanRequest& request) {
  return static_cast<int>(number(request.parameters, "population"));
}

void learn_from_any(OrderSearch& search, Population& population, int i, int among, int k) {
  if (among < 1) return;
  const int teacher = draw_below(search.random, among);
  if (teacher != i) learn(search, at(population, i), at(population, teacher), k, Keep::kNotWorse);
}

struct Transformations {
  double swap;
  double shift;
  double symmetry;
};

Transformations transformations_of(const Parameters& parameters) {
  return {number(parameters, "swap"), number(parameters, "shift"), number(parameters, "symmetry")};
}

void transform(OrderSearch& search, Individual& one, int k, const Transformations& shares) {
  const double drawn = draw_unit(search.random) * (shares.swap + shares.shift + shares.symmetry);
  const int other = draw_place(search);
  if (drawn < shares.swap) {
    try_swap(search, one, k, other, Keep::kNotWorse);
  } else if (drawn < shares.swap + shares.shift) {
    try_shift(search, one, k, other, Keep::kNotWorse);
  } else {
    try_reversal(search, one, std::min(k, other), std::max(k, other), Keep::kNotWorse);
  }
}

// Whether the node at place k is followed by the same one in both orders.
bool shares_pair(const Individual& one, const Individual& other, int k) {
  const int there = at(other.place, at(one.order, k));
  return k + 1 < static_cast<int>(one.order.size()) &&
         there + 1 < static_cast<int>(other.order.size()) &&
         at(one.order, k + 1) == at(other.order, there + 1);
}

const ParameterSpec& population_spec() {
  static const ParameterSpec kSpec{"population", 50.0, 3.0, 1000.0, {}, "individuals", true};
  return kSpec;
}

std::span<const ParameterSpec> transforming_parameters() {
  static const std::array kSpecs{
      population_spec(),
      ParameterSpec{"st1", 0.5, 0.0, 1.0, {}, "first search tendency"},
      ParameterSpec{"st2", 0.5, 0.0, 1.0, {}, "second search tendency"},
      ParameterSpec{"swap", 0.2, 0.0, 1.0, {}, "share of swaps"},
      ParameterSpec{"shift", 0.5, 0.0, 1.0, {}, "share of shifts"},
      ParameterSpec{"symmetry", 0.3, 0.0, 1.0, {}, "share of reversals; of all when all are 0"}};
  return kSpecs;
}

}  // namespace

std::span<const ParameterSpec> grid_gwo_parameters() { return {&population_spec(), 1}; }
std::span<const ParameterSpec> grid_spbo_parameters() { return {&population_spec(), 1}; }
std::span<const ParameterSpec> grid_djaya_parameters() { return transforming_parameters(); }
std::span<const ParameterSpec> grid_dtsa_parameters() { return transforming_parameters(); }

GridPlan plan_grid_gwo(const GridPlanRequest& request) {
  constexpr int kLeaders = 3;
  const auto improve = [](OrderSearch& search, Population& population, int i, const Individual&) {
    const double a = 2.0 * (1.0 - share_over(search.search));
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (std::abs(a * (2.0 * draw_unit(search.random) - 1.0)) < 1.0) {
        learn_from_any(search, population, i, kLeaders, k);
      } else {
        perturb_weakly(search, at(population, i), k, Keep::kNotWorse);
      }
    }
  };
  return plan_by_population(request,
                            {"grid_gwo", population_of(request), nearest_cell_order, improve});
}

GridPlan plan_grid_spbo(const GridPlanRequest& request) {
  const auto improve = [](OrderSearch& search, Population& population, int i,
                          const Individual& best) {
    const int size = static_cast<int>(population.size());
    const int group = 4 * i / size;
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (group == 0) {
        learn_from_any(search, population, i, size, k);
      } else if (group == 1) {
        learn(search, at(population, i), best, k, Keep::kNotWorse);
      } else if (group == 2) {
        learn_from_any(search, population, i, i, k);
      } else {
        perturb_weakly(search, at(population, i), k, Keep::kNotWorse);
      }
    }
  };
  return plan_by_population(request,
                            {"grid_spbo", population_of(request), nearest_cell_order, improve});
}

GridPlan plan_grid_djaya(const GridPlanRequest& request) {
  const Transformations shares = transformations_of(request.parameters);
  const double st1 = number(request.parameters, "st1");
  const double st2 = number(request.parameters, "st2");
  const auto improve = [&](OrderSearch& search, Population& population, int i,
                           const Individual& best) {
    const Individual& worst = population.back();
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (draw_unit(search.random) < st1) {
        learn(search, at(population, i), best, k, Keep::kNotWorse);
      }
      if (draw_unit(search.random) < st2 || shares_pair(at(population, i), worst, k)) {
        transform(search, at(population, i), k, shares);
      }
    }
  };
  return plan_by_population(request,
                            {"grid_djaya", population_of(request), nearest_cell_order, improve});
}

GridPlan plan_grid_dtsa(const GridPlanRequest& request) {
  const Transformations shares = transformations_of(request.parameters);
  const double st1 = number(request.parameters, "st1");
  const double st2 = number(request.parameters, "st2");
  const auto improve = [&](OrderSearch& search, Population& population, int i,
                           const Individual& best) {
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (draw_unit(search.random) < st1) {
        learn(search, at(population, i), best, k, Keep::kNotWorse);
      } else {
        learn_from_any(search, population, i, static_cast<int>(population.size()), k);
      }
      if (draw_unit(search.random) < st2) transform(search, at(population, i), k, shares);
    }
  };
  return plan_by_population(request,
                            {"grid_dtsa", population_of(request), nearest_cell_order, improve});
}

}  // namespace headland
