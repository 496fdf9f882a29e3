#include "planner/grid_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "terrains/input_error.h"

namespace headland {
namespace {

void require_connected(const GridMap& map, const std::string& source) {
  const GridAreas areas = areas_of(map);
  if (areas.areas.size() == 1) return;
  const auto largest = std::ranges::max_element(areas.areas, {}, &GridArea::cells);
  const auto other = largest == areas.areas.begin() ? largest + 1 : areas.areas.begin();
  throw InputError(
      source, "map",
      fmt::format("{} of {} free cells", free_cell_count(map) - largest->cells,
                  free_cell_count(map)),
      fmt::format("cannot be reached from the rest, first column {}, row {} (from 0 in the "
                  "south-west); block them or open a way of whole cells",
                  other->first.column, other->first.row));
}

}  // namespace

GridGraph grid_graph(const GridMap& map, const std::string& source) {
  check_grid_map(map, source);
  require_connected(map, source);
  GridGraph graph;
  graph.cell_m = map.cell_m;
  graph.node_of.assign(map.blocked.size(), -1);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::size_t entry = index_of(map, {column, row});
      if (!is_free(map, {column, row})) continue;
      graph.node_of[entry] = graph.size();
      graph.cells.push_back({column, row});
      if (!map.height_m.empty()) graph.height_m.push_back(map.height_m[entry]);
    }
  }
  graph.beside.reserve(graph.cells.size());
  for (const GridCell cell : graph.cells) {
    std::array<int, kDirections> beside{};
    for (std::size_t k = 0; k < beside.size(); ++k) {
      const GridCell next{cell.column + kStep[k].column, cell.row + kStep[k].row};
      beside[k] = is_free(map, next) ? graph.node_of[index_of(map, next)] : -1;
    }
    graph.beside.push_back(beside);
  }
  return graph;
}

int node_at(const GridMap& map, const GridGraph& graph, GridCell cell, const std::string& source,
            const std::string& where) {
  if (!is_free(map, cell)) {
    throw InputError(source, where, fmt::format("{}, {}", cell.column, cell.row),
                     on_map(map, cell)
                         ? "a free cell; this one is blocked"
                         : fmt::format("a cell of the map: column 0 to {}, row 0 to {}",
                                       map.columns - 1, map.rows - 1));
  }
  return graph.node_of[index_of(map, cell)];
}

}  // namespace headland
