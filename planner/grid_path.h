// Chromosomes made paths of steps, and what is counted on paths.
#pragma once

#include <vector>

#include "planner/grid_distances.h"
#include "planner/grid_graph.h"

namespace headland {

// The chromosome Y of Wu et al. 2023, 2.2.1: every node of the order in turn, joined by append_way;
// a node that was passed on the way is dropped from the rest of the order. Ends at order.back()
// when `keep_end`, which then may be visited once more.
std::vector<int> adjusted(const GridGraph& graph, const DistanceTable& table,
                          const std::vector<int>& order, bool keep_end);

// What Eqs (11) to (15) of Wu et al. 2023 and (12) to (19) of Wang et al. 2025 count on a path.
struct GridCounts {
  int steps = 0;
  int repeats = 0;       // visits less distinct cells, Eq (11)
  int turns = 0;         // by a right angle, Eqs (12), (13): start and end count nothing
  int u_turns = 0;       // Eqs (14), (15)
  double level_m = 0.0;  // sum of d cos^2(alpha) over the steps
  double climb_m = 0.0;  // sum of |height difference| sin(alpha)
  int row_changes = 0;   // turns one step after another one to the same side
  double step_wh = 0.0;  // sum of the graph's step_wh, 0 where it has none
  int distinct_cells = 0;
};

// Between the directions of two steps.
constexpr bool is_turn(int one, int next) { return (one - next) % 2 != 0; }
constexpr bool turns_left(int one, int next) {
  return (next + kDirections - one) % kDirections == 3;
}
constexpr bool is_u_turn(int one, int next) { return next == opposite(one); }

// One step's share of level_m and climb_m.
struct StepSlope {
  double level_m = 0.0;
  double climb_m = 0.0;
};
StepSlope slope_of_step(const GridGraph& graph, int from, int to);

// The path is not empty. Steps between cells that are not neighbours count as steps, with neither
// direction nor slope.
GridCounts count_path(const GridGraph& graph, const std::vector<int>& path);

}  // namespace headland
