#include "planner/order_cost.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace headland {
namespace {

using Order = std::vector<int>;

int last_place(const Order& order) { return static_cast<int>(order.size()) - 1; }

// order[from] .. order[to] as they stand, or from `to` back to `from`; none when from > to.
struct Stretch {
  int from = 0;
  int to = 0;
  bool turned_round = false;
};

double cost_of_parts(const OrderCost& cost, const Order& order,
                     std::initializer_list<Stretch> parts) {
  OrderWalk walk{cost};
  for (const Stretch& part : parts) {
    for (int i = 0; i <= part.to - part.from; ++i) {
      walk_on(walk, at(order, part.turned_round ? part.to - i : part.from + i));
    }
  }
  return cost_of_walk(walk);
}

// The last place from `place` back that begins a fixed way to one not after `place`, else `least`:
// what lies before has no part in what changes after `place`.
int place_before(const OrderCost& cost, const Order& order, int place, int least) {
  for (int i = place - 1; i >= least; --i) {
    if (is_fixed_way(cost, at(order, i), at(order, i + 1))) return i;
  }
  return least;
}

// Likewise the first place after `place` that ends a fixed way, else `most`.
int place_after(const OrderCost& cost, const Order& order, int place, int most) {
  for (int i = place + 1; i <= most; ++i) {
    if (is_fixed_way(cost, at(order, i - 1), at(order, i))) return i;
  }
  return most;
}

// Whether a fixed way lies between two places of a stretch that is found by the two above.
bool is_parted(const OrderCost& cost, const Order& order, int from, int to) {
  const int end = place_after(cost, order, from, to);
  return end > from && is_fixed_way(cost, at(order, end - 1), at(order, end));
}

int steps_between(const OrderCost& cost, const Order& order, int i, int j) {
  const bool both = i >= 0 && j >= 0 && std::max(i, j) <= last_place(order);
  return both ? (*cost.table)(at(order, i), at(order, j)) : 0;
}

double length_change_by_move(const OrderCost& cost, const Order& order, int i, int j, int to,
                             bool turned_round) {
  const auto steps = [&](int one, int other) { return steps_between(cost, order, one, other); };
  const int first = turned_round ? j : i;
  const int last = turned_round ? i : j;
  return cost.shares.step * (steps(i - 1, j + 1) + steps(to, first) + steps(last, to + 1) -
                             steps(i - 1, i) - steps(j, j + 1) - steps(to, to + 1));
}

double length_change_by_swap(const OrderCost& cost, const Order& order, int i, int j) {
  const auto steps = [&](int one, int other) { return steps_between(cost, order, one, other); };
  int change = steps(i - 1, j) + steps(i, j + 1) - steps(i - 1, i) - steps(j, j + 1);
  if (j > i + 1) {
    change += steps(j, i + 1) + steps(j - 1, i) - steps(i, i + 1) - steps(j - 1, j);
  }
  return cost.shares.step * change;
}

}  // namespace

double full_cost(const OrderCost& cost, std::span<const int> order) {
  if (!cost.lengths_only) {
    OrderWalk walk{cost};
    for (const int node : order) walk_on(walk, node);
    return cost.shares.constant + cost_of_walk(walk);
  }
  int steps = 0;
  for (std::size_t i = 1; i < order.size(); ++i) steps += (*cost.table)(order[i - 1], order[i]);
  return cost.shares.constant + cost.shares.step * steps;
}

double change_by_walked_reversal(const OrderCost& cost, const Order& order, int i, int j) {
  const int begin = place_before(cost, order, i - 1, 0);
  const int end = place_after(cost, order, j + 1, last_place(order));
  if (!is_parted(cost, order, i, j)) {
    return cost_of_parts(cost, order, {{begin, i - 1}, {i, j, true}, {j + 1, end}}) -
           cost_of_parts(cost, order, {{begin, end}});
  }
  const int inner_end = place_after(cost, order, i, j);
  const int inner_begin = place_before(cost, order, j, i);
  return cost_of_parts(cost, order, {{begin, i - 1}, {inner_begin, j, true}}) +
         cost_of_parts(cost, order, {{i, inner_end, true}, {j + 1, end}}) -
         cost_of_parts(cost, order, {{begin, inner_end}}) -
         cost_of_parts(cost, order, {{inner_begin, end}});
}

double change_by_swap(const OrderCost& cost, const Order& order, int i, int j) {
  if (i == j) return 0.0;
  if (i > j) std::swap(i, j);
  if (cost.lengths_only) return length_change_by_swap(cost, order, i, j);
  const int begin = place_before(cost, order, i - 1, 0);
  const int end = place_after(cost, order, j + 1, last_place(order));
  if (j - i < 2 || !is_parted(cost, order, i + 1, j - 1)) {
    return cost_of_parts(cost, order,
                         {{begin, i - 1}, {j, j}, {i + 1, j - 1}, {i, i}, {j + 1, end}}) -
           cost_of_parts(cost, order, {{begin, end}});
  }
  const int inner_end = place_after(cost, order, i + 1, j - 1);
  const int inner_begin = place_before(cost, order, j - 1, i + 1);
  return cost_of_parts(cost, order, {{begin, i - 1}, {j, j}, {i + 1, inner_end}}) +
         cost_of_parts(cost, order, {{inner_begin, j - 1}, {i, i}, {j + 1, end}}) -
         cost_of_parts(cost, order, {{begin, inner_end}}) -
         cost_of_parts(cost, order, {{inner_begin, end}});
}

double change_by_move(const OrderCost& cost, const Order& order, int i, int j, int to,
                      bool turned_round) {
  if (cost.lengths_only) return length_change_by_move(cost, order, i, j, to, turned_round);
  const Stretch section{i, j, turned_round};
  const bool forward = to > j;
  // What the section is moved past.
  const int from = forward ? j + 1 : to + 1;
  const int until = forward ? to : i - 1;
  const int begin = place_before(cost, order, from - 1 - (forward ? j - i + 1 : 0), 0);
  const int end =
      place_after(cost, order, until + 1 + (forward ? 0 : j - i + 1), last_place(order));
  if (!is_parted(cost, order, from, until)) {
    const double old_cost = cost_of_parts(cost, order, {{begin, end}});
    return forward
               ? cost_of_parts(cost, order,
                               {{begin, i - 1}, {from, until}, section, {to + 1, end}}) -
                     old_cost
               : cost_of_parts(cost, order, {{begin, to}, section, {from, until}, {j + 1, end}}) -
                     old_cost;
  }
  const int inner_end = place_after(cost, order, from, until);
  const int inner_begin = place_before(cost, order, until, from);
  const double old_costs = cost_of_parts(cost, order, {{begin, inner_end}}) +
                           cost_of_parts(cost, order, {{inner_begin, end}});
  if (forward) {
    return cost_of_parts(cost, order, {{begin, i - 1}, {from, inner_end}}) +
           cost_of_parts(cost, order, {{inner_begin, to}, section, {to + 1, end}}) - old_costs;
  }
  return cost_of_parts(cost, order, {{begin, to}, section, {from, inner_end}}) +
         cost_of_parts(cost, order, {{inner_begin, i - 1}, {j + 1, end}}) - old_costs;
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
