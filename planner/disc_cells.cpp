#include "planner/disc_cells.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace headland {
namespace {

using Eigen::Vector2d;

// Calls visit(cell, step_m) for the cells around one.
template <typename Visit>
void visit_around(const DiscCells& cells, int cell, Visit visit) {
  const int column = cell % cells.columns;
  const int row = cell / cells.columns;
  for (int r = std::max(0, row - 1); r <= std::min(cells.rows - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(cells.columns - 1, column + 1); ++c) {
      const bool diagonal = r != row && c != column;
      visit(r * cells.columns + c, cells.cell_m * (diagonal ? std::numbers::sqrt2 : 1.0));
    }
  }
}

}  // namespace

int DiscCells::at(const Vector2d& p_W) const {
  const Vector2d cell = (p_W - origin_W) / cell_m;
  const int column = std::clamp(static_cast<int>(std::floor(cell.x())), 0, columns - 1);
  const int row = std::clamp(static_cast<int>(std::floor(cell.y())), 0, rows - 1);
  return row * columns + column;
}

Vector2d DiscCells::centre_W(int cell) const {
  const int row = cell / columns;
  return origin_W + cell_m * Vector2d(cell % columns + 0.5, row + 0.5);
}

DiscCells disc_cells(const FreeSpace& space, double radius_m, double cell_m) {
  DiscCells cells;
  const Vector2d size = space.cell_m * Vector2d(space.columns, space.rows);
  cells.origin_W = space.origin_W;
  cells.cell_m = cell_m;
  cells.columns = static_cast<int>(size.x() / cell_m) + 1;
  cells.rows = static_cast<int>(size.y() / cell_m) + 1;
  const int count = cells.columns * cells.rows;
  cells.free.reserve(static_cast<std::size_t>(count));
  for (int cell = 0; cell < count; ++cell) {
    cells.free.push_back(disc_fits(space, cells.centre_W(cell), radius_m) ? 1 : 0);
  }
  return cells;
}

int nearest_free(const DiscCells& cells, const Vector2d& p_W) {
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

std::vector<int> disc_components(const DiscCells& cells) {
  std::vector<int> component(cells.free.size(), -1);
  int count = 0;
  std::vector<int> open;
  const auto reach = [&](int cell) {
    int& of_cell = component[static_cast<std::size_t>(cell)];
    if (of_cell >= 0 || !cells.is_free(cell)) return;
    of_cell = count;
    open.push_back(cell);
  };
  for (int first = 0; first < static_cast<int>(component.size()); ++first) {
    reach(first);
    if (open.empty()) continue;
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      visit_around(cells, cell, [&](int next, double /*step_m*/) { reach(next); });
    }
    ++count;
  }
  return component;
}

std::vector<int> grown_components(const DiscCells& cells, std::vector<int> component) {
  std::vector<int> edge;
  for (int cell = 0; cell < static_cast<int>(component.size()); ++cell) {
    if (component[static_cast<std::size_t>(cell)] >= 0) edge.push_back(cell);
  }
  while (!edge.empty()) {
    std::vector<int> next_edge;
    for (const int cell : edge) {
      visit_around(cells, cell, [&](int next, double /*step_m*/) {
        int& of_next = component[static_cast<std::size_t>(next)];
        if (of_next >= 0 || !cells.is_free(next)) return;
        of_next = component[static_cast<std::size_t>(cell)];
        next_edge.push_back(next);
      });
    }
    edge = std::move(next_edge);
  }
  return component;
}

std::vector<float> disc_way_lengths(const DiscCells& cells, const std::vector<WayBegin>& begins) {
  std::vector<float> length_m(cells.free.size(), kNoDiscWay_m);
  using Reached = std::pair<float, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  const auto reach = [&](int cell, double way_m) {
    float& known_m = length_m[static_cast<std::size_t>(cell)];
    if (static_cast<float>(way_m) >= known_m) return;
    known_m = static_cast<float>(way_m);
    open.emplace(known_m, cell);
  };
  for (const WayBegin& begin : begins) reach(begin.cell, begin.length_m);
  while (!open.empty()) {
    const auto [here_m, cell] = open.top();
    open.pop();
    if (here_m > length_m[static_cast<std::size_t>(cell)]) continue;
    visit_around(cells, cell, [&, way_m = here_m](int next, double step_m) {
      if (cells.is_free(next)) reach(next, way_m + step_m);
    });
  }
  return length_m;
}

std::vector<Vector2d> disc_way(DiscCells cells, const Vector2d& from_W, const Vector2d& to_W) {
  const int goal = cells.at(to_W);
  int cell = cells.at(from_W);
  for (const int end : {cell, goal}) cells.free[static_cast<std::size_t>(end)] = 1;
  const std::vector<float> length_m = disc_way_lengths(cells, {{goal, 0.0}});
  if (length_m[static_cast<std::size_t>(cell)] >= kNoDiscWay_m) return {};
  std::vector<Vector2d> way{cells.centre_W(cell)};
  while (cell != goal) {
    int next = cell;
    double least_m = std::numeric_limits<double>::infinity();
    visit_around(cells, cell, [&](int other, double step_m) {
      const double way_m = length_m[static_cast<std::size_t>(other)] + step_m;
      if (other == cell || way_m >= least_m) return;
      least_m = way_m;
      next = other;
    });
    cell = next;
    way.push_back(cells.centre_W(cell));
  }
  return way;
}

}  // namespace headland
