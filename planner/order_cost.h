// What an order of cells costs, and how its cost changes when the order does.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "planner/order_walk.h"

namespace headland {

// Orders name every node once; the one of a closed tour has its start at the end again. Changes are
// looked up in the few places where neighbours change: four to six table entries where lengths
// alone count, else the legs from the change to the next way on either side that is_fixed_way, and
// for moves the section moved.

// All of the order: the cost of its expanded() path.
double full_cost(const OrderCost& cost, std::span<const int> order);

// By how much the cost grows when order[i] .. order[j], i <= j, are turned round; when that is more
// than `most`, any number above `most`.
double change_by_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j,
                          double most = std::numeric_limits<double>::infinity());

// When order[i] and order[j] change places.
double change_by_swap(const OrderCost& cost, const std::vector<int>& order, int i, int j);

// When order[i] .. order[j] are moved, turned round or not, to between order[to] and order[to + 1];
// to < i - 1 or to > j, to from -1 to the last.
double change_by_move(const OrderCost& cost, const std::vector<int>& order, int i, int j, int to,
                      bool turned_round);

// What change_by_move speaks of.
void move_section(std::vector<int>& order, int i, int j, int to, bool turned_round);

// Changes nearer to 0 than this are none: sums of weights are rounded.
inline constexpr double kNoChange = 1e-9;

}  // namespace headland
