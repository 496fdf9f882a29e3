#include "planner/way_lengths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace headland {
namespace {

using Eigen::Vector2d;

struct Cells {
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
  Vector2d origin_W = Vector2d::Zero();
  std::vector<char> free{};

  Vector2d centre_W(int cell) const {
    return origin_W + cell_m * Vector2d(cell % columns + 0.5, cell / columns + 0.5);
  }
  int at(const Vector2d& p_W) const {
    const Vector2d cell = (p_W - origin_W) / cell_m;
    const int column = std::clamp(static_cast<int>(std::floor(cell.x())), 0, columns - 1);
    const int row = std::clamp(static_cast<int>(std::floor(cell.y())), 0, rows - 1);
    return row * columns + column;
  }
  bool is_free(int cell) const { return free[static_cast<std::size_t>(cell)] != 0; }
};

Cells cells_of(const FreeSpace& space) {
  Cells cells;
  const Vector2d size = space.cell_m * Vector2d(space.columns, space.rows);
  cells.cell_m = size.maxCoeff() / kWayCells;
  cells.columns = static_cast<int>(size.x() / cells.cell_m) + 1;
  cells.rows = static_cast<int>(size.y() / cells.cell_m) + 1;
  cells.origin_W = space.origin_W;
  const int count = cells.columns * cells.rows;
  for (int cell = 0; cell < count; ++cell) {
    cells.free.push_back(disc_fits(space, cells.centre_W(cell), space.hull.half_width_m) ? 1 : 0);
  }
  return cells;
}

int nearest_free(const Cells& cells, const Vector2d& p_W) {
  const int at = cells.at(p_W);
  if (cells.is_free(at)) return at;
  int nearest = at;
  double nearest_m2 = std::numeric_limits<double>::infinity();
  for (int cell = 0; cell < cells.columns * cells.rows; ++cell) {
    if (!cells.is_free(cell)) continue;
    const double away_m2 = (cells.centre_W(cell) - p_W).squaredNorm();
    if (away_m2 >= nearest_m2) continue;
    nearest_m2 = away_m2;
    nearest = cell;
  }
  return nearest;
}

std::vector<float> distances_from(const Cells& cells, int start) {
  std::vector<float> distance_m(cells.free.size(), std::numeric_limits<float>::max());
  using Best = std::pair<float, int>;
  std::priority_queue<Best, std::vector<Best>, std::greater<>> open;
  distance_m[static_cast<std::size_t>(start)] = 0.0F;
  open.emplace(0.0F, start);
  while (!open.empty()) {
    const auto [here_m, cell] = open.top();
    open.pop();
    if (here_m > distance_m[static_cast<std::size_t>(cell)]) continue;
    const int column = cell % cells.columns;
    const int row = cell / cells.columns;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int c = column + dx;
        const int r = row + dy;
        if (c < 0 || r < 0 || c >= cells.columns || r >= cells.rows) continue;
        const int next = r * cells.columns + c;
        const auto there_m = here_m + static_cast<float>(cells.cell_m * std::hypot(dx, dy));
        if (!cells.is_free(next) || there_m >= distance_m[static_cast<std::size_t>(next)]) continue;
        distance_m[static_cast<std::size_t>(next)] = there_m;
        open.emplace(there_m, next);
      }
    }
  }
  return distance_m;
}

bool in_sight(const Cells& cells, const Vector2d& a_W, const Vector2d& b_W) {
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
  const Cells cells = cells_of(space);
  std::vector<int> to_cells;
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
        distance_m = distances_from(cells, nearest_free(cells, from_W[from]));
      }
      const float way_m = distance_m[static_cast<std::size_t>(to_cells[to])];
      if (way_m < static_cast<float>(kNoWay_m)) {
        length_m = std::max(way_m, static_cast<float>(straight_m));
      }
    }
  }
}

}  // namespace headland
