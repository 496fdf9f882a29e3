#include "planner/algorithms/grid_ant_colony.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace headland {
namespace {

struct Colony {
  const GridProblem& problem;
  const DistanceTable& table;
  std::vector<std::vector<int>> near;           // by node
  std::vector<std::vector<double>> pheromone;   // on the ways to them
  std::vector<std::vector<double>> attraction;  // tau^alpha / d^beta
  double alpha;
  double beta;
  SeededRandom& random;
  BreadthFirst search;
  std::vector<char> visited;
  std::vector<double> shares;  // of the near ones, for one step
};

void renew_attraction(Colony& colony) {
  for (int node = 0; node < colony.table.nodes; ++node) {
    for (std::size_t k = 0; k < at(colony.near, node).size(); ++k) {
      const int steps = colony.table(node, at(colony.near, node)[k]);
      at(colony.attraction, node)[k] =
          std::pow(at(colony.pheromone, node)[k], colony.alpha) * std::pow(steps, -colony.beta);
    }
  }
}

int next_of_ant(Colony& colony, int node) {
  const std::vector<int>& near = at(colony.near, node);
  double sum = 0.0;
  colony.shares.clear();
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (at(colony.visited, near[k]) == 0) sum += at(colony.attraction, node)[k];
    colony.shares.push_back(sum);
  }
  if (!(sum > 0.0)) {
    const auto way = way_to(colony.search, node, {0, 1, 2, 3},
                            [&](int other) { return at(colony.visited, other) == 0; });
    return way.back();
  }
  return at(near, draw_by_sums(colony.random, colony.shares));
}

std::vector<int> order_of_ant(Colony& colony) {
  const GridProblem& problem = colony.problem;
  const int start = first_node(problem, colony.random);
  const bool end_waits = problem.end >= 0 && problem.graph.size() > 1;
  std::ranges::fill(colony.visited, char{0});
  at(colony.visited, start) = 1;
  if (end_waits) at(colony.visited, problem.end) = 1;
  std::vector<int> order = {start};
  for (auto left = std::ranges::count(colony.visited, 0); left > 0; --left) {
    order.push_back(next_of_ant(colony, order.back()));
    at(colony.visited, order.back()) = 1;
  }
  if (end_waits) order.push_back(problem.end);
  return order;
}

void lay_pheromone(Colony& colony, const std::vector<int>& order, double amount) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    for (const auto& [from, to] :
         {std::pair{order[i - 1], order[i]}, std::pair{order[i], order[i - 1]}}) {
      const std::vector<int>& near = at(colony.near, from);
      const auto found = std::ranges::find(near, to);
      if (found == near.end()) continue;
      at(at(colony.pheromone, from), static_cast<int>(found - near.begin())) += amount;
    }
  }
}

void evaporate(Colony& colony, double share) {
  for (std::vector<double>& ways : colony.pheromone) {
    for (double& amount : ways) amount *= 1.0 - share;
  }
}

Colony begun_colony(OrderTask& task, const Parameters& parameters) {
  const GridGraph& graph = task.problem.graph;
  Colony colony{task.problem,
                task.table,
                nodes_within(graph, kAntSteps),
                {},
                {},
                number(parameters, "alpha"),
                number(parameters, "beta"),
                task.random,
                BreadthFirst(graph),
                std::vector<char>(graph.cells.size(), 0),
                {}};
  for (const std::vector<int>& near : colony.near) {
    colony.pheromone.emplace_back(near.size(), 1.0);
  }
  colony.attraction = colony.pheromone;
  renew_attraction(colony);
  return colony;
}

// Lays the pheromone of orders and notes their costs; the best that was found so far.
void judge(OrderTask& task, Colony& colony, const Parameters& parameters,
           const std::vector<std::vector<int>>& orders, std::vector<int>& best) {
  for (const std::vector<int>& order : orders) {
    const double order_costs = full_cost(task.cost, order);
    ++task.search.evaluations;
    if (note_cost(task.search, order_costs)) best = order;
    lay_pheromone(colony, order,
                  number(parameters, "enhancement") / std::max(order_costs, kLeastCost));
  }
}

}  // namespace

std::span<const ParameterSpec> grid_aco_parameters() {
  static const std::array kSpecs{
      ParameterSpec{"ants", 50.0, 1.0, 1000.0, {}, "ants an iteration", true},
      ParameterSpec{"alpha", 1.0, 0.0, 10.0, {}, "exponent of pheromone"},
      ParameterSpec{"beta", 5.0, 0.0, 20.0, {}, "exponent of nearness"},
      ParameterSpec{"evaporation", 0.1, 0.0, 0.99, {}, "share of pheromone lost an iteration"},
      ParameterSpec{"enhancement", 100.0, 0.0, 1e6, {}, "pheromone an ant lays, times its cost"}};
  return kSpecs;
}

std::vector<std::vector<int>> first_ants(OrderTask& task, const Parameters& parameters) {
  Colony colony = begun_colony(task, parameters);
  std::vector<std::vector<int>> orders;
  for (int i = 0; i < static_cast<int>(number(parameters, "ants")); ++i) {
    stop_if(task.request.cancelled);
    orders.push_back(order_of_ant(colony));
  }
  return orders;
}

std::vector<int> best_of_ants(OrderTask& task, const Parameters& parameters,
                              const std::vector<std::vector<int>>& first) {
  Colony colony = begun_colony(task, parameters);
  std::vector<int> best;
  judge(task, colony, parameters, first, best);
  while (next_iteration(task.search)) {
    renew_attraction(colony);
    std::vector<std::vector<int>> orders;
    for (int i = 0; i < static_cast<int>(first.size()) && goes_on(task.search); ++i) {
      orders.push_back(order_of_ant(colony));
    }
    evaporate(colony, number(parameters, "evaporation"));
    judge(task, colony, parameters, orders, best);
  }
  return best;
}

GridPlan plan_grid_aco(const GridPlanRequest& request) {
  OrderTask task(request);
  const auto first = first_ants(task, request.parameters);
  return finished_plan(task, "grid_aco", best_of_ants(task, request.parameters, first));
}

}  // namespace headland
