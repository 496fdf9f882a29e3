#include "planner/order_task.h"

#include "planner/grid_bound.h"

namespace headland {

OrderTask::OrderTask(const GridPlanRequest& asked)
    : request(asked),
      problem(grid_problem(asked)),
      table(distance_table(problem.graph, kGridPlanSource, asked.cancelled)),
      cost(order_cost(problem.graph, table, asked.cost)),
      random(asked.seed),
      search(begun_search(asked)) {
  if (!cost.lengths_only) return;
  search.least = cost.shares.constant + cost.shares.step * least_steps(problem, asked.cancelled);
}

GridPlan finished_plan(const OrderTask& task, const std::string& planner,
                       std::span<const int> order) {
  return finished_plan(task.request, task.problem, planner, expanded(task.cost, order),
                       task.search);
}

}  // namespace headland
