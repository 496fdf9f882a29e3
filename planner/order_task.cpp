#include "planner/order_task.h"

#include "planner/grid_bound.h"

namespace headland {

namespace {

DistanceTable table_for(const GridGraph& graph, Tables tables, const CancelAsked& cancelled) {
  if (tables == Tables::kLocalWhereLarge && graph.size() > kMaxTableNodes) {
    return local_distances(graph, cancelled);
  }
  return distance_table(graph, kGridPlanSource, cancelled);
}

}  // namespace

OrderTask::OrderTask(const GridPlanRequest& asked, Tables tables)
    : request(asked),
      problem(grid_problem(asked)),
      table(table_for(problem.graph, tables, asked.cancelled)),
      cost(order_cost(problem.graph, table, asked.cost)),
      random(asked.seed),
      search(begun_search(asked)) {
  if (!cost.lengths_only || table.steps.empty()) return;
  search.least = cost.shares.constant + cost.shares.step * least_steps(problem, asked.cancelled);
}

std::vector<int> first_visits(const OrderTask& task, std::span<const GridCell> cells) {
  const GridProblem& problem = task.problem;
  std::vector<char> waits(problem.graph.cells.size(), 1);
  if (problem.end >= 0) at(waits, problem.end) = 0;
  std::vector<int> order;
  if (problem.closed) order.push_back(problem.start);
  for (const GridCell cell : cells) {
    const int node = at(problem.graph.node_of, static_cast<int>(index_of(task.request.map, cell)));
    if (at(waits, node) != 0) order.push_back(node);
    at(waits, node) = 0;
  }
  if (problem.end >= 0) order.push_back(problem.end);
  return order;
}

GridPlan finished_plan(const OrderTask& task, const std::string& planner,
                       std::span<const int> order) {
  return finished_plan(task.request, task.problem, planner, expanded(task.cost, order),
                       task.search);
}

}  // namespace headland
