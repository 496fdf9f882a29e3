#include "planner/algorithms/grid_ant_colony.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "planner/order_cost.h"

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
  const double drawn = draw_unit(colony.random) * sum;
  const auto found = std::ranges::upper_bound(colony.shares, drawn);
  return near[static_cast<std::size_t>(found - colony.shares.begin())];
}

std::vector<int> order_of_ant(Colony& colony) {
  const GridProblem& problem = colony.problem;
  const int start =
      problem.start >= 0 ? problem.start : draw_below(colony.random, problem.graph.size());
  const bool end_waits = problem.end >= 0 && problem.end != start;
  std::ranges::fill(colony.visited, char{0});
  at(colony.visited, start) = 1;
  if (end_waits) at(colony.visited, problem.end) = 1;
  std::vector<int> order = {start};
  while (static_cast<int>(order.size()) < problem.graph.size() - (end_waits ? 1 : 0)) {
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

Colony begun_colony(const GridPlanRequest& request, const GridProblem& problem,
                    const DistanceTable& table, SeededRandom& random) {
  Colony colony{problem,
                table,
                nodes_within(problem.graph, kAntSteps),
                {},
                {},
                number(request.parameters, "alpha"),
                number(request.parameters, "beta"),
                random,
                BreadthFirst(problem.graph),
                std::vector<char>(problem.graph.cells.size(), 0),
                {}};
  for (const std::vector<int>& near : colony.near) {
    colony.pheromone.emplace_back(near.size(), 1.0);
  }
  colony.attraction = colony.pheromone;
  return colony;
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

GridPlan plan_grid_aco(const GridPlanRequest& request) {
  const GridProblem problem = grid_problem(request);
  const DistanceTable table = distance_table(problem.graph, kGridPlanSource, request.cancelled);
  const OrderCost cost = order_cost(problem.graph, table, request.cost);
  const int ants = static_cast<int>(number(request.parameters, "ants"));
  SeededRandom random(request.seed);
  GridSearch search = begun_search(request);
  Colony colony = begun_colony(request, problem, table, random);
  std::vector<int> best = order_of_ant(colony);
  ++search.evaluations;
  note_cost(search, full_cost(cost, best));
  while (next_iteration(search)) {
    renew_attraction(colony);
    std::vector<std::vector<int>> orders;
    for (int i = 0; i < ants && goes_on(search); ++i) orders.push_back(order_of_ant(colony));
    evaporate(colony, number(request.parameters, "evaporation"));
    for (const std::vector<int>& order : orders) {
      const double order_costs = full_cost(cost, order);
      ++search.evaluations;
      if (note_cost(search, order_costs)) best = order;
      lay_pheromone(colony, order,
                    number(request.parameters, "enhancement") / std::max(order_costs, kLeastCost));
    }
  }
  return finished_plan(request, problem, "grid_aco", expanded(problem.graph, table, best), search);
}

}  // namespace headland
