// Looking up the cells of a free space.
#pragma once

#include <algorithm>
#include <cmath>

#include "planner/free_space.h"

namespace headland {

struct CellRange {
  int column_0, column_1, row_0, row_1;  // inclusive
};

inline int cell_index(double offset_m, double cell_m, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / cell_m), 0.0, count - 1.0));
}

// The cells that a box touches; what lies outside the grid counts to its rim.
inline CellRange cells_around(const FreeSpace& space, const Eigen::Vector2d& low_W,
                              const Eigen::Vector2d& high_W) {
  const Eigen::Vector2d low = low_W - space.origin_W;
  const Eigen::Vector2d high = high_W - space.origin_W;
  return {cell_index(low.x(), space.cell_m, space.columns),
          cell_index(high.x(), space.cell_m, space.columns),
          cell_index(low.y(), space.cell_m, space.rows),
          cell_index(high.y(), space.cell_m, space.rows)};
}

inline std::size_t cell_at(const FreeSpace& space, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(space.columns) +
         static_cast<std::size_t>(column);
}

inline Eigen::Vector2d centre_of(const FreeSpace& space, int column, int row) {
  return space.origin_W + space.cell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
}

struct CellPlace {
  const FreeSpace::Cell& cell;
  Eigen::Vector2d centre_W;
};

inline CellPlace place_of(const FreeSpace& space, const Eigen::Vector2d& p_W) {
  const CellRange one = cells_around(space, p_W, p_W);
  return {space.cells[cell_at(space, one.column_0, one.row_0)],
          centre_of(space, one.column_0, one.row_0)};
}

// Visits cells until one says no.
template <typename Visit>  // bool(const FreeSpace::Cell&)
bool every_cell(const FreeSpace& space, const CellRange& range, Visit visit) {
  for (int row = range.row_0; row <= range.row_1; ++row) {
    for (int column = range.column_0; column <= range.column_1; ++column) {
      if (!visit(space.cells[cell_at(space, column, row)])) return false;
    }
  }
  return true;
}

}  // namespace headland
