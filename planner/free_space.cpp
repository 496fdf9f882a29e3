#include "planner/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace headland {
namespace {

using Eigen::Vector2d;

// Cells along the longer side of the field: coarse enough to set up in milliseconds, fine enough
// that most poses are settled by the cell's distance alone.
constexpr double kCellsAlong = 128.0;
constexpr double kMinCell_m = 0.5;
// Depths nearer than this are equal: the first one found, a corner of the hull, names the place.
constexpr double kSameDepth_m = 1e-9;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

// A box about the origin of its own frame.
struct Box {
  Vector2d low;
  Vector2d high;
};

double distance_to_box(const Vector2d& p, const Box& box) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

// Depth of a point inside the box, negative outside.
double depth_in_box(const Vector2d& p, const Box& box) {
  return (p - box.low).cwiseMin(box.high - p).minCoeff();
}

// The part of segment ab in the box, as fractions; false when there is none (Liang-Barsky).
bool clip(const Vector2d& a, const Vector2d& b, const Box& box, double& t0, double& t1) {
  t0 = 0.0;
  t1 = 1.0;
  const Vector2d along = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (a[axis] < box.low[axis] || a[axis] > box.high[axis]) return false;
      continue;
    }
    const double to_low = (box.low[axis] - a[axis]) / along[axis];
    const double to_high = (box.high[axis] - a[axis]) / along[axis];
    t0 = std::max(t0, std::min(to_low, to_high));
    t1 = std::min(t1, std::max(to_low, to_high));
  }
  return t0 <= t1;
}

double segment_to_box(const Vector2d& a, const Vector2d& b, const Box& box) {
  double t0 = 0.0;
  double t1 = 0.0;
  if (clip(a, b, box, t0, t1)) return 0.0;
  double nearest = std::min(distance_to_box(a, box), distance_to_box(b, box));
  for (const double x : {box.low.x(), box.high.x()}) {
    for (const double y : {box.low.y(), box.high.y()}) {
      nearest = std::min(nearest, distance_to_segment({x, y}, a, b));
    }
  }
  return nearest;
}

// Into the frame of the hull and back.
struct HullFrame {
  explicit HullFrame(const Pose& pose) : p_W(pose.p_W), x_W(direction_of(pose.heading_rad)) {}
  Vector2d local(const Vector2d& point_W) const {
    const Vector2d d = point_W - p_W;
    return {d.dot(x_W), cross(x_W, d)};
  }
  Vector2d world(const Vector2d& point) const {
    return p_W + point.x() * x_W + point.y() * Vector2d(-x_W.y(), x_W.x());
  }
  Vector2d p_W;
  Vector2d x_W;
};

Box chassis_of(const Hull& hull) {
  return {{-hull.rear_m, -hull.half_width_m}, {hull.front_m, hull.half_width_m}};
}

std::array<Vector2d, 4> corners_of(const Box& box) {
  return {box.low, Vector2d(box.high.x(), box.low.y()), box.high,
          Vector2d(box.low.x(), box.high.y())};
}

struct CellRange {
  int column_0, column_1, row_0, row_1;  // inclusive, may be empty
};

int cell_index(double offset_m, double cell_m, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / cell_m), 0.0, count - 1.0));
}

CellRange cells_around(const FreeSpace& space, const Vector2d& low_W, const Vector2d& high_W) {
  const Vector2d low = low_W - space.origin_W;
  const Vector2d high = high_W - space.origin_W;
  return {cell_index(low.x(), space.cell_m, space.columns),
          cell_index(high.x(), space.cell_m, space.columns),
          cell_index(low.y(), space.cell_m, space.rows),
          cell_index(high.y(), space.cell_m, space.rows)};
}

std::size_t at(const FreeSpace& space, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(space.columns) +
         static_cast<std::size_t>(column);
}

struct CellPlace {
  const FreeSpace::Cell& cell;
  Vector2d centre_W;
};

CellPlace cell_at(const FreeSpace& space, const Vector2d& p_W) {
  const CellRange one = cells_around(space, p_W, p_W);
  return {space.cells[at(space, one.column_0, one.row_0)],
          space.origin_W + space.cell_m * Vector2d(one.column_0 + 0.5, one.row_0 + 0.5)};
}

template <typename Visit>  // bool(const Cell&), false to stop
bool every_cell(const FreeSpace& space, const CellRange& range, Visit visit) {
  for (int row = range.row_0; row <= range.row_1; ++row) {
    for (int column = range.column_0; column <= range.column_1; ++column) {
      if (!visit(space.cells[at(space, column, row)])) return false;
    }
  }
  return true;
}

