// Orders of cells that learn from each other and are perturbed: what several planners search with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "planner/grid_plan.h"
#include "planner/order_cost.h"

namespace headland {

struct Individual {
  std::vector<int> order;
  std::vector<int> place;  // of each node in `order`
  double cost = 0.0;
};

Individual individual_of(const OrderCost& cost, std::vector<int> order);

// No order costs less, by least_steps; minus infinity where not length alone counts.
double least_cost(const GridProblem& problem, const OrderCost& cost);

// What searches over individuals share; not owned.
struct OrderSearch {
  const OrderCost& cost;
  FreePlaces places;  // nothing outside of them is changed
  SeededRandom& random;
  GridSearch& search;
};

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
// lies between it and a random place), and learning (Figure 5): the node that follows order[k] in
// `teacher` comes beside it, by turning round the section between, which must not contain order[k].
bool perturb_strongly(OrderSearch& search, Individual& one, int k, Keep keep);
bool perturb_weakly(OrderSearch& search, Individual& one, int k, Keep keep);
bool learn(OrderSearch& search, Individual& one, const Individual& teacher, int k, Keep keep);

int draw_place(OrderSearch& search);

// A search that improves individuals one after the other, iteration by iteration. `improve` works
// on population[i], which is sorted at the iteration's beginning; best is the first as it was then.
struct PopulationPlanner {
  std::string name;
  int size = 50;
  // A first order.
  std::function<std::vector<int>(const GridProblem&, const DistanceTable&, SeededRandom&)> begin;
  std::function<void(OrderSearch&, std::vector<Individual>& population, int i,
                     const Individual& best)>
      improve;
};

// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_by_population(const GridPlanRequest& request, const PopulationPlanner& planner);

// Cheapest first, costs freed of the rounding of summed changes, the best noted.
void sort_and_note(OrderSearch& search, std::vector<Individual>& population);

}  // namespace headland
