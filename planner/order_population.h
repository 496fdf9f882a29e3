// Orders of cells that learn from each other and are perturbed: what several planners search with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "planner/order_task.h"

namespace headland {

struct Individual {
  std::vector<int> order;
  std::vector<int> place;  // of each node in `order`, its first where a closed tour has two
  // What others learn from: the node that followed each one when the iteration began, -1: none.
  std::vector<int> next;
  double cost = 0.0;
};

using Population = std::vector<Individual>;

Individual individual_of(const OrderCost& cost, std::vector<int> order);

// What searches over individuals share; not owned.
struct OrderSearch {
  const OrderCost& cost;
  FreePlaces places;  // nothing outside of them is changed
  SeededRandom& random;
  PlanSearch& search;
};

OrderSearch order_search(OrderTask& task);

// Which changes are kept.
enum class Keep { kBetter, kNotWorse };

// Each tries one change, counts it as an evaluation, and says whether it was kept. Changes that
// are none or reach outside the places are not tried.

// Turns order[i] .. order[j] round.
bool try_reversal(OrderSearch& search, Individual& one, int i, int j, Keep keep);
// order[i] and order[j] change places.
bool try_swap(OrderSearch& search, Individual& one, int i, int j, Keep keep);
// order[i] goes to place j; those between move up.
bool try_shift(OrderSearch& search, Individual& one, int i, int j, Keep keep);

// The operators of Wang et al. 2025 (10.20944/preprints202504.0101.v1), 4.2, at place k: strong
// perturbation (Figure 3: swap with a random place), weak perturbation (Figure 4: turn round what
// lies between it and a random place), and learning (Figure 5): the node that followed order[k] in
// `teacher` when the iteration began comes beside it, by turning round the section between, which
// must not contain order[k].
bool perturb_strongly(OrderSearch& search, Individual& one, int k, Keep keep);
bool perturb_weakly(OrderSearch& search, Individual& one, int k, Keep keep);
bool learn(OrderSearch& search, Individual& one, const Individual& teacher, int k, Keep keep);

// Individual i learns from one drawn of the first `among`, from itself nothing.
bool learn_from_any(OrderSearch& search, Population& population, int i, int among, int k,
                    Keep keep);

int draw_place(OrderSearch& search);

// Works on population[i] for one iteration, at whose beginning the population was sorted, the best
// first.
using Improve = std::function<void(OrderSearch&, Population& population, int i)>;

// Improves the population, iteration by iteration and one individual after the other, until the
// task's search ends. Cheapest first, the best noted, before and after. Throws Cancelled.
void evolve(OrderTask& task, Population& population, const Improve& improve);

// A planner of which this is all.
struct PopulationPlanner {
  std::string name;
  int size = 50;
  // A first order.
  std::function<std::vector<int>(const GridProblem&, const DistanceTable&, SeededRandom&)> begin;
  Improve improve;
};

// `population`, of planners that sort it into ranks or leaders; and begin for those that take the
// paper's initialisation at its alpha_g of 1.
const ParameterSpec& population_spec();
int population_of(const Parameters& parameters);
std::vector<int> nearest_cell_order(const GridProblem& problem, const DistanceTable& table,
                                    SeededRandom& random);

// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_by_population(const GridPlanRequest& request, const PopulationPlanner& planner);

}  // namespace headland
