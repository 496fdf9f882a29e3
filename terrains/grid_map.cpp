#include "terrains/grid_map.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "terrains/input_error.h"

namespace headland {
namespace {

void fill_area(const GridMap& map, GridCell first, GridAreas& result) {
  const int area = static_cast<int>(result.areas.size());
  std::vector<GridCell> reached = {first};
  result.area_of[index_of(map, first)] = area;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const GridCell cell = reached[i];
    const std::array<GridCell, 4> around = {GridCell{cell.column - 1, cell.row},
                                            {cell.column, cell.row + 1},
                                            {cell.column + 1, cell.row},
                                            {cell.column, cell.row - 1}};
    for (const GridCell next : around) {
      if (!is_free(map, next) || result.area_of[index_of(map, next)] >= 0) continue;
      result.area_of[index_of(map, next)] = area;
      reached.push_back(next);
    }
  }
  result.areas.push_back({first, static_cast<int>(reached.size())});
}

void require_values(const GridMap& map, std::size_t size, const std::string& source,
                    const std::string& what) {
  const std::size_t cells = index_of(map, {0, map.rows});
  if (size == cells) return;
  throw InputError(
      source, what, std::to_string(size),
      fmt::format("{} values, one for each of {} x {} cells", cells, map.columns, map.rows));
}

}  // namespace

GridMap free_grid_map(int columns, int rows) {
  GridMap map;
  map.columns = columns;
  map.rows = rows;
  map.blocked.assign(index_of(map, {0, rows}), 0);
  return map;
}

Eigen::Vector2d centre_W(const GridMap& map, GridCell cell) {
  return map.origin_W +
         Eigen::Rotation2Dd(map.direction_rad) *
             Eigen::Vector2d((cell.column + 0.5) * map.cell_m, (cell.row + 0.5) * map.cell_m);
}

int free_cell_count(const GridMap& map) {
  return static_cast<int>(std::ranges::count(map.blocked, 0));
}

GridAreas areas_of(const GridMap& map) {
  GridAreas result;
  result.area_of.assign(map.blocked.size(), -1);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const GridCell cell{column, row};
      if (is_free(map, cell) && result.area_of[index_of(map, cell)] < 0) {
        fill_area(map, cell, result);
      }
    }
  }
  return result;
}

void check_grid_map(const GridMap& map, const std::string& source) {
  if (map.columns < 1 || map.rows < 1 || map.columns > kMaxGridSide || map.rows > kMaxGridSide) {
    throw InputError(source, "map", fmt::format("{} x {} cells", map.columns, map.rows),
                     fmt::format("1 to {} columns and rows", kMaxGridSide));
  }
  if (!(map.cell_m >= kMinGridCell_m && map.cell_m <= kMaxGridCell_m)) {
    throw InputError(source, "cell_m", fmt::format("{}", map.cell_m),
                     fmt::format("a number from {} to {}", kMinGridCell_m, kMaxGridCell_m));
  }
  require_values(map, map.blocked.size(), source, "map");
  if (!map.height_m.empty()) require_values(map, map.height_m.size(), source, "heights");
  const auto odd = std::ranges::find_if_not(
      map.height_m, [](double h) { return std::abs(h) <= kMaxGridHeight_m; });
  if (odd != map.height_m.end()) {
    throw InputError(source, "heights", fmt::format("{}", *odd),
                     fmt::format("heights from {0} to {1}", -kMaxGridHeight_m, kMaxGridHeight_m));
  }
  if (free_cell_count(map) == 0) throw InputError(source, "map", "", "there is no free cell");
}

void set_heights(GridMap& map, const Heightfield& terrain) {
  map.height_m.clear();
  map.height_m.reserve(map.blocked.size());
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const Eigen::Vector2d p_W = centre_W(map, {column, row});
      map.height_m.push_back(surface_at(terrain, p_W.x(), p_W.y()).height_m);
    }
  }
}

}  // namespace headland
