#include "planner/order_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace headland {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNoDifference = 1e-12;  // W h, of prices of steps

double step_cost(const OrderCost& cost, int from, int to) {
  if (!cost.slopes) return cost.shares.step;
  if (!cost.graph->step_wh.empty()) {
    return at(at(cost.graph->step_wh, from), direction_between(*cost.graph, from, to));
  }
  const StepSlope slope = slope_of_step(*cost.graph, from, to);
  return cost.shares.step + cost.shares.level * slope.level_m + cost.shares.climb * slope.climb_m;
}

// The cost of the walk once it has turned to `direction`.
double turned_to(const OrderWalk& walk, int direction) {
  if (!walk.several) {
    return walk.last < 0 ? walk.so_far : walk.so_far + at(at(walk.cost.turn, walk.last), direction);
  }
  double least = kNever;
  for (int last = 0; last < walk.cost.states; ++last) {
    least = std::min(least, at(walk.by_last, last) + at(at(walk.cost.turn, last), direction));
  }
  return least;
}

int state_after(const OrderCost& cost, int state, int direction) {
  return state < 0 ? direction : at(at(cost.next, state), direction);
}

// Whether the walk turned to `direction` may be in more than one state.
bool may_split(const OrderWalk& walk) { return walk.several && walk.cost.states > kDirections; }

// Of such a walk the least cost by the states it may be in.
std::array<double, kMostStates> split(const OrderWalk& walk, int direction) {
  std::array<double, kMostStates> costs{};
  costs.fill(kNever);
  for (int last = 0; last < walk.cost.states; ++last) {
    double& least = at(costs, state_after(walk.cost, last, direction));
    least = std::min(least, at(walk.by_last, last) + at(at(walk.cost.turn, last), direction));
  }
  return costs;
}

// In one state, that is.
void arrive(OrderWalk& walk, int node, int state, double cost) {
  walk.node = node;
  walk.last = state;
  walk.so_far = cost;
  walk.several = false;
}

void arrive(OrderWalk& walk, int node, const std::array<double, kMostStates>& costs) {
  walk.by_last = costs;
  walk.node = node;
  walk.last = -1;
  walk.several = true;
}

void step_to(OrderWalk& walk, int node, int direction) {
  const double step = step_cost(walk.cost, walk.node, node);
  if (!may_split(walk)) {
    const int before = walk.several ? -1 : walk.last;
    const double cost = turned_to(walk, direction) + step;
    return arrive(walk, node, state_after(walk.cost, before, direction), cost);
  }
  std::array<double, kMostStates> costs = split(walk, direction);
  for (double& cost : costs) cost += step;
  arrive(walk, node, costs);
}

// As if nothing were blocked and the ground were flat: along the row at the end with the lower
// number, then the column.
void walk_free(OrderWalk& walk, int to) {
  const GridGraph& graph = *walk.cost.graph;
  const GridCell one = at(graph.cells, walk.node);
  const GridCell other = at(graph.cells, to);
  const CostShares& shares = walk.cost.shares;
  const int along = other.column < one.column ? 0 : 2;
  const int across = other.row < one.row ? 3 : 1;
  const bool row_first = walk.node < to;
  int first = row_first ? along : across;
  int last = row_first ? across : along;
  if (one.row == other.row) first = last = along;
  if (one.column == other.column) first = last = across;
  const double cost =
      turned_to(walk, first) + at(at(walk.cost.turn, first), last) +
      (shares.step + shares.level * graph.cell_m) * steps_without_obstacles(graph, walk.node, to);
  arrive(walk, to, last, cost);
}

void walk_far(OrderWalk& walk, int to) {
  if (walk.cost.table->steps.empty()) return walk_free(walk, to);
  // Ways are the same in both directions, so that turning a section round leaves its cost.
  std::vector<int> way = {walk.node};
  append_way(*walk.cost.graph, *walk.cost.table, walk.node, to, way);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int direction = direction_between(*walk.cost.graph, way[i - 1], way[i]);
    step_to(walk, way[i], direction);
  }
}

