// What an order of cells costs, and how its cost changes when the order does.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "planner/order_walk.h"
#include "planner/plan_search.h"

namespace headland {

// Orders name every node once; the one of a closed tour has its start at the end again. Changes are
// looked up in the few places where neighbours change: four to six table entries where lengths
// alone count, else the legs from the change to the next way on either side that is_fixed_way, and
// for moves the section moved, for reversals the section turned round if steps are directed.

// All of the order: the cost of its expanded() path.
double full_cost(const OrderCost& cost, std::span<const int> order);

// By how much the cost grows when order[i] .. order[j], i <= j, are turned round; when that is more
// than `most`, any number above `most`.
double change_by_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j,
                          double most = std::numeric_limits<double>::infinity());
// Its two ways, for lengths alone and for all else.
double change_by_length_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j,
                                 double most);
double change_by_walked_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j,
                                 double most);

// When order[i] and order[j] change places.
double change_by_swap(const OrderCost& cost, const std::vector<int>& order, int i, int j);

// When order[i] .. order[j] are moved, turned round or not, to between order[to] and order[to + 1];
// to < i - 1 or to > j, to from -1 to the last; `most` as above.
double change_by_move(const OrderCost& cost, const std::vector<int>& order, int i, int j, int to,
                      bool turned_round, double most = std::numeric_limits<double>::infinity());

// What change_by_move speaks of.
void move_section(std::vector<int>& order, int i, int j, int to, bool turned_round);

// Inline: population planners spend most of their time here.
inline double change_by_length_reversal(const OrderCost& cost, const std::vector<int>& order, int i,
                                        int j, double most) {
  const DistanceTable& steps = *cost.table;
  const auto at_least = [&cost](int from, int to) {
    return steps_without_obstacles(*cost.graph, from, to);
  };
  const int first = at(order, i);
  const int last = at(order, j);
  const int before = i > 0 ? at(order, i - 1) : first;
  const int after = j + 1 < static_cast<int>(order.size()) ? at(order, j + 1) : last;
  // At an end of the order nothing is before or after, and nothing changes there.
  const int new_before = i > 0 ? last : first;
  const int new_after = after != last ? first : last;
  const int old_steps = steps(before, first) + steps(last, after);
  // Without obstacles in the way the table, which is large, needs no look.
  const int least = at_least(before, new_before) + at_least(new_after, after) - old_steps;
  if (cost.shares.step * least > most) return cost.shares.step * least;
  return cost.shares.step * (steps(before, new_before) + steps(new_after, after) - old_steps);
}

inline double change_by_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j,
                                 double most) {
  return cost.lengths_only ? change_by_length_reversal(cost, order, i, j, most)
                           : change_by_walked_reversal(cost, order, i, j, most);
}

}  // namespace headland
