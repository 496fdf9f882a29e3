#include "planner/algorithms/grid_local_search.h"

#include <array>
#include <utility>
#include <vector>

#include "planner/algorithms/grid_boustrophedon.h"
#include "planner/order_descent.h"
#include "planner/order_population.h"

namespace headland {
namespace {

constexpr int kKicksPerCheck = 64;  // between questions whether to go on

// Whether distances are known between near cells only.
bool is_local(const OrderTask& task) { return task.table.steps.empty(); }

// Kicks once and keeps what comes of it unless it is costlier; by how much the cost changed.
double kick_and_descend(Descent& descent, int most_cells, OrderTask& task) {
  descent.done.clear();
  descent.change = 0.0;
  kick(descent, most_cells, task.random);
  descend(descent, task.search);
  if (descent.change <= kNoChange) return descent.change;
  take_back(descent);
  return 0.0;
}

// The cells in the order in which boustrophedon comes to them first.
std::vector<int> row_by_row_order(const OrderTask& task) {
  GridPlanRequest request = task.request;
  request.parameters.clear();
  return first_visits(task, plan_grid_boustrophedon(request).cells);
}

// Another greedy order, where there is a table of all distances.
std::vector<int> first_order(OrderTask& task) {
  return is_local(task) ? row_by_row_order(task)
                        : nearest_cell_order(task.problem, task.table, task.random);
}

// As many kicks as there are cells; whether the order became cheaper. `cost` is the order's.
bool improve_for_an_iteration(Descent& descent, OrderTask& task, int kick_cells, double& cost) {
  const double before = cost;
  for (int kicks = 0; kicks < task.problem.graph.size(); ++kicks) {
    if ((kicks % kKicksPerCheck == 0 || is_spent(descent)) && !goes_on(task.search)) break;
    cost += kick_and_descend(descent, kick_cells, task);
    task.search.evaluations = descent.evaluations;
    note_cost(task.search, cost);
  }
  // Sums of changes are rounded.
  cost = full_cost(task.cost, descent.order);
  return cost < before - kNoChange;
}

// The plan, whose search had distances that may be too small, or what it began with if that is
// cheaper. Costs on the way are not known; what it began and ended with is.
GridPlan better_of_local(const OrderTask& task, GridPlan plan) {
  GridPlanRequest request = task.request;
  request.parameters.clear();
  GridPlan first = plan_grid_boustrophedon(request);
  if (first.cost <= plan.cost) {
    plan.cells = std::move(first.cells);
    plan.counts = first.counts;
    plan.cost = first.cost;
    plan.fitness = first.fitness;
  }
  plan.convergence = {{0, 1, first.cost}};
  if (plan.cost < first.cost) {
    plan.convergence.push_back({plan.iterations, plan.evaluations, plan.cost});
  }
  return plan;
}

}  // namespace

std::span<const ParameterSpec> grid_local_search_parameters() {
  static const std::array kSpecs{
      ParameterSpec{"kick_cells", 30.0, 1.0, 1000.0, {}, "most cells of a section kicked", true},
      ParameterSpec{
          "patience", 5.0, 1.0, 1e6, {}, "iterations without gain before it begins anew", true}};
  return kSpecs;
}

GridPlan plan_grid_local_search(const GridPlanRequest& request) {
  OrderTask task(request, Tables::kLocalWhereLarge);
  PlanSearch& search = task.search;
  const int kick_cells = static_cast<int>(number(request.parameters, "kick_cells"));
  const int patience = static_cast<int>(number(request.parameters, "patience"));
  Descent descent = descent_for(task);
  set_order(descent, first_order(task));
  std::vector<int> best = descent.order;
  double best_cost = full_cost(task.cost, best);
  note_cost(search, best_cost);
  const bool can_change = descent.places.end - descent.places.first > 1;
  while (can_change && goes_on(search)) {
    descend(descent, search);
    double now = full_cost(task.cost, descent.order);
    search.evaluations = descent.evaluations;
    note_cost(search, now);
    for (int idle = 0; idle < patience && next_iteration(search); ++idle) {
      if (improve_for_an_iteration(descent, task, kick_cells, now)) idle = 0;
    }
    if (now < best_cost - kNoChange) {
      best = descent.order;
      best_cost = now;
    }
    if (search.stopped_by) break;
    set_order(descent, first_order(task));
  }
  search.evaluations = descent.evaluations;
  GridPlan plan = finished_plan(task, "grid_local_search", best);
  return is_local(task) ? better_of_local(task, std::move(plan)) : plan;
}

}  // namespace headland
