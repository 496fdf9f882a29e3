// Ground as square cells, blocked or free: what grid planners plan on.
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "terrains/heightfield.h"

namespace headland {

struct GridCell {
  int column = 0;  // from the west
  int row = 0;     // from the south

  auto operator<=>(const GridCell&) const = default;
};

// Cell (i, j) is entry j * columns + i of `blocked` and `height_m`. With direction_rad = 0 columns
// run east and rows north.
struct GridMap {
  int columns = 0;
  int rows = 0;
  double cell_m = 1.0;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();  // outer corner of cell (0, 0)
  double direction_rad = 0.0;                          // of rows, from +x counter-clockwise
  std::vector<std::uint8_t> blocked;                   // 1: no vehicle may be there
  std::vector<double> height_m;                        // of the cells' centres; empty: flat
};

// A map may have this many columns and rows.
inline constexpr int kMaxGridSide = 1000;
// Side of a cell.
inline constexpr double kMinGridCell_m = 0.05;
inline constexpr double kMaxGridCell_m = 1000.0;
// Of a cell's centre, above or below 0.
inline constexpr double kMaxGridHeight_m = 1e5;

// Any size that is not negative, all free, flat.
GridMap free_grid_map(int columns, int rows);

inline std::size_t index_of(const GridMap& map, GridCell cell) {
  return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(map.columns) +
         static_cast<std::size_t>(cell.column);
}

inline bool on_map(const GridMap& map, GridCell cell) {
  return cell.column >= 0 && cell.row >= 0 && cell.column < map.columns && cell.row < map.rows;
}

// False outside the map.
inline bool is_free(const GridMap& map, GridCell cell) {
  return on_map(map, cell) && map.blocked[index_of(map, cell)] == 0;
}

// Middle of the cell in W [m].
Eigen::Vector2d centre_W(const GridMap& map, GridCell cell);

int free_cell_count(const GridMap& map);

// Free cells that can be reached from each other by steps to the left, right, up and down.
struct GridArea {
  GridCell first;  // the westernmost of its southernmost row
  int cells = 0;
};

struct GridAreas {
  std::vector<GridArea> areas;  // by `first`, row by row
  std::vector<int> area_of;     // by cell; -1 where blocked
};

GridAreas areas_of(const GridMap& map);

// Throws InputError for sizes out of range, lists of another size than the map, heights out of
// range or not finite, and a map without a free cell.
void check_grid_map(const GridMap& map, const std::string& source);

// Takes the heights of the terrain's surface at the cells' centres.
void set_heights(GridMap& map, const Heightfield& terrain);

}  // namespace headland
