#include "planner/grid_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "planner/grid_prices.h"
#include "terrains/input_error.h"

namespace headland {

namespace {

void close(const GridPlanRequest& request, GridProblem& problem) {
  if (request.start && request.end && *request.start != *request.end) {
    throw InputError(kGridPlanSource, "end",
                     fmt::format("{}, {}", request.end->column, request.end->row),
                     fmt::format("the start, {}, {}, or none: the tour is closed",
                                 request.start->column, request.start->row));
  }
  problem.start = problem.end = std::max({problem.start, problem.end, 0});
}

}  // namespace

double repeat_rate(const GridPlan& plan) {
  return static_cast<double>(plan.counts.repeats) / plan.counts.distinct_cells;
}

GridProblem grid_problem(const GridPlanRequest& request) {
  GridProblem problem;
  problem.graph = grid_graph(request.map, kGridPlanSource);
  check_grid_cost(request.cost, kGridPlanSource, "cost");
  if (request.cost.objective == GridObjective::kMeasured) {
    problem.graph.step_wh = step_prices(*request.cost.measured, problem.graph);
  }
  check_stop(request.stop, kGridPlanSource);
  if (request.start) {
    problem.start = node_at(request.map, problem.graph, *request.start, kGridPlanSource, "start");
  }
  if (request.end) {
    problem.end = node_at(request.map, problem.graph, *request.end, kGridPlanSource, "end");
  }
  if (request.closed) close(request, problem);
  problem.closed = problem.start >= 0 && problem.start == problem.end && problem.graph.size() > 1;
  return problem;
}

PlanSearch begun_search(const GridPlanRequest& request) {
  PlanSearch search;
  search.stop = request.stop;
  search.cancelled = request.cancelled;
  return search;
}

GridPlan finished_plan(const GridPlanRequest& request, const GridProblem& problem,
                       const std::string& planner, const std::vector<int>& path,
                       const PlanSearch& search) {
  GridPlan plan;
  plan.planner = planner;
  plan.cells.reserve(path.size());
  for (const int node : path) plan.cells.push_back(at(problem.graph.cells, node));
  for (std::size_t i = 1; i < path.size(); ++i) {
    plan.jumps += direction_between(problem.graph, path[i - 1], path[i]) < 0 ? 1 : 0;
  }
  plan.counts = count_path(problem.graph, path);
  plan.cost = cost_of(request.cost, plan.counts, problem.graph.cell_m);
  plan.fitness = fitness_of(plan.cost);
  plan.convergence = search.convergence;
  plan.iterations = search.iteration;
  plan.evaluations = search.evaluations;
  plan.stopped_by = search.stopped_by.value_or(StopReason::kNothingBetter);
  return plan;
}

int first_node(const GridProblem& problem, SeededRandom& random) {
  if (problem.start >= 0) return problem.start;
  if (problem.end < 0 || problem.graph.size() == 1) return draw_below(random, problem.graph.size());
  const int drawn = draw_below(random, problem.graph.size() - 1);
  return drawn < problem.end ? drawn : drawn + 1;
}

std::vector<int> random_order(const GridProblem& problem, SeededRandom& random) {
  std::vector<int> order(problem.graph.cells.size());
  std::iota(order.begin(), order.end(), 0);
  if (problem.closed) order.push_back(problem.end);
  if (problem.start >= 0) std::swap(order.front(), *std::ranges::find(order, problem.start));
  if (problem.end >= 0) std::swap(order.back(), *std::ranges::find(order, problem.end));
  const FreePlaces places = free_places(problem);
  shuffle(random, order, places.first, places.end);
  return order;
}

FreePlaces free_places(const GridProblem& problem) {
  const int size = problem.graph.size();
  if (problem.closed) return {1, size};
  return {problem.start >= 0 ? 1 : 0, size - (problem.end >= 0 && size > 1 ? 1 : 0)};
}

}  // namespace headland