bool inside_by_all_edges(const FreeSpace& space, const Vector2d& p_W) {
  bool inside = false;
  for (const FreeSpace::Edge& edge : space.edges) {
    if ((edge.a_W.y() > p_W.y()) == (edge.b_W.y() > p_W.y())) continue;
    const double x = edge.a_W.x() + (p_W.y() - edge.a_W.y()) / (edge.b_W.y() - edge.a_W.y()) *
                                        (edge.b_W.x() - edge.a_W.x());
    if (p_W.x() < x) inside = !inside;
  }
  return inside;
}

// The cell's centre is known to be in or out, and only the cell's edges can lie between.
bool inside(const FreeSpace& space, const Vector2d& p_W) {
  const CellPlace place = cell_at(space, p_W);
  if ((p_W - place.centre_W).cwiseAbs().maxCoeff() > 0.5 * space.cell_m) return false;
  const Vector2d along = p_W - place.centre_W;
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

double bar_distance_m(const FreeSpace& space, const HullFrame& frame, const Obstacle& obstacle) {
  const Hull& hull = space.hull;
  return distance_to_segment(frame.local(obstacle.p_W), {hull.bar_x_m, -hull.bar_half_width_m},
                             {hull.bar_x_m, hull.bar_half_width_m}) -
         obstacle.radius_m;
}

double full_reach_m(const Hull& hull) {
  return std::max(reach_m(hull), std::hypot(hull.bar_x_m, hull.bar_half_width_m));
}

struct NearestEdge {
  double distance_m = std::numeric_limits<double>::max();
  Limit limit = Limit::kBoundary;
};

NearestEdge nearest_edge(const FreeSpace& space, const Vector2d& p_W) {
  NearestEdge nearest;
  for (const FreeSpace::Edge& edge : space.edges) {
    const double distance_m = distance_to_segment(p_W, edge.a_W, edge.b_W);
    if (distance_m < nearest.distance_m) nearest = {distance_m, edge.limit};
  }
  return nearest;
}

void add_to_cells(FreeSpace& space, int index, const Vector2d& low_W, const Vector2d& high_W,
                  std::vector<int> FreeSpace::Cell::*list) {
  const CellRange range = cells_around(space, low_W, high_W);
  for (int row = range.row_0; row <= range.row_1; ++row) {
    for (int column = range.column_0; column <= range.column_1; ++column) {
      (space.cells[at(space, column, row)].*list).push_back(index);
    }
  }
}

void add_ring(const Ring& ring, Limit limit, std::vector<FreeSpace::Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({ring[i], ring[(i + 1) % ring.size()], limit});
  }
}

}  // namespace

Hull hull_of(const Vehicle& vehicle) {
  Hull hull;
  hull.front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  hull.rear_m = vehicle.body.rear_overhang_m;
  hull.half_width_m = 0.5 * vehicle.body.width_m;
  hull.bar_x_m = vehicle.implement.x_B_m;
  hull.bar_half_width_m = 0.5 * vehicle.implement.working_width_m;
  return hull;
}

double reach_m(const Hull& hull) {
  return std::hypot(std::max(hull.front_m, hull.rear_m), hull.half_width_m);
}

FreeSpace free_space(const Field& field, const Hull& hull) {
  FreeSpace space;
  space.hull = hull;
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
  space.cell_m = std::max(kMinCell_m, (high - low).maxCoeff() / kCellsAlong);
  space.columns = static_cast<int>((high.x() - low.x()) / space.cell_m) + 1;
  space.rows = static_cast<int>((high.y() - low.y()) / space.cell_m) + 1;
  space.cells.resize(at(space, 0, space.rows));
  for (std::size_t i = 0; i < space.edges.size(); ++i) {
    const FreeSpace::Edge& edge = space.edges[i];
    add_to_cells(space, static_cast<int>(i), edge.a_W.cwiseMin(edge.b_W),
                 edge.a_W.cwiseMax(edge.b_W), &FreeSpace::Cell::edges);
  }
  for (std::size_t i = 0; i < space.obstacles.size(); ++i) {
    const Obstacle& obstacle = space.obstacles[i];
    const Vector2d extent = Vector2d::Constant(obstacle.radius_m);
    add_to_cells(space, static_cast<int>(i), obstacle.p_W - extent, obstacle.p_W + extent,
                 &FreeSpace::Cell::obstacles);
  }
  for (int row = 0; row < space.rows; ++row) {
    bool inside_here = false;
    for (int column = 0; column < space.columns; ++column) {
      FreeSpace::Cell& cell = space.cells[at(space, column, row)];
      const Vector2d centre = low + space.cell_m * Vector2d(column + 0.5, row + 0.5);
      const double distance = nearest_edge(space, centre).distance_m;
      // No edge runs between two neighbouring centres whose cells hold none.
      if (column == 0 || !cell.edges.empty() ||
          !space.cells[at(space, column - 1, row)].edges.empty()) {
        inside_here = inside_by_all_edges(space, centre);
      }
      cell.edge_distance_m = static_cast<float>(inside_here ? distance : -distance);
      cell.obstacle_distance_m = std::numeric_limits<float>::max();
      for (const Obstacle& obstacle : space.obstacles) {
        const double gap = (obstacle.p_W - centre).norm() - obstacle.radius_m;
        cell.obstacle_distance_m = std::min(cell.obstacle_distance_m, static_cast<float>(gap));
      }
    }
  }
  return space;
}

