// Polygons to raster cells, row by row.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace headland {

// Even-odd filling of any set of closed edge loops over cells whose centres are at whole numbers:
// column i, row j has its centre at (i, j). A centre on an edge belongs to the side above and to
// the right, whichever loop the edge is part of: loops that share an edge share out its cells.
struct Scanline {
  int columns = 0;
  int rows = 0;
  std::vector<std::vector<double>> crossings;  // per row: where edges cross it
  int first_row = 0;                           // rows in use: [first_row, last_row]
  int last_row = -1;
};

inline Scanline make_scanline(int columns, int rows) {
  return {columns, rows, std::vector<std::vector<double>>(static_cast<std::size_t>(rows)), rows,
          -1};
}

// The first whole number at or above `value`, held to [0, count].
inline int first_cell(double value, int count) {
  return static_cast<int>(std::clamp(std::ceil(value), 0.0, static_cast<double>(count)));
}

inline void add_edge(Scanline& scan, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  // One order for both directions, so that a shared edge crosses at bit-identical places.
  const bool upward = from.y() < to.y();
  const Eigen::Vector2d& low = upward ? from : to;
  const Eigen::Vector2d& high = upward ? to : from;
  const int begin = first_cell(low.y(), scan.rows);
  const int end = first_cell(high.y(), scan.rows);
  if (begin >= end) return;
  const double slope = (high.x() - low.x()) / (high.y() - low.y());
  for (int row = begin; row < end; ++row) {
    scan.crossings[static_cast<std::size_t>(row)].push_back(low.x() + slope * (row - low.y()));
  }
  scan.first_row = std::min(scan.first_row, begin);
  scan.last_row = std::max(scan.last_row, end - 1);
}

// Calls visit(row, first_column, end_column) for every run of cells inside the loops added since
// the last call, and forgets the loops.
template <typename Visit>
void fill(Scanline& scan, Visit visit) {
  for (int row = scan.first_row; row <= scan.last_row; ++row) {
    std::vector<double>& crossings = scan.crossings[static_cast<std::size_t>(row)];
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int begin = first_cell(crossings[k], scan.columns);
      const int end = first_cell(crossings[k + 1], scan.columns);
      if (begin < end) visit(row, begin, end);
    }
    crossings.clear();
  }
  scan.first_row = scan.rows;
  scan.last_row = -1;
}

}  // namespace headland
