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

using Stretches = std::initializer_list<Stretch>;

// Ends early, with less than the parts' cost, where that is more than `most`.
double cost_of_parts(const OrderCost& cost, const Order& order, Stretches parts,
                     double most = std::numeric_limits<double>::infinity()) {
  OrderWalk walk{cost};
  for (const Stretch& part : parts) {
    for (int i = 0; i <= part.to - part.from; ++i) {
      const int next = at(order, part.turned_round ? part.to - i : part.from + i);
      if (walk.node >= 0) {
        // Far ways take long to walk.
        const double least =
            cost_of_walk(walk) +
            cost.shares.step * steps_without_obstacles(*cost.graph, walk.node, next);
        if (least > most) return least;
      }
      walk_on(walk, next);
    }
  }
  return cost_of_walk(walk);
}

// By how much the new parts cost more than the old ones; when that is more than `most`, any number
// above it.
double change_of_parts(const OrderCost& cost, const Order& order, double most, Stretches old_one,
                       Stretches new_one, Stretches old_other = {}, Stretches new_other = {}) {
  const double before = cost_of_parts(cost, order, old_one) + cost_of_parts(cost, order, old_other);
  const double one = cost_of_parts(cost, order, new_one, before + most);
  if (one > before + most) return one - before;
  return one + cost_of_parts(cost, order, new_other, before + most - one) - before;
}

// Whether the walk over order[i - 1] .. order[i] ends in the same state whatever comes before
// `first`: by a way that is always the same, and, where turns that follow each other cost something
// else, over two such steps or more.
bool settles(const OrderCost& cost, const Order& order, int i, int first) {
  if (!is_fixed_way(cost, at(order, i - 1), at(order, i))) return false;
  if (cost.states == kDirections) return true;
  if (steps_without_obstacles(*cost.graph, at(order, i - 1), at(order, i)) > 1) return true;
  return i - 2 >= first && is_fixed_way(cost, at(order, i - 2), at(order, i - 1));
}

// The last place from `place` back from which on a way not beyond `place` settles the walk, else
// `least`: what lies before has no part in what changes after `place`.
int place_before(const OrderCost& cost, const Order& order, int place, int least) {
  const int legs = cost.states == kDirections ? 1 : 2;
  for (int i = place - legs; i >= least; --i) {
    if (settles(cost, order, i + legs, i)) return i;
  }
  return least;
}

// Likewise the first place after `place` that ends such a way, else `most`.
int place_after(const OrderCost& cost, const Order& order, int place, int most) {
  for (int i = place + 1; i <= most; ++i) {
    if (settles(cost, order, i, place)) return i;
  }
  return most;
}

// Whether such a way lies between two places, found by the two above.
bool is_parted(const OrderCost& cost, const Order& order, int from, int to) {
  const int end = place_after(cost, order, from, to);
  return end > from && settles(cost, order, end, from);
}

int node_at_place(const Order& order, int place) {
  return place >= 0 && place <= last_place(order) ? at(order, place) : -1;
}

// Two nodes that follow each other, and those around them; -1: none, or not to be regarded.
struct PlaceJoin {
  int before = -1;
  int from = -1;
  int to = -1;
  int after = -1;
};

double cost_of_turn(const OrderCost& cost, int before, int node, int after) {
  if (before < 0 || after < 0) return 0.0;
  const int in = direction_between(*cost.graph, before, node);
  const int out = direction_between(*cost.graph, node, after);
  return in < 0 || out < 0 ? 0.0 : at(at(cost.turn, in), out);
}

// The way between the two and the turns at both of them, at least.
double least_cost(const OrderCost& cost, const PlaceJoin& join) {
  if (join.from < 0 || join.to < 0) return 0.0;
  const double way = cost.shares.step * steps_without_obstacles(*cost.graph, join.from, join.to);
  return way + cost_of_turn(cost, join.before, join.from, join.to) +
         cost_of_turn(cost, join.from, join.to, join.after);
}

// The same where all are neighbours; elsewhere, and where slopes cost something, more than any.
double most_cost(const OrderCost& cost, const PlaceJoin& join) {
  if (join.from < 0 || join.to < 0) return 0.0;
  const auto is_step = [&](int one, int other) {
    return one < 0 || direction_between(*cost.graph, one, other) >= 0;
  };
  const bool steps = !cost.slopes && cost.states == kDirections &&
                     is_step(join.before, join.from) && is_step(join.from, join.to) &&
                     is_step(join.after, join.to);
  return steps ? least_cost(cost, join) : std::numeric_limits<double>::infinity();
}

// No reversal changes the cost by less: by what its two ends alone can bring.
double least_change_by_reversal(const OrderCost& cost, const Order& order, int i, int j) {
  const auto join = [&](int before, int from, int to, int after) {
    return PlaceJoin{node_at_place(order, before), node_at_place(order, from),
                     node_at_place(order, to), node_at_place(order, after)};
  };
  return least_cost(cost, join(i - 2, i - 1, j, j - 1)) +
         least_cost(cost, join(i + 1, i, j + 1, j + 2)) -
         most_cost(cost, join(i - 2, i - 1, i, i + 1)) -
         most_cost(cost, join(j - 1, j, j + 1, j + 2));
}

