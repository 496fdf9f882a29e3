// Orders of cells walked as paths: the ways between consecutive cells and the turns they make.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "planner/grid_cost.h"
#include "planner/grid_distances.h"

namespace headland {

inline constexpr int kMostStates = 3 * kDirections;

// What orders are priced by; graph and table are not owned.
struct OrderCost {
  const GridGraph* graph = nullptr;
  const DistanceTable* table = nullptr;
  CostShares shares;
  bool lengths_only = true;  // neither turns nor slopes cost anything
  bool slopes = false;       // steps differ in what they cost
  bool directed = false;     // and in the two directions between the same cells
  // How many states of a walk there are: the direction of its last step, or, where turns that
  // follow each other cost something else, that and whether the step began with a turn to the left
  // (after kDirections more) or to the right (after twice as many).
  int states = kDirections;
  // Of going on in a direction, and the state that this leads to.
  std::array<std::array<double, kDirections>, kMostStates> turn{};
  std::array<std::array<int, kDirections>, kMostStates> next{};
};

OrderCost order_cost(const GridGraph& graph, const DistanceTable& table, const GridCost& cost);

// Where turns or slopes cost something, cells up to so many steps apart are joined by the shortest
// way that is cheapest together with the turns before and after it; others by append_way.
inline constexpr int kJoinSteps = 4;

// Whether the way between two cells, and with it the directions it begins and ends in, is the same
// whatever comes before and after.
bool is_fixed_way(const OrderCost& cost, int from, int to);

// The cheapest walk from cell to cell of an order, as far as it came.
struct OrderWalk {
  const OrderCost& cost;
  int node = -1;        // where it is; -1: nowhere yet
  int last = -1;        // its state; -1: no step yet, or any of several
  double so_far = 0.0;  // its cost, unless there are several
  bool several = false;
  std::array<double, kMostStates> by_last{};  // by its state, if several
};

void walk_on(OrderWalk& walk, int to);
double cost_of_walk(const OrderWalk& walk);

// The path of an order: every node of it in turn, joined as said above; what is passed on the way
// is visited again when its turn comes. Where lengths alone count this is the path whose length
// Wang et al. 2025 (10.20944/preprints202504.0101.v1) minimise (Eq 2).
std::vector<int> expanded(const OrderCost& cost, std::span<const int> order);

}  // namespace headland