// Every shortest way of up to kJoinSteps steps, step by step. Stop: void(int state, double cost),
// called where one ends.
template <typename Step, typename Stop>
struct Ways {
  const OrderCost& cost;
  int to;
  Step step;  // void(int node): goes on to it, or, with -1, back
  Stop stop;

  void follow(int node, int state, int left, double so_far) {
    if (left == 0) return stop(state, so_far);
    for (int next_direction = 0; next_direction < kDirections; ++next_direction) {
      const int next = at(at(cost.graph->beside, node), next_direction);
      if (next < 0 || (*cost.table)(next, to) != left - 1) continue;
      step(next);
      follow(next, at(at(cost.next, state), next_direction), left - 1,
             so_far + at(at(cost.turn, state), next_direction) + step_cost(cost, node, next));
      step(-1);
    }
  }
};

template <typename Step, typename Stop>
void follow_ways(const OrderWalk& walk, int to, int steps, Step step, Stop stop) {
  Ways<Step, Stop> ways{walk.cost, to, step, stop};
  for (int direction = 0; direction < kDirections; ++direction) {
    const int next = at(at(walk.cost.graph->beside, walk.node), direction);
    if (next < 0 || (*walk.cost.table)(next, to) != steps - 1) continue;
    step(next);
    const double step_price = step_cost(walk.cost, walk.node, next);
    if (!may_split(walk)) {
      const int before = walk.several ? -1 : walk.last;
      ways.follow(next, state_after(walk.cost, before, direction), steps - 1,
                  turned_to(walk, direction) + step_price);
    } else {
      const std::array<double, kMostStates> costs = split(walk, direction);
      for (int state = 0; state < walk.cost.states; ++state) {
        if (at(costs, state) == kNever) continue;
        ways.follow(next, state, steps - 1, at(costs, state) + step_price);
      }
    }
    step(-1);
  }
}

// What a way costs beyond its steps when it is begun in this state, and the state it ends in.
std::pair<double, int> turns_of_way(const OrderCost& cost, int node, const std::vector<int>& way,
                                    int state) {
  double turns = 0.0;
  for (const int next : way) {
    const int direction = direction_between(*cost.graph, node, next);
    turns += at(at(cost.turn, state), direction);
    state = at(at(cost.next, state), direction);
    node = next;
  }
  return {turns, state};
}

// Appends the way of the walk's last leg, from a node where it stood as in `before`, that ends in
// `last_state`; the state in which that node was reached.
int append_leg(const OrderWalk& before, int to, int last_state, std::vector<int>& reversed) {
  const OrderCost& cost = before.cost;
  std::vector<int> best;
  const int steps = (*cost.table)(before.node, to);
  if (steps > kJoinSteps) {
    append_way(*cost.graph, *cost.table, before.node, to, best);
  } else {
    std::vector<int> way;
    double least = kNever;
    follow_ways(
        before, to, steps,
        [&](int node) {
          if (node >= 0) return way.push_back(node);
          way.pop_back();
        },
        [&](int state, double costs) {
          if (state != last_state || !(costs < least)) return;
          least = costs;
          best = way;
        });
  }
  reversed.insert(reversed.end(), best.rbegin(), best.rend());
  if (!before.several || best.empty()) return before.several ? last_state : before.last;
  int last = 0;
  double least = kNever;
  for (int state = 0; state < cost.states; ++state) {
    const auto [turns, end] = turns_of_way(cost, before.node, best, state);
    const double costs = at(before.by_last, state) + turns;
    if (end != last_state || !(costs < least)) continue;
    last = state;
    least = costs;
  }
  return last;
}

// Measured steps, beyond rounding.
template <typename Differ>  // bool(int node, int direction, int next)
bool any_step(const GridGraph& graph, Differ differ) {
  if (graph.step_wh.empty()) return false;
  for (int node = 0; node < graph.size(); ++node) {
    for (int direction = 0; direction < kDirections; ++direction) {
      const int next = at(at(graph.beside, node), direction);
      if (next >= 0 && differ(node, direction, next)) return true;
    }
  }
  return false;
}

