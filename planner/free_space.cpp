#include "planner/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <numeric>

#include "planner/segment.h"
#include "planner/space_cells.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Cells in all: few enough to set up in some 10 ms, enough that most poses are settled by the
// cell's distance alone and few edges run through each, in long fields too.
constexpr double kMostCells = 256.0 * 256.0;
constexpr double kMinCell_m = 0.5;
// An edge is listed in the cells that it misses by less than this, which is rounding [m].
constexpr double kListed_m = 1e-6;

void add_ring(const Ring& ring, Limit limit, std::vector<FreeSpace::Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({ring[i], ring[(i + 1) % ring.size()], limit});
  }
}

void add_to_cells(FreeSpace& space, int index, const Vector2d& low_W, const Vector2d& high_W,
                  std::vector<int> FreeSpace::Cell::*list) {
  const CellRange range = cells_around(space, low_W, high_W);
  for (int row = range.row_0; row <= range.row_1; ++row) {
    for (int column = range.column_0; column <= range.column_1; ++column) {
      (space.cells[cell_at(space, column, row)].*list).push_back(index);
    }
  }
}

// Lists an edge in the cells it runs through, row by row.
void add_edge_to_cells(FreeSpace& space, int index) {
  const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
  const Vector2d& low = edge.a_W.y() < edge.b_W.y() ? edge.a_W : edge.b_W;
  const Vector2d& high = edge.a_W.y() < edge.b_W.y() ? edge.b_W : edge.a_W;
  const double rise_m = high.y() - low.y();
  const auto x_at = [&](double y) {
    if (!(rise_m > 0.0)) return low.x();
    return low.x() + std::clamp((y - low.y()) / rise_m, 0.0, 1.0) * (high.x() - low.x());
  };
  const Vector2d listed = Vector2d::Constant(kListed_m);
  const CellRange rows = cells_around(space, low - listed, high + listed);
  for (int row = rows.row_0; row <= rows.row_1; ++row) {
    const double bottom = space.origin_W.y() + space.cell_m * row;
    double x_0 = x_at(bottom - kListed_m);
    double x_1 = rise_m > 0.0 ? x_at(bottom + space.cell_m + kListed_m) : high.x();
    if (x_0 > x_1) std::swap(x_0, x_1);
    const double y = bottom + 0.5 * space.cell_m;
    add_to_cells(space, index, Vector2d(x_0 - kListed_m, y), Vector2d(x_1 + kListed_m, y),
                 &FreeSpace::Cell::edges);
  }
}

// Where the edges cross the lines through the centres of the rows, ascending in each row.
std::vector<std::vector<double>> crossings_of_rows(const FreeSpace& space) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(space.rows));
  for (const FreeSpace::Edge& edge : space.edges) {
    const CellRange range =
        cells_around(space, edge.a_W.cwiseMin(edge.b_W), edge.a_W.cwiseMax(edge.b_W));
    for (int row = range.row_0; row <= range.row_1; ++row) {
      const double y = centre_of(space, 0, row).y();
      if ((edge.a_W.y() > y) == (edge.b_W.y() > y)) continue;
      crossings[static_cast<std::size_t>(row)].push_back(
          edge.a_W.x() +
          (y - edge.a_W.y()) / (edge.b_W.y() - edge.a_W.y()) * (edge.b_W.x() - edge.a_W.x()));
    }
  }
  for (std::vector<double>& row : crossings) std::sort(row.begin(), row.end());
  return crossings;
}

// Visits the cells that are `ring` cells away from one, in the grid.
template <typename Visit>  // void(const FreeSpace::Cell&)
void visit_ring(const FreeSpace& space, int column, int row, int ring, Visit visit) {
  const auto in_columns = [&](int c) { return c >= 0 && c < space.columns; };
  for (int r = std::max(0, row - ring); r <= std::min(space.rows - 1, row + ring); ++r) {
    if (std::abs(r - row) == ring) {
      const int last = std::min(space.columns - 1, column + ring);
      for (int c = std::max(0, column - ring); c <= last; ++c) {
        visit(space.cells[cell_at(space, c, r)]);
      }
    } else {
      if (in_columns(column - ring)) visit(space.cells[cell_at(space, column - ring, r)]);
      if (in_columns(column + ring)) visit(space.cells[cell_at(space, column + ring, r)]);
    }
  }
}

