#include "planner/order_population.h"

#include <algorithm>
#include <utility>

#include "planner/greedy_order.h"

namespace headland {
namespace {

// Changes of at most so much are kept.
double most_kept(Keep keep) { return keep == Keep::kNotWorse ? kNoChange : -kNoChange; }

void note_places(Individual& one, int i, int j) {
  for (; i <= j; ++i) at(one.place, at(one.order, i)) = i;
}

void show_next(Individual& one) {
  one.next.resize(one.place.size());
  int next = -1;
  // Backwards: of a node that stands twice the first one counts.
  for (int i = static_cast<int>(one.order.size()) - 1; i >= 0; --i) {
    at(one.next, at(one.order, i)) = next;
    next = at(one.order, i);
  }
}

// Cheapest first, costs freed of the rounding of summed changes, the best noted.
void sort_and_note(OrderSearch& search, Population& population) {
  // Sums of whole steps are exact.
  for (Individual& one : population) {
    if (!search.cost.lengths_only) one.cost = full_cost(search.cost, one.order);
  }
  std::ranges::stable_sort(population, {}, &Individual::cost);
  note_cost(search.search, population.front().cost);
}

void turn_round(Individual& one, int i, int j) {
  for (; i < j; ++i, --j) {
    const int first = at(one.order, i);
    const int last = at(one.order, j);
    at(one.order, i) = last;
    at(one.order, j) = first;
    at(one.place, last) = i;
    at(one.place, first) = j;
  }
}

bool may_change(const OrderSearch& search, int i, int j) {
  return i != j && std::min(i, j) >= search.places.first && std::max(i, j) < search.places.end;
}

}  // namespace

Individual individual_of(const OrderCost& cost, std::vector<int> order) {
  Individual one;
  one.order = std::move(order);
  one.place.resize(cost.graph->cells.size());
  for (int i = static_cast<int>(one.order.size()) - 1; i >= 0; --i) {
    at(one.place, at(one.order, i)) = i;
  }
  show_next(one);
  one.cost = full_cost(cost, one.order);
  return one;
}

OrderSearch order_search(OrderTask& task) {
  return {task.cost, free_places(task.problem), task.random, task.search};
}

bool try_reversal(OrderSearch& search, Individual& one, int i, int j, Keep keep) {
  if (i >= j || !may_change(search, i, j)) return false;
  ++search.search.evaluations;
  const double change = change_by_reversal(search.cost, one.order, i, j, most_kept(keep));
  if (change > most_kept(keep)) return false;
  turn_round(one, i, j);
  one.cost += change;
  return true;
}

bool try_swap(OrderSearch& search, Individual& one, int i, int j, Keep keep) {
  if (!may_change(search, i, j)) return false;
  ++search.search.evaluations;
  const double change = change_by_swap(search.cost, one.order, i, j);
  if (change > most_kept(keep)) return false;
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
  if (change > most_kept(keep)) return false;
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
  const int wanted = at(teacher.next, at(one.order, k));
  const int size = static_cast<int>(one.order.size());
  // Most have learned it already; this spares them a look into `place`.
  if (wanted < 0 || (k + 1 < size && at(one.order, k + 1) == wanted)) return false;
  const int learned = at(one.place, wanted);
  const bool later = learned > k;
  return try_reversal(search, one, later ? k + 1 : learned, later ? learned : k - 1, keep);
}

bool learn_from_any(OrderSearch& search, Population& population, int i, int among, int k,
                    Keep keep) {
  if (among < 1) return false;
  const int teacher = draw_below(search.random, among);
  return teacher != i && learn(search, at(population, i), at(population, teacher), k, keep);
}

int draw_place(OrderSearch& search) {
  return search.places.first + draw_below(search.random, search.places.end - search.places.first);
}

void evolve(OrderTask& task, Population& population, const Improve& improve) {
  OrderSearch search = order_search(task);
  sort_and_note(search, population);
  while (search.places.end - search.places.first > 1 && next_iteration(task.search)) {
    for (int i = 0; i < static_cast<int>(population.size()) && goes_on(task.search); ++i) {
      improve(search, population, i);
    }
    for (Individual& one : population) show_next(one);
    sort_and_note(search, population);
  }
}

const ParameterSpec& population_spec() {
  static const ParameterSpec kSpec{"population", 50.0, 3.0, 1000.0, {}, "individuals", true};
  return kSpec;
}

int population_of(const Parameters& parameters) {
  return static_cast<int>(number(parameters, "population"));
}

std::vector<int> nearest_cell_order(const GridProblem& problem, const DistanceTable& table,
                                    SeededRandom& random) {
  return greedy_order(problem, table, 1.0, 1.0, random);
}

GridPlan plan_by_population(const GridPlanRequest& request, const PopulationPlanner& planner) {
  OrderTask task(request);
  Population population;
  for (int i = 0; i < planner.size; ++i) {
    stop_if(request.cancelled);
    population.push_back(
        individual_of(task.cost, planner.begin(task.problem, task.table, task.random)));
    ++task.search.evaluations;
  }
  evolve(task, population, planner.improve);
  return finished_plan(task, planner.name, population.front().order);
}

}  // namespace headland
