// What an order of cells costs, and how its cost changes when the order does.
#pragma once

#include <span>
#include <vector>

#include "planner/grid_cost.h"
#include "planner/grid_distances.h"

namespace headland {

// Orders are lists of all nodes without repeats; the path of an order is expanded(). The three are
// not owned. A change is looked up in the few places where neighbours change: O(1), but for the
// lengths of ways walked where turns or slopes cost something.
struct OrderCost {
  const GridGraph* graph = nullptr;
  const DistanceTable* table = nullptr;
  CostShares shares;
  bool lengths_only = true;  // neither turns nor slopes cost anything
};

OrderCost order_cost(const GridGraph& graph, const DistanceTable& table, const GridCost& cost);

// All of the order.
double full_cost(const OrderCost& cost, const std::vector<int>& order);

// The ways between `nodes` and the turns at all but the first and last: what costs of changes are
// made of.
double section_cost(const OrderCost& cost, std::span<const int> nodes);

// By how much the cost grows when order[i] .. order[j], i <= j, are turned round.
double change_by_reversal(const OrderCost& cost, const std::vector<int>& order, int i, int j);

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