double distance_to_edge(const FreeSpace& space, const Vector2d& p_W, int index) {
  const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
  return distance_to_segment(p_W, edge.a_W, edge.b_W);
}

// Calls visit(column, row, distance_m) for every cell of the range, with the distance from its
// centre to the nearest of `near`, by halves: what is nearest to a place in a half is no further
// from the half's middle than the nearest to that, and twice as far as the place is.
template <typename Distance, typename Visit>
void measure_cells(const FreeSpace& space, const CellRange& range, const std::vector<int>& near,
                   const Distance& distance_to_m, const Visit& visit) {
  const Vector2d low = centre_of(space, range.column_0, range.row_0);
  const Vector2d high = centre_of(space, range.column_1, range.row_1);
  std::vector<double> away_m;
  double least_m = std::numeric_limits<float>::max();
  for (const int index : near) {
    away_m.push_back(distance_to_m(0.5 * (low + high), index));
    least_m = std::min(least_m, away_m.back());
  }
  const bool across = range.column_1 - range.column_0 >= range.row_1 - range.row_0;
  if (across && range.column_0 == range.column_1) {
    visit(range.column_0, range.row_0, least_m);
    return;
  }
  const double most_m = least_m + (high - low).norm() + kListed_m;
  std::vector<int> kept;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (away_m[i] <= most_m) kept.push_back(near[i]);
  }
  CellRange first = range;
  CellRange second = range;
  int& end = across ? first.column_1 : first.row_1;
  int& begin = across ? second.column_0 : second.row_0;
  end = (across ? range.column_0 + range.column_1 : range.row_0 + range.row_1) / 2;
  begin = end + 1;
  measure_cells(space, first, kept, distance_to_m, visit);
  measure_cells(space, second, kept, distance_to_m, visit);
}

template <typename Distance, typename Visit>
void measure(const FreeSpace& space, std::size_t count, const Distance& distance_to_m,
             const Visit& visit) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  measure_cells(space, {0, space.columns - 1, 0, space.rows - 1}, all, distance_to_m, visit);
}

void measure_edges(FreeSpace& space) {
  const std::vector<std::vector<double>> crossings = crossings_of_rows(space);
  const auto to_edge_m = [&](const Vector2d& p_W, int index) {
    return distance_to_edge(space, p_W, index);
  };
  measure(space, space.edges.size(), to_edge_m, [&](int column, int row, double distance_m) {
    const std::vector<double>& crossing = crossings[static_cast<std::size_t>(row)];
    const double x = centre_of(space, column, row).x();
    const auto beyond = crossing.end() - std::upper_bound(crossing.begin(), crossing.end(), x);
    space.cells[cell_at(space, column, row)].edge_distance_m =
        static_cast<float>(beyond % 2 == 1 ? distance_m : -distance_m);
  });
}

void measure_obstacles(FreeSpace& space) {
  const auto to_obstacle_m = [&](const Vector2d& p_W, int index) {
    return obstacle_gap_m(space.obstacles[static_cast<std::size_t>(index)], p_W);
  };
  measure(space, space.obstacles.size(), to_obstacle_m, [&](int column, int row, double gap_m) {
    space.cells[cell_at(space, column, row)].obstacle_distance_m = static_cast<float>(gap_m);
  });
}

}  // namespace