double safe_distance_m(const FreeSpace& space, const Pose& pose) {
  const CellPlace place = cell_at(space, pose.p_W);
  const double off_centre = (pose.p_W - place.centre_W).norm();
  return std::min(place.cell.edge_distance_m - reach_m(space.hull),
                  place.cell.obstacle_distance_m - full_reach_m(space.hull)) -
         off_centre;
}

bool fits(const FreeSpace& space, const Pose& pose, double clearance_m) {
  if (safe_distance_m(space, pose) > clearance_m) return true;
  const HullFrame frame(pose);
  const Box box = chassis_of(space.hull);
  if (!inside(space, frame.world(0.5 * (box.low + box.high)))) return false;
  const Vector2d extent = Vector2d::Constant(full_reach_m(space.hull) + clearance_m);
  return every_cell(
      space, cells_around(space, pose.p_W - extent, pose.p_W + extent),
      [&](const FreeSpace::Cell& cell) {
        for (const int index : cell.edges) {
          const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
          if (segment_to_box(frame.local(edge.a_W), frame.local(edge.b_W), box) <= clearance_m) {
            return false;
          }
        }
        for (const int index : cell.obstacles) {
          const Obstacle& obstacle = space.obstacles[static_cast<std::size_t>(index)];
          const double gap =
              std::min(distance_to_box(frame.local(obstacle.p_W), box) - obstacle.radius_m,
                       bar_distance_m(space, frame, obstacle));
          if (gap <= clearance_m) return false;
        }
        return true;
      });
}

bool disc_fits(const FreeSpace& space, const Vector2d& p_W, double radius_m) {
  const CellPlace place = cell_at(space, p_W);
  const double off_centre = (p_W - place.centre_W).norm();
  const double nearest =
      std::min<double>(place.cell.edge_distance_m, place.cell.obstacle_distance_m);
  if (nearest - off_centre > radius_m) return true;
  if (nearest + off_centre < radius_m || !inside(space, p_W)) return false;
  const Vector2d extent = Vector2d::Constant(radius_m);
  return every_cell(space, cells_around(space, p_W - extent, p_W + extent),
                    [&](const FreeSpace::Cell& cell) {
                      for (const int index : cell.edges) {
                        const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
                        if (distance_to_segment(p_W, edge.a_W, edge.b_W) <= radius_m) return false;
                      }
                      for (const int index : cell.obstacles) {
                        const Obstacle& obstacle = space.obstacles[static_cast<std::size_t>(index)];
                        if ((obstacle.p_W - p_W).norm() - obstacle.radius_m <= radius_m)
                          return false;
                      }
                      return true;
                    });
}

double reach_along_m(const Hull& hull, double heading_rad, const Vector2d& along_W) {
  const double forward = along_W.dot(direction_of(heading_rad));
  const double aside = std::abs(along_W.dot(left_of(heading_rad)));
  return (forward > 0.0 ? forward * hull.front_m : -forward * hull.rear_m) +
         aside * hull.half_width_m;
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

Overrun overrun(const FreeSpace& space, const Pose& pose) {
  Overrun worst;
  if (fits(space, pose, 0.0)) return worst;
  const HullFrame frame(pose);
  const Box box = chassis_of(space.hull);
  const auto deepen = [&worst](double depth_m, const Vector2d& p_W, Limit limit) {
    if (depth_m > worst.depth_m + kSameDepth_m) worst = {depth_m, p_W, limit};
  };
  for (const Vector2d& corner : corners_of(box)) {
    const Vector2d p_W = frame.world(corner);
    if (inside_by_all_edges(space, p_W)) continue;
    const NearestEdge nearest = nearest_edge(space, p_W);
    deepen(nearest.distance_m, p_W, nearest.limit);
  }
  for (const FreeSpace::Edge& edge : space.edges) {
    const Vector2d a = frame.local(edge.a_W);
    const Vector2d b = frame.local(edge.b_W);
    double t0 = 0.0;
    double t1 = 0.0;
    if (!clip(a, b, box, t0, t1)) continue;
    for (const double t : {t0, 0.5 * (t0 + t1), t1}) {
      const Vector2d p = a + t * (b - a);
      deepen(depth_in_box(p, box), frame.world(p), edge.limit);
    }
  }
  for (const Obstacle& obstacle : space.obstacles) {
    const double gap = distance_to_box(frame.local(obstacle.p_W), box) - obstacle.radius_m;
    deepen(-std::min(gap, bar_distance_m(space, frame, obstacle)), obstacle.p_W, Limit::kObstacle);
  }
  return worst;
}

}  // namespace headland
