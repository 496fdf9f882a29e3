#include "planner/way_lengths.h"

#include <algorithm>
#include <cmath>

#include "planner/disc_cells.h"

namespace headland {
namespace {

using Eigen::Vector2d;

bool in_sight(const DiscCells& cells, const Vector2d& a_W, const Vector2d& b_W) {
  const int steps = static_cast<int>(std::ceil(2.0 * (b_W - a_W).norm() / cells.cell_m));
  for (int i = 1; i < steps; ++i) {
    if (!cells.is_free(cells.at(a_W + (b_W - a_W) * i / steps))) return false;
  }
  return true;
}

}  // namespace

WayLengths::WayLengths(const FreeSpace& space, const std::vector<Vector2d>& from_W,
                       const std::vector<Vector2d>& to_W)
    : to_count_(to_W.size()), length_m_(from_W.size() * to_count_, static_cast<float>(kNoWay_m)) {
  const double longer_m = space.cell_m * std::max(space.columns, space.rows);
  const DiscCells cells = disc_cells(space, space.hull.half_width_m, longer_m / kWayCells);
  std::vector<int> to_cells;
  to_cells.reserve(to_W.size());
  for (const Vector2d& p_W : to_W) to_cells.push_back(nearest_free(cells, p_W));
  for (std::size_t from = 0; from < from_W.size(); ++from) {
    std::vector<float> distance_m;
    for (std::size_t to = 0; to < to_count_; ++to) {
      const double straight_m = (to_W[to] - from_W[from]).norm();
      float& length_m = length_m_[from * to_count_ + to];
      if (in_sight(cells, from_W[from], to_W[to])) {
        length_m = static_cast<float>(straight_m);
        continue;
      }
      if (distance_m.empty()) {
        distance_m = disc_way_lengths(cells, {{nearest_free(cells, from_W[from]), 0.0}});
      }
      const float way_m = distance_m[static_cast<std::size_t>(to_cells[to])];
      if (way_m < static_cast<float>(kNoWay_m)) {
        length_m = std::max(way_m, static_cast<float>(straight_m));
      }
    }
  }
}

}  // namespace headland