FreeSpace free_space(const Field& field, const Hull& hull) {
  FreeSpace space;
  space.hull = hull;
  space.reach_m = reach_m(hull);
  space.reach_with_bar_m = reach_with_bar_m(hull);
  space.obstacles = field.obstacles;
  add_ring(field.boundary, Limit::kBoundary, space.edges);
  for (const Ring& hole : field.holes) add_ring(hole, Limit::kHole, space.edges);
  Vector2d low = field.boundary.front();
  Vector2d high = low;
  for (const Vector2d& p : field.boundary) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  space.origin_W = low;
  const Vector2d size = high - low;
  space.cell_m =
      std::max({kMinCell_m, std::sqrt(size.prod() / kMostCells), size.maxCoeff() / kMostCells});
  space.columns = static_cast<int>((high.x() - low.x()) / space.cell_m) + 1;
  space.rows = static_cast<int>((high.y() - low.y()) / space.cell_m) + 1;
  space.cells.resize(cell_at(space, 0, space.rows));
  for (std::size_t i = 0; i < space.edges.size(); ++i) {
    add_edge_to_cells(space, static_cast<int>(i));
  }
  for (std::size_t i = 0; i < space.obstacles.size(); ++i) {
    const Obstacle& obstacle = space.obstacles[i];
    const Vector2d extent = Vector2d::Constant(obstacle.radius_m);
    const Vector2d end_W = obstacle.p_W + obstacle.run_W;
    add_to_cells(space, static_cast<int>(i), obstacle.p_W.cwiseMin(end_W) - extent,
                 obstacle.p_W.cwiseMax(end_W) + extent, &FreeSpace::Cell::obstacles);
  }
  measure_edges(space);
  measure_obstacles(space);
  return space;
}

// The cell's centre is known to be in or out, and only the cell's edges can lie between.
bool inside(const FreeSpace& space, const Vector2d& p_W) {
  const CellPlace place = place_of(space, p_W);
  const Vector2d along = p_W - place.centre_W;
  // Beyond all cells; on a border of two it may be a rounding outside either.
  if (along.cwiseAbs().maxCoeff() > 0.5 * space.cell_m + kListed_m) return false;
  bool result = place.cell.edge_distance_m > 0.0F;
  for (const int index : place.cell.edges) {
    const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
    const double side_a = cross(along, edge.a_W - place.centre_W);
    const double side_b = cross(along, edge.b_W - place.centre_W);
    if ((side_a > 0.0) == (side_b > 0.0)) continue;
    const Vector2d run = edge.b_W - edge.a_W;
    const double side_p = cross(run, p_W - edge.a_W);
    const double side_c = cross(run, place.centre_W - edge.a_W);
    if ((side_p > 0.0) != (side_c > 0.0)) result = !result;
  }
  return result;
}

NearestEdge nearest_edge(const FreeSpace& space, const Vector2d& p_W) {
  NearestEdge nearest{std::numeric_limits<double>::max(), 0};
  const CellPlace place = place_of(space, p_W);
  // No edge is nearer than that, so cells all of whose ground is are empty.
  const double least_m =
      std::abs(place.cell.edge_distance_m) - (p_W - place.centre_W).norm() - space.cell_m;
  const int first_ring =
      std::max(0, static_cast<int>(std::floor(least_m / space.cell_m / std::numbers::sqrt2 - 0.5)));
  const CellRange one = cells_around(space, p_W, p_W);
  // Further and further out until no edge there can be nearer than the best one.
  const int last_ring = std::max(space.columns, space.rows);
  for (int ring = first_ring; ring <= last_ring; ++ring) {
    if (nearest.distance_m <= space.cell_m * (ring - 1)) break;
    visit_ring(space, one.column_0, one.row_0, ring, [&](const FreeSpace::Cell& cell) {
      for (const int index : cell.edges) {
        const double distance_m = distance_to_edge(space, p_W, index);
        if (distance_m < nearest.distance_m) nearest = {distance_m, index};
      }
    });
  }
  return nearest;
}

EdgeAhead edge_ahead(const FreeSpace& space, const Vector2d& p_W, double heading_rad) {
  EdgeAhead ahead{std::numeric_limits<double>::max(), Vector2d::Zero()};
  const Vector2d ray = direction_of(heading_rad);
  for (const FreeSpace::Edge& edge : space.edges) {
    const Vector2d along = edge.b_W - edge.a_W;
    const double across = cross(ray, along);
    if (across == 0.0) continue;
    const double t = cross(edge.a_W - p_W, along) / across;
    const double u = cross(edge.a_W - p_W, ray) / across;
    if (t < 0.0 || t >= ahead.distance_m || u < 0.0 || u > 1.0) continue;
    // Boundary counter-clockwise, holes clockwise: the field is on the left of every edge.
    ahead = {t, Vector2d(along.y(), -along.x()).normalized()};
  }
  return ahead;
}

}  // namespace headland
