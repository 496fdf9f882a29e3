#include "terrains/grid_map_from_field.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "terrains/input_error.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// The field in the map's own frame: origin in the outer corner of cell (0, 0), x along rows.
struct TurnedField {
  std::vector<Ring> rings;
  std::vector<Obstacle> obstacles;
};

TurnedField in_map_frame(const Field& field, const GridMap& map) {
  const Eigen::Rotation2Dd back(-map.direction_rad);
  TurnedField result;
  result.rings.push_back(field.boundary);
  result.rings.insert(result.rings.end(), field.holes.begin(), field.holes.end());
  for (Ring& ring : result.rings) {
    for (Vector2d& p : ring) p = back * (p - map.origin_W);
  }
  result.obstacles = field.obstacles;
  for (Obstacle& obstacle : result.obstacles) {
    obstacle.p_W = back * (obstacle.p_W - map.origin_W);
    obstacle.run_W = back * obstacle.run_W;
  }
  return result;
}

int clamped_cell(double along_m, double cell_m, int count) {
  return static_cast<int>(std::clamp(std::floor(along_m / cell_m), 0.0, count - 1.0));
}

// Blocks every cell whose centre lies outside, by where the rings cross the row's middle.
void block_outside(const TurnedField& field, GridMap& map) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(map.rows));
  for (const Ring& ring : field.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d& a = ring[i];
      const Vector2d& b = ring[(i + 1) % ring.size()];
      const int last = clamped_cell(std::max(a.y(), b.y()), map.cell_m, map.rows);
      for (int row = clamped_cell(std::min(a.y(), b.y()), map.cell_m, map.rows); row <= last;
           ++row) {
        const double y = (row + 0.5) * map.cell_m;
        if ((a.y() > y) == (b.y() > y)) continue;
        crossings[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) *
                                                                       (b.x() - a.x()));
      }
    }
  }
  for (int row = 0; row < map.rows; ++row) {
    std::vector<double>& crossed = crossings[static_cast<std::size_t>(row)];
    std::ranges::sort(crossed);
    for (int column = 0; column < map.columns; ++column) {
      const double x = (column + 0.5) * map.cell_m;
      const auto beyond = crossed.end() - std::ranges::upper_bound(crossed, x);
      if (beyond % 2 == 0) map.blocked[index_of(map, {column, row})] = 1;
    }
  }
}

// Blocks the cells through whose inside the edge runs, row by row.
void block_edge(const Vector2d& a, const Vector2d& b, GridMap& map) {
  const double low_m = std::min(a.y(), b.y());
  const double high_m = std::max(a.y(), b.y());
  const int last_row = clamped_cell(high_m, map.cell_m, map.rows);
  for (int row = clamped_cell(low_m, map.cell_m, map.rows); row <= last_row; ++row) {
    const double bottom_m = row * map.cell_m + kEdgeInside_m;
    const double top_m = (row + 1) * map.cell_m - kEdgeInside_m;
    if (high_m < bottom_m || low_m > top_m) continue;
    const auto x_at = [&](double y_m) {
      const double part = std::clamp((y_m - a.y()) / (b.y() - a.y()), 0.0, 1.0);
      return a.x() + part * (b.x() - a.x());
    };
    const bool level = high_m - low_m < kEdgeInside_m;
    const double from_m = level ? a.x() : x_at(bottom_m);
    const double to_m = level ? b.x() : x_at(top_m);
    const auto [left_m, right_m] = std::minmax(from_m, to_m);
    const int last_column = clamped_cell(right_m, map.cell_m, map.columns);
    for (int column = clamped_cell(left_m, map.cell_m, map.columns); column <= last_column;
         ++column) {
      const bool runs_inside = left_m <= (column + 1) * map.cell_m - kEdgeInside_m &&
                               right_m >= column * map.cell_m + kEdgeInside_m;
      if (runs_inside) map.blocked[index_of(map, {column, row})] = 1;
    }
  }
}

// Distance [m] of the obstacle's middle line from the square with these corners.
double gap_to_square_m(const Obstacle& obstacle, const Vector2d& low, const Vector2d& high) {
  const auto to_square_m = [&](const Vector2d& p) {
    return (p - p.cwiseMax(low).cwiseMin(high)).norm();
  };
  const Vector2d end = obstacle.p_W + obstacle.run_W;
  double gap_m = std::min(to_square_m(obstacle.p_W), to_square_m(end));
  // A line that passes the square comes nearest at a corner, unless it runs through, which
  // separates corners or crosses a diagonal.
  const std::array<Vector2d, 4> corners = {low, Vector2d(high.x(), low.y()), high,
                                           Vector2d(low.x(), high.y())};
  for (const Vector2d& corner : corners) {
    gap_m = std::min(gap_m, (corner - nearest_of(obstacle, corner)).norm());
  }
  const auto side = [&](const Vector2d& p) {
    const Vector2d to_p = p - obstacle.p_W;
    return obstacle.run_W.x() * to_p.y() - obstacle.run_W.y() * to_p.x();
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector2d& from = corners[i];
    const Vector2d diagonal = corners[i + 2] - from;
    const auto across = [&](const Vector2d& p) {
      const Vector2d to_p = p - from;
      return diagonal.x() * to_p.y() - diagonal.y() * to_p.x();
    };
    if (side(from) * side(corners[i + 2]) < 0.0 && across(obstacle.p_W) * across(end) < 0.0) {
      return 0.0;
    }
  }
  return gap_m;
}

