#include "planner/greedy_order.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// A cell not yet visited among the nearest, each as likely.
int nearest_of_rest(const GridGraph& graph, const DistanceTable& table, int from,
                    const std::vector<int>& rest, const std::vector<int>& place_in_rest,
                    SeededRandom& random) {
  int ties = 0;
  int chosen = -1;
  const auto take = [&](int node) {
    if (draw_below(random, ++ties) == 0) chosen = node;
  };
  for (const int beside : at(graph.beside, from)) {
    if (beside >= 0 && at(place_in_rest, beside) >= 0) take(beside);
  }
  if (chosen >= 0) return chosen;
  int nearest = table.nodes;
  for (const int node : rest) nearest = std::min(nearest, table(from, node));
  for (const int node : rest) {
    if (table(from, node) == nearest) take(node);
  }
  return chosen;
}

// One of the rest with probability in proportion to weight[steps away].
int drawn_of_rest(const DistanceTable& table, int from, const std::vector<int>& rest,
                  const std::vector<double>& weight, SeededRandom& random) {
  double sum = 0.0;
  for (const int node : rest) sum += at(weight, table(from, node));
  double left = draw_unit(random) * sum;
  for (const int node : rest) {
    left -= at(weight, table(from, node));
    if (left < 0.0) return node;
  }
  return rest.back();
}

}  // namespace

std::vector<int> greedy_order(const GridProblem& problem, const DistanceTable& table,
                              double greediness, double lambda, SeededRandom& random) {
  if (draw_unit(random) >= greediness) return random_order(problem, random);
  std::vector<double> weight(1, 0.0);
  if (greediness < 1.0) {
    const int most = *std::ranges::max_element(table.steps);
    for (int steps = 1; steps <= most; ++steps) weight.push_back(std::pow(steps, -lambda));
  }
  const int start = first_node(problem, random);
  std::vector<int> rest;
  std::vector<int> place_in_rest(problem.graph.cells.size(), -1);
  for (int node = 0; node < problem.graph.size(); ++node) {
    if (node == start || node == problem.end) continue;
    at(place_in_rest, node) = static_cast<int>(rest.size());
    rest.push_back(node);
  }
  std::vector<int> order = {start};
  while (!rest.empty()) {
    const int from = order.back();
    const int next = draw_unit(random) < greediness
                         ? nearest_of_rest(problem.graph, table, from, rest, place_in_rest, random)
                         : drawn_of_rest(table, from, rest, weight, random);
    order.push_back(next);
    at(place_in_rest, rest.back()) = at(place_in_rest, next);
    at(rest, at(place_in_rest, next)) = rest.back();
    rest.pop_back();
    at(place_in_rest, next) = -1;
  }
  if (problem.end >= 0 && problem.graph.size() > 1) order.push_back(problem.end);
  return order;
}

}  // namespace headland
