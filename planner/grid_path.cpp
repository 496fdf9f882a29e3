#include "planner/grid_path.h"

#include <cmath>

namespace headland {

std::vector<int> adjusted(const GridGraph& graph, const DistanceTable& table,
                          const std::vector<int>& order, bool keep_end) {
  std::vector<int> path = {order.front()};
  std::vector<char> visited(graph.cells.size(), 0);
  at(visited, order.front()) = 1;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const bool last = keep_end && i + 1 == order.size();
    if (at(visited, order[i]) != 0 && !last) continue;
    const std::size_t begin = path.size();
    append_way(graph, table, path.back(), order[i], path);
    for (std::size_t k = begin; k < path.size(); ++k) at(visited, path[k]) = 1;
  }
  return path;
}

StepSlope slope_of_step(const GridGraph& graph, int from, int to) {
  if (graph.height_m.empty()) return {graph.cell_m, 0.0};
  const double rise_m = std::abs(at(graph.height_m, to) - at(graph.height_m, from));
  const double slant_m = std::hypot(graph.cell_m, rise_m);
  const double cosine = graph.cell_m / slant_m;
  return {graph.cell_m * cosine * cosine, rise_m * rise_m / slant_m};
}

GridCounts count_path(const GridGraph& graph, const std::vector<int>& path) {
  GridCounts counts;
  std::vector<char> visited(graph.cells.size(), 0);
  for (const int node : path) {
    counts.distinct_cells += at(visited, node) == 0 ? 1 : 0;
    at(visited, node) = 1;
  }
  counts.steps = static_cast<int>(path.size()) - 1;
  counts.repeats = static_cast<int>(path.size()) - counts.distinct_cells;
  int before = -1;
  int turned = 0;  // the last step began with a turn: 1 to the left, 2 to the right
  for (std::size_t i = 1; i < path.size(); ++i) {
    const int direction = direction_between(graph, path[i - 1], path[i]);
    if (direction >= 0) {
      const StepSlope slope = slope_of_step(graph, path[i - 1], path[i]);
      counts.level_m += slope.level_m;
      counts.climb_m += slope.climb_m;
      if (!graph.step_wh.empty()) counts.step_wh += at(at(graph.step_wh, path[i - 1]), direction);
    }
    if (direction >= 0 && before >= 0) {
      counts.turns += is_turn(before, direction) ? 1 : 0;
      counts.u_turns += is_u_turn(before, direction) ? 1 : 0;
    }
    const bool turns = direction >= 0 && before >= 0 && is_turn(before, direction);
    const int turned_now = !turns ? 0 : (turns_left(before, direction) ? 1 : 2);
    counts.row_changes += turns && turned_now == turned ? 1 : 0;
    turned = turned_now;
    before = direction;
  }
  return counts;
}

}  // namespace headland