bool differ(const GridGraph& graph) {
  double first = -1.0;
  return any_step(graph, [&](int node, int direction, int) {
    const double price = at(at(graph.step_wh, node), direction);
    if (first < 0.0) first = price;
    return std::abs(price - first) > kNoDifference;
  });
}

bool differ_by_direction(const GridGraph& graph) {
  return any_step(graph, [&](int node, int direction, int next) {
    return std::abs(at(at(graph.step_wh, node), direction) -
                    at(at(graph.step_wh, next), opposite(direction))) > kNoDifference;
  });
}

}  // namespace

OrderCost order_cost(const GridGraph& graph, const DistanceTable& table, const GridCost& cost) {
  OrderCost result;
  result.graph = &graph;
  result.table = &table;
  result.shares = cost_shares(cost, graph);
  const CostShares& shares = result.shares;
  result.slopes = shares.level > 0.0 || shares.climb > 0.0 || differ(graph);
  result.directed = differ_by_direction(graph);
  result.lengths_only = !(shares.turn > 0.0 || shares.u_turn > 0.0 || result.slopes);
  if (shares.row_change != 0.0) result.states = kMostStates;
  for (int state = 0; state < result.states; ++state) {
    const int one = state % kDirections;
    for (int next = 0; next < kDirections; ++next) {
      double& price = at(at(result.turn, state), next);
      price = is_turn(one, next) ? shares.turn : (is_u_turn(one, next) ? shares.u_turn : 0.0);
      at(at(result.next, state), next) = next;
      if (result.states == kDirections || !is_turn(one, next)) continue;
      const int sense = turns_left(one, next) ? 1 : 2;
      if (state / kDirections == sense) price += shares.row_change;
      at(at(result.next, state), next) = next + sense * kDirections;
    }
  }
  return result;
}

bool is_fixed_way(const OrderCost& cost, int from, int to) {
  if (steps_without_obstacles(*cost.graph, from, to) <= 1) return true;
  return (*cost.table)(from, to) > kJoinSteps;
}

void walk_on(OrderWalk& walk, int to) {
  if (walk.node < 0) {
    walk.node = to;
    return;
  }
  const int beside = direction_between(*walk.cost.graph, walk.node, to);
  if (beside >= 0) {
    return step_to(walk, to, beside);
  }
  const int steps = (*walk.cost.table)(walk.node, to);
  if (steps == 0) return;
  if (steps > kJoinSteps) return walk_far(walk, to);
  std::array<double, kMostStates> costs{};
  costs.fill(kNever);
  follow_ways(
      walk, to, steps, [](int) {},
      [&](int state, double cost) { at(costs, state) = std::min(at(costs, state), cost); });
  arrive(walk, to, costs);
}

double cost_of_walk(const OrderWalk& walk) {
  return walk.several ? *std::ranges::min_element(walk.by_last) : walk.so_far;
}

std::vector<int> expanded(const OrderCost& cost, std::span<const int> order) {
  if (cost.lengths_only) {
    std::vector<int> path = {order.front()};
    for (std::size_t i = 1; i < order.size(); ++i) {
      append_way(*cost.graph, *cost.table, order[i - 1], order[i], path);
    }
    return path;
  }
  std::vector<OrderWalk> at_place;
  OrderWalk walk{cost};
  for (const int node : order) {
    walk_on(walk, node);
    at_place.push_back(walk);
  }
  std::vector<int> reversed;
  const auto& by_last = walk.by_last;
  int last = walk.several ? static_cast<int>(std::ranges::min_element(by_last) - by_last.begin())
                          : walk.last;
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    last = append_leg(at_place[i - 1], order[i], last, reversed);
  }
  reversed.push_back(order.front());
  std::ranges::reverse(reversed);
  return reversed;
}

}  // namespace headland
