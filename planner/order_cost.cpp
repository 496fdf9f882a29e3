#include "planner/order_cost.h"

#include <algorithm>
#include <utility>

namespace headland {
namespace {

// The way between two nodes: what it costs by itself, and its first and last directions.
struct Leg {
  double cost = 0.0;
  int first = 0;
  int last = 0;
};

double turn_cost(const CostShares& shares, int one, int next) {
  if (is_turn(one, next)) return shares.turn;
  return is_u_turn(one, next) ? shares.u_turn : 0.0;
}

double step_cost(const OrderCost& cost, int from, int to) {
  if (cost.graph->height_m.empty()) return cost.shares.step;
  const StepSlope slope = slope_of_step(*cost.graph, from, to);
  return cost.shares.step + cost.shares.level * slope.level_m + cost.shares.climb * slope.climb_m;
}

Leg leg_between(const OrderCost& cost, int from, int to) {
  const int beside = direction_between(*cost.graph, from, to);
  if (beside >= 0) return {step_cost(cost, from, to), beside, beside};
  // Ways are the same in both directions, so that turning a section round leaves its cost.
  thread_local std::vector<int> way;
  way.assign(1, from);
  append_way(*cost.graph, *cost.table, from, to, way);
  Leg leg;
  int before = -1;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int direction = direction_between(*cost.graph, way[i - 1], way[i]);
    leg.cost += step_cost(cost, way[i - 1], way[i]);
    if (before < 0) {
      leg.first = direction;
    } else {
      leg.cost += turn_cost(cost.shares, before, direction);
    }
    before = direction;
  }
  leg.last = before;
  return leg;
}

// How many places before and after a changed one have to be looked at.
int reach_of(const OrderCost& cost) { return cost.lengths_only ? 1 : 2; }

// Nodes of a section with their surroundings; places outside the order are left out.
void take(const std::vector<int>& order, int from, int to, std::vector<int>& nodes) {
  const int last = static_cast<int>(order.size()) - 1;
  for (int i = std::max(0, from); i <= std::min(last, to); ++i) nodes.push_back(at(order, i));
}

void take_turned(const std::vector<int>& order, int from, int to, std::vector<int>& nodes) {
  for (int i = to; i >= from; --i) nodes.push_back(at(order, i));
}

// A list that is filled anew by each change looked at.
std::vector<int>& cleared(std::vector<int>& nodes) {
  nodes.clear();
  return nodes;
}

thread_local std::vector<int> old_nodes;
thread_local std::vector<int> new_nodes;

double change_of_window(const OrderCost& cost, const std::vector<int>& order, int from, int to) {
  take(order, from, to, cleared(old_nodes));
  return section_cost(cost, new_nodes) - section_cost(cost, old_nodes);
}

}  // namespace

OrderCost order_cost(const GridGraph& graph, const DistanceTable& table, const GridCost& cost) {
  OrderCost result{&graph, &table, cost_shares(cost, graph), true};
  const CostShares& shares = result.shares;
  result.lengths_only =
      !(shares.turn > 0.0 || shares.u_turn > 0.0 || shares.level > 0.0 || shares.climb > 0.0);
  return result;
}

double full_cost(const OrderCost& cost, const std::vector<int>& order) {
  return cost.shares.constant + section_cost(cost, order);
}

double section_cost(const OrderCost& cost, std::span<const int> nodes) {
  if (cost.lengths_only) {
    int steps = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) steps += (*cost.table)(nodes[i - 1], nodes[i]);
    return cost.shares.step * steps;
  }
  double sum = 0.0;
  int before = -1;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Leg leg = leg_between(cost, nodes[i - 1], nodes[i]);
    if (before >= 0) sum += turn_cost(cost.shares, before, leg.first);
    sum += leg.cost;
    before = leg.last;
  }
  return sum;
}