void block_obstacle(const Obstacle& obstacle, GridMap& map) {
  const Vector2d reach = Vector2d::Constant(obstacle.radius_m);
  const Vector2d end = obstacle.p_W + obstacle.run_W;
  const Vector2d low = obstacle.p_W.cwiseMin(end) - reach;
  const Vector2d high = obstacle.p_W.cwiseMax(end) + reach;
  const int last_row = clamped_cell(high.y(), map.cell_m, map.rows);
  const int last_column = clamped_cell(high.x(), map.cell_m, map.columns);
  for (int row = clamped_cell(low.y(), map.cell_m, map.rows); row <= last_row; ++row) {
    for (int column = clamped_cell(low.x(), map.cell_m, map.columns); column <= last_column;
         ++column) {
      const Vector2d corner(column * map.cell_m, row * map.cell_m);
      const Vector2d side = Vector2d::Constant(map.cell_m);
      if (gap_to_square_m(obstacle, corner, corner + side) <= obstacle.radius_m) {
        map.blocked[index_of(map, {column, row})] = 1;
      }
    }
  }
}

// Columns or rows that cover the length; rounding does not make one more.
int squares_along(double length_m, double cell_m) {
  return std::max(1, static_cast<int>(std::ceil((length_m - kEdgeInside_m) / cell_m)));
}

// An all free map around the field.
GridMap map_around(const Field& field, double cell_m, double direction_rad,
                   const std::string& source) {
  if (!(cell_m >= kMinGridCell_m && cell_m <= kMaxGridCell_m)) {
    throw InputError(source, "cell_m", fmt::format("{}", cell_m),
                     fmt::format("a number from {} to {}", kMinGridCell_m, kMaxGridCell_m));
  }
  const Eigen::Rotation2Dd back(-direction_rad);
  Vector2d low = back * field.boundary.front();
  Vector2d high = low;
  for (const Vector2d& p_W : field.boundary) {
    low = low.cwiseMin(back * p_W);
    high = high.cwiseMax(back * p_W);
  }
  const Vector2d extent = high - low;
  if (extent.maxCoeff() > cell_m * kMaxGridSide) {
    throw InputError(source, "cell_m", fmt::format("{}", cell_m),
                     fmt::format("at least {:.3g}: a map has at most {} columns and rows",
                                 extent.maxCoeff() / kMaxGridSide, kMaxGridSide));
  }
  GridMap map = free_grid_map(squares_along(extent.x(), cell_m), squares_along(extent.y(), cell_m));
  map.cell_m = cell_m;
  map.origin_W = Eigen::Rotation2Dd(direction_rad) * low;
  map.direction_rad = direction_rad;
  return map;
}

std::size_t area_to_keep(const GridMap& map, const GridAreas& areas,
                         const std::optional<Vector2d>& entry_W) {
  if (!entry_W) {
    const auto largest = std::ranges::max_element(areas.areas, {}, &GridArea::cells);
    return static_cast<std::size_t>(largest - areas.areas.begin());
  }
  std::size_t nearest = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const int area = areas.area_of[index_of(map, {column, row})];
      const double distance_m = (centre_W(map, {column, row}) - *entry_W).norm();
      if (area < 0 || distance_m >= nearest_m) continue;
      nearest = static_cast<std::size_t>(area);
      nearest_m = distance_m;
    }
  }
  return nearest;
}

void fill_pockets(const std::optional<Vector2d>& entry_W, FieldGrid& grid) {
  const GridAreas areas = areas_of(grid.map);
  const std::size_t kept = area_to_keep(grid.map, areas, entry_W);
  for (std::size_t i = 0; i < areas.areas.size(); ++i) {
    const GridArea& area = areas.areas[i];
    if (i != kept) {
      grid.pockets.push_back({area.first, centre_W(grid.map, area.first), area.cells});
    }
  }
  for (std::size_t i = 0; i < grid.map.blocked.size(); ++i) {
    if (areas.area_of[i] != static_cast<int>(kept)) grid.map.blocked[i] = 1;
  }
}

}  // namespace

FieldGrid grid_of_field(const Field& field, double cell_m, double direction_rad,
                        const std::string& source) {
  FieldGrid grid;
  grid.map = map_around(field, cell_m, direction_rad, source);
  const TurnedField in_map = in_map_frame(field, grid.map);
  block_outside(in_map, grid.map);
  for (const Ring& ring : in_map.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      block_edge(ring[i], ring[(i + 1) % ring.size()], grid.map);
    }
  }
  for (const Obstacle& obstacle : in_map.obstacles) block_obstacle(obstacle, grid.map);
  if (free_cell_count(grid.map) == 0) {
    throw InputError(source, "cell_m", fmt::format("{}", cell_m),
                     "less: no cell of this width lies wholly inside the field");
  }
  fill_pockets(field.entry_W, grid);
  grid.left_out_m2 = field_area_m2(field) - free_cell_count(grid.map) * cell_m * cell_m;
  return grid;
}

}  // namespace headland
