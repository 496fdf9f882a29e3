#include "planner/order_population.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace headland {
namespace {

bool is_kept(double change, Keep keep) {
  return keep == Keep::kNotWorse ? change <= kNoChange : change < -kNoChange;
}

void note_places(Individual& one, int i, int j) {
  for (; i <= j; ++i) at(one.place, at(one.order, i)) = i;
}

bool may_change(const OrderSearch& search, int i, int j) {
  return i != j && std::min(i, j) >= search.places.first && std::max(i, j) < search.places.end;
}

}  // namespace

Individual individual_of(const OrderCost& cost, std::vector<int> order) {
  Individual one;
  one.order = std::move(order);
  one.place.resize(one.order.size());
  note_places(one, 0, static_cast<int>(one.order.size()) - 1);
  one.cost = full_cost(cost, one.order);
  return one;
}

double least_cost(const GridProblem& problem, const OrderCost& cost) {
  if (!cost.lengths_only) return -std::numeric_limits<double>::infinity();
  return cost.shares.constant + cost.shares.step * least_steps(problem);
}

bool try_reversal(OrderSearch& search, Individual& one, int i, int j, Keep keep) {
  if (i >= j || !may_change(search, i, j)) return false;
  ++search.search.evaluations;
  const double change = change_by_reversal(search.cost, one.order, i, j);
  if (!is_kept(change, keep)) return false;
  std::reverse(one.order.begin() + i, one.order.begin() + j + 1);
  note_places(one, i, j);
  one.cost += change;
  return true;
}

bool try_swap(OrderSearch& search, Individual& one, int i, int j, Keep keep) {
  if (!may_change(search, i, j)) return false;
  ++search.search.evaluations;
  const double change = change_by_swap(search.cost, one.order, i, j);
  if (!is_kept(change, keep)) return false;
  std::swap(at(one.order, i), at(one.order, j));
  note_places(one, i, i);
  note_places(one, j, j);
  one.cost += change;
  return true;
}

bool try_shift(OrderSearch& search, Individual& one, int i, int j, Keep keep) {
  if (!may_change(search, i, j)) return false;
  ++search.search.evaluations;
  const int to = j > i ? j : j - 1;
  const double change = change_by_move(search.cost, one.order, i, i, to, false);
  if (!is_kept(change, keep)) return false;
  move_section(one.order, i, i, to, false);
  note_places(one, std::min(i, j), std::max(i, j));
  one.cost += change;
  return true;
}

bool perturb_strongly(OrderSearch& search, Individual& one, int k, Keep keep) {
  return try_swap(search, one, k, draw_place(search), keep);
}

bool perturb_weakly(OrderSearch& search, Individual& one, int k, Keep keep) {
  const int other = draw_place(search);
  return try_reversal(search, one, std::min(k, other), std::max(k, other), keep);
}

bool learn(OrderSearch& search, Individual& one, const Individual& teacher, int k, Keep keep) {
  const int after = at(teacher.place, at(one.order, k)) + 1;
  if (after >= static_cast<int>(teacher.order.size())) return false;
  const int learned = at(one.place, at(teacher.order, after));
  return learned > k ? try_reversal(search, one, k + 1, learned, keep)
                     : try_reversal(search, one, learned, k - 1, keep);
}

int draw_place(OrderSearch& search) {
  return search.places.first + draw_below(search.random, search.places.end - search.places.first);
}

void sort_and_note(OrderSearch& search, std::vector<Individual>& population) {
  // Sums of whole steps are exact.
  for (Individual& one : population) {
    if (!search.cost.lengths_only) one.cost = full_cost(search.cost, one.order);
  }
  std::ranges::stable_sort(population, {}, &Individual::cost);
  note_cost(search.search, population.front().cost);
}

GridPlan plan_by_population(const GridPlanRequest& request, const PopulationPlanner& planner) {
  const GridProblem problem = grid_problem(request);
  const DistanceTable table = distance_table(problem.graph, kGridPlanSource, request.cancelled);
  const OrderCost cost = order_cost(problem.graph, table, request.cost);
  SeededRandom random(request.seed);
  GridSearch search = begun_search(request);
  search.least = least_cost(problem, cost);
  OrderSearch orders{cost, free_places(problem), random, search};
  std::vector<Individual> population;
  for (int i = 0; i < planner.size; ++i) {
    stop_if(request.cancelled);
    population.push_back(individual_of(cost, planner.begin(problem, table, random)));
    ++search.evaluations;
  }
  sort_and_note(orders, population);
  while (orders.places.end - orders.places.first > 1 && next_iteration(search)) {
    const Individual best = population.front();
    for (int i = 0; i < planner.size && goes_on(search); ++i) {
      planner.improve(orders, population, i, best);
    }
    sort_and_note(orders, population);
  }
  return finished_plan(request, problem, planner.name,
                       expanded(problem.graph, table, population.front().order), search);
}

}  // namespace headland