double change_by_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j) {
  if (cost.lengths_only) {
    const int last = static_cast<int>(order.size()) - 1;
    const DistanceTable& steps = *cost.table;
    int change = 0;
    if (i > 0)
      change += steps(at(order, i - 1), at(order, j)) - steps(at(order, i - 1), at(order, i));
    if (j < last)
      change += steps(at(order, i), at(order, j + 1)) - steps(at(order, j), at(order, j + 1));
    return cost.shares.step * change;
  }
  if (j - i <= 2) {
    take(order, i - 2, i - 1, cleared(new_nodes));
    take_turned(order, i, j, new_nodes);
    take(order, j + 1, j + 2, new_nodes);
    return change_of_window(cost, order, i - 2, j + 2);
  }
  take(order, i - 2, i - 1, cleared(new_nodes));
  take_turned(order, j - 1, j, new_nodes);
  double change = change_of_window(cost, order, i - 2, i + 1);
  take_turned(order, i, i + 1, cleared(new_nodes));
  take(order, j + 1, j + 2, new_nodes);
  change += change_of_window(cost, order, j - 1, j + 2);
  return change;
}

double change_by_swap(const OrderCost& cost, const std::vector<int>& order, int i, int j) {
  if (i == j) return 0.0;
  if (i > j) std::swap(i, j);
  const int reach = reach_of(cost);
  if (j - i <= reach) {
    take(order, i - reach, i - 1, cleared(new_nodes));
    new_nodes.push_back(at(order, j));
    take(order, i + 1, j - 1, new_nodes);
    new_nodes.push_back(at(order, i));
    take(order, j + 1, j + reach, new_nodes);
    return change_of_window(cost, order, i - reach, j + reach);
  }
  take(order, i - reach, i - 1, cleared(new_nodes));
  new_nodes.push_back(at(order, j));
  take(order, i + 1, i + reach, new_nodes);
  double change = change_of_window(cost, order, i - reach, i + reach);
  take(order, j - reach, j - 1, cleared(new_nodes));
  new_nodes.push_back(at(order, i));
  take(order, j + 1, j + reach, new_nodes);
  change += change_of_window(cost, order, j - reach, j + reach);
  return change;
}

double change_by_move(const OrderCost& cost, const std::vector<int>& order, int i, int j, int to,
                      bool turned_round) {
  const int reach = reach_of(cost);
  const auto take_section = [&] {
    if (turned_round) {
      take_turned(order, i, j, new_nodes);
    } else {
      take(order, i, j, new_nodes);
    }
  };
  const auto take_rest = [&](int from, int until) { take(order, from, until, new_nodes); };
  if (to > j && to <= j + reach) {
    take(order, i - reach, i - 1, cleared(new_nodes));
    take_rest(j + 1, to);
    take_section();
    take_rest(to + 1, to + reach);
    return change_of_window(cost, order, i - reach, to + reach);
  }
  if (to < i && to >= i - 1 - reach) {
    take(order, to + 1 - reach, to, cleared(new_nodes));
    take_section();
    take_rest(to + 1, i - 1);
    take_rest(j + 1, j + reach);
    return change_of_window(cost, order, to + 1 - reach, j + reach);
  }
  take(order, i - reach, i - 1, cleared(new_nodes));
  take_rest(j + 1, j + reach);
  double change = change_of_window(cost, order, i - reach, j + reach);
  take(order, to + 1 - reach, to, cleared(new_nodes));
  take_section();
  take_rest(to + 1, to + reach);
  change += change_of_window(cost, order, to + 1 - reach, to + reach);
  return change;
}

void move_section(std::vector<int>& order, int i, int j, int to, bool turned_round) {
  const auto at = [&](int place) { return order.begin() + place; };
  if (turned_round) std::reverse(at(i), at(j + 1));
  if (to > j) {
    std::rotate(at(i), at(j + 1), at(to + 1));
  } else {
    std::rotate(at(to + 1), at(i), at(j + 1));
  }
}

}  // namespace headland
