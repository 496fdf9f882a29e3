// The free cells of a grid map as numbered nodes, and the steps between them.
#pragma once

#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "planner/indexed.h"
#include "terrains/grid_map.h"

namespace headland {

// Directions of a step: left 0, up 1, right 2, down 3. These are the codes of Wu et al. 2023
// (10.20944/preprints202305.1306.v1), 2.1.3, less one and made cyclic: the paper's up = 3 and
// down = 4 would make a turn from left to up a U-turn in its Eqs (12) and (14).
inline constexpr int kDirections = 4;
inline constexpr std::array<GridCell, kDirections> kStep = {{{-1, 0}, {0, 1}, {1, 0}, {0, -1}}};

constexpr int opposite(int direction) { return (direction + 2) % kDirections; }

// Nodes are numbered from the south-west, row by row (2.1.3).
struct GridGraph {
  std::vector<GridCell> cells;                       // of the nodes
  std::vector<std::array<int, kDirections>> beside;  // node in each direction, -1: none
  std::vector<int> node_of;                          // by entry of the map; -1 where blocked
  std::vector<double> height_m;                      // of the nodes; empty: flat
  // What steps from a node cost by direction, see step_prices; empty: nothing was measured.
  std::vector<std::array<double, kDirections>> step_wh;
  double cell_m = 1.0;

  int size() const { return static_cast<int>(cells.size()); }
};

// Throws InputError as check_grid_map, and when free cells are not connected: how many are cut off
// from how many, and where.
GridGraph grid_graph(const GridMap& map, const std::string& source);

// The node of a cell. Throws InputError(source, where) when it is blocked or outside the map.
int node_at(const GridMap& map, const GridGraph& graph, GridCell cell, const std::string& source,
            const std::string& where);

// Direction of the step from one node to the next; -1 when they are not neighbours.
inline int direction_between(const GridGraph& graph, int from, int to) {
  const GridCell one = at(graph.cells, from);
  const GridCell other = at(graph.cells, to);
  const int right = other.column - one.column;
  const int up = other.row - one.row;
  if (std::abs(right) + std::abs(up) != 1) return -1;
  return up == 0 ? 1 + right : 2 - up;
}

// Steps between two nodes if nothing were blocked; there are no fewer.
inline int steps_without_obstacles(const GridGraph& graph, int from, int to) {
  const GridCell one = at(graph.cells, from);
  const GridCell other = at(graph.cells, to);
  return std::abs(one.column - other.column) + std::abs(one.row - other.row);
}

}  // namespace headland