// Likewise of a move. Nodes are left out where the joins made touch each other.
double least_change_by_move(const OrderCost& cost, const Order& order, int i, int j, int to,
                            bool turned_round) {
  constexpr int kNone = -1;
  const auto join = [&](int before, int from, int to_place, int after) {
    return PlaceJoin{node_at_place(order, before), node_at_place(order, from),
                     node_at_place(order, to_place), node_at_place(order, after)};
  };
  const int first = turned_round ? j : i;
  const int last = turned_round ? i : j;
  const int inward = i == j ? 0 : (turned_round ? -1 : 1);
  const bool next_after = to == j + 1;
  const bool next_before = to == i - 2;
  return least_cost(cost,
                    join(next_before ? kNone : i - 2, i - 1, j + 1, next_after ? kNone : j + 2)) +
         least_cost(cost, join(next_after ? kNone : to - 1, to, first,
                               inward == 0 ? kNone : first + inward)) +
         least_cost(cost, join(inward == 0 ? to : last - inward, last, to + 1,
                               next_before ? kNone : to + 2)) -
         most_cost(cost, join(i - 2, i - 1, i, i + 1)) -
         most_cost(cost, join(j - 1, j, j + 1, j + 2)) -
         most_cost(cost, join(to - 1, to, to + 1, to + 2));
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

double change_by_walked_reversal(const OrderCost& cost, const Order& order, int i, int j,
                                 double most) {
  if (!cost.slopes && cost.states == kDirections) {
    if (const double least = least_change_by_reversal(cost, order, i, j); least > most) {
      return least;
    }
  }
  const int begin = place_before(cost, order, i - 1, 0);
  const int end = place_after(cost, order, j + 1, last_place(order));
  // What lies between is driven the other way, which costs the same unless steps are directed.
  if (cost.directed || !is_parted(cost, order, i, j)) {
    return change_of_parts(cost, order, most, {{begin, end}},
                           {{begin, i - 1}, {i, j, true}, {j + 1, end}});
  }
  const int inner_end = place_after(cost, order, i, j);
  const int inner_begin = place_before(cost, order, j, i);
  return change_of_parts(cost, order, most, {{begin, inner_end}},
                         {{begin, i - 1}, {inner_begin, j, true}}, {{inner_begin, end}},
                         {{i, inner_end, true}, {j + 1, end}});
}

double change_by_swap(const OrderCost& cost, const Order& order, int i, int j) {
  if (i == j) return 0.0;
  if (i > j) std::swap(i, j);
  if (cost.lengths_only) return length_change_by_swap(cost, order, i, j);
  const int begin = place_before(cost, order, i - 1, 0);
  const int end = place_after(cost, order, j + 1, last_place(order));
  constexpr double kMost = std::numeric_limits<double>::infinity();
  if (j - i < 2 || !is_parted(cost, order, i + 1, j - 1)) {
    return change_of_parts(cost, order, kMost, {{begin, end}},
                           {{begin, i - 1}, {j, j}, {i + 1, j - 1}, {i, i}, {j + 1, end}});
  }
  const int inner_end = place_after(cost, order, i + 1, j - 1);
  const int inner_begin = place_before(cost, order, j - 1, i + 1);
  return change_of_parts(cost, order, kMost, {{begin, inner_end}},
                         {{begin, i - 1}, {j, j}, {i + 1, inner_end}}, {{inner_begin, end}},
                         {{inner_begin, j - 1}, {i, i}, {j + 1, end}});
}

double change_by_move(const OrderCost& cost, const Order& order, int i, int j, int to,
                      bool turned_round, double most) {
  if (cost.lengths_only) return length_change_by_move(cost, order, i, j, to, turned_round);
  const double least = least_change_by_move(cost, order, i, j, to, turned_round);
  if (least > most) return least;
  const Stretch section{i, j, turned_round};
  const bool forward = to > j;
  // What the section is moved past.
  const int from = forward ? j + 1 : to + 1;
  const int until = forward ? to : i - 1;
  const int begin = place_before(cost, order, from - 1 - (forward ? j - i + 1 : 0), 0);
  const int end =
      place_after(cost, order, until + 1 + (forward ? 0 : j - i + 1), last_place(order));
  if (!is_parted(cost, order, from, until)) {
    const Stretches moved = {{begin, i - 1}, {from, until}, section, {to + 1, end}};
    const Stretches moved_back = {{begin, to}, section, {from, until}, {j + 1, end}};
    return change_of_parts(cost, order, most, {{begin, end}}, forward ? moved : moved_back);
  }
  const int inner_end = place_after(cost, order, from, until);
  const int inner_begin = place_before(cost, order, until, from);
  if (forward) {
    return change_of_parts(cost, order, most, {{begin, inner_end}},
                           {{begin, i - 1}, {from, inner_end}}, {{inner_begin, end}},
                           {{inner_begin, to}, section, {to + 1, end}});
  }
  return change_of_parts(cost, order, most, {{begin, inner_end}},
                         {{begin, to}, section, {from, inner_end}}, {{inner_begin, end}},
                         {{inner_begin, i - 1}, {j + 1, end}});
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
