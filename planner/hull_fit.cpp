#include <algorithm>
#include <cmath>

#include "planner/free_space.h"
#include "planner/segment.h"
#include "planner/space_cells.h"
#include "planner/worked_ground.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Depths nearer than this are equal: the first one found, a corner of the hull, names the place.
constexpr double kSameDepth_m = 1e-9;

double box_gap_m(const PoseFrame& frame, const HullBox& box, const Obstacle& obstacle) {
  const Vector2d p = frame.local(obstacle.p_W);
  const double distance_m =
      obstacle.run_W.isZero(0.0)
          ? distance_to_box(p, box)
          : segment_to_box(p, frame.local(obstacle.p_W + obstacle.run_W), box);
  return distance_m - obstacle.radius_m;
}

double bar_gap_m(const FreeSpace& space, const PoseFrame& frame, const Obstacle& obstacle) {
  return box_gap_m(frame, bar_of(space.hull), obstacle);
}

CellRange cells_near(const FreeSpace& space, const Vector2d& p_W, double extent_m) {
  const Vector2d extent = Vector2d::Constant(extent_m);
  return cells_around(space, p_W - extent, p_W + extent);
}

// A gap to an obstacle counts so much.
double counted_m(double gap_m) { return gap_m > 0.0 ? gap_m / kObstacleClearances : gap_m; }

// Visits the gaps, as they count, between what may be within `reach_m` of the hull and the hull
// with its chassis `shrunk_m` smaller, until one says no; edges that touch the box have the gap 0.
template <typename Visit>  // bool(double gap_m)
bool every_gap(const FreeSpace& space, const Pose& pose, double shrunk_m, double reach_m,
               Visit visit) {
  const PoseFrame frame(pose);
  const HullBox box = chassis_of(space.hull, shrunk_m);
  const HullBox bar = bar_of(space.hull);
  const Vector2d middle_W = frame.world(0.5 * (box.low + box.high));
  const double corner_m = 0.5 * (box.high - box.low).norm();
  const double reach_obstacles_m =
      space.obstacles.empty() ? reach_m : kObstacleClearances * reach_m;
  const CellRange near = cells_near(space, pose.p_W, space.reach_with_bar_m + reach_obstacles_m);
  // One end tells of most pieces that they end before they come near: fences have thousands.
  const auto beyond = [](double end_m, const Vector2d& run_W, double within_m) {
    const double spare_m = end_m - within_m;
    return spare_m > 0.0 && spare_m * spare_m > run_W.squaredNorm();
  };
  return every_cell(space, near, [&](const FreeSpace::Cell& cell) {
    for (const int index : cell.edges) {
      const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
      const double away_m = distance_to_segment(middle_W, edge.a_W, edge.b_W);
      if (away_m > corner_m + reach_m) continue;
      if (!visit(segment_to_box(frame.local(edge.a_W), frame.local(edge.b_W), box))) return false;
    }
    for (const int index : cell.obstacles) {
      const Obstacle& obstacle = space.obstacles[static_cast<std::size_t>(index)];
      const Vector2d p = frame.local(obstacle.p_W);
      const double end_m = std::min(distance_to_box(p, box), distance_to_box(p, bar));
      if (beyond(end_m, obstacle.run_W, obstacle.radius_m + reach_obstacles_m)) continue;
      const double chassis_m = box_gap_m(frame, box, obstacle);
      const double gap_m = std::min(chassis_m, bar_gap_m(space, frame, obstacle) + shrunk_m);
      if (!visit(counted_m(gap_m))) return false;
    }
    return true;
  });
}

}  // namespace

bool keeps_off_worked(const FreeSpace& space, const Pose& pose) {
  if (space.worked == nullptr) return true;
  const PoseFrame frame(pose);
  return std::ranges::none_of(wheels_of(space.hull), [&](const Vector2d& wheel) {
    return state_at(*space.worked, frame.world(wheel)) == GroundState::kWorked;
  });
}

double safe_distance_m(const FreeSpace& space, const Pose& pose) {
  const CellPlace place = place_of(space, pose.p_W);
  const double off_centre_m = (pose.p_W - place.centre_W).norm();
  return std::min(
      place.cell.edge_distance_m - space.reach_m - off_centre_m,
      counted_m(place.cell.obstacle_distance_m - space.reach_with_bar_m - off_centre_m));
}

double spare_m(const FreeSpace& space, const Pose& pose, double clearance_m, double most_m) {
  if (safe_distance_m(space, pose) > clearance_m + most_m) return most_m;
  const HullBox box = chassis_of(space.hull);
  if (!inside(space, PoseFrame(pose).world(0.5 * (box.low + box.high)))) return -1.0;
  const double kept_m = std::max(0.0, clearance_m);
  const double shrunk_m = kept_m - clearance_m;
  double least_m = most_m;
  const bool kept = every_gap(space, pose, shrunk_m, kept_m + most_m, [&](double gap_m) {
    least_m = std::min(least_m, gap_m - kept_m);
    return gap_m > kept_m;
  });
  return kept ? least_m : -1.0;
}

bool fits(const FreeSpace& space, const Pose& pose, double clearance_m) {
  if (!keeps_off_worked(space, pose)) return false;
  return safe_distance_m(space, pose) > clearance_m ||
         spare_m(space, pose, clearance_m, 0.0) >= 0.0;
}

bool works_inside(const FreeSpace& space, const Pose& pose, double overhang_m) {
  const Hull& hull = space.hull;
  const double half_m = hull.bar_half_width_m - overhang_m - kFitTolerance_m;
  if (half_m <= 0.0) return true;
  const Vector2d middle_W = pose.p_W + hull.bar_x_m * direction_of(pose.heading_rad);
  const CellPlace place = place_of(space, middle_W);
  if (place.cell.edge_distance_m - (middle_W - place.centre_W).norm() > half_m) return true;
  const Vector2d left_W = middle_W + half_m * left_of(pose.heading_rad);
  const Vector2d right_W = middle_W - half_m * left_of(pose.heading_rad);
  if (!inside(space, left_W) || !inside(space, right_W)) return false;
  const Vector2d bar = left_W - right_W;
  const CellRange near = cells_around(space, left_W.cwiseMin(right_W), left_W.cwiseMax(right_W));
  return every_cell(space, near, [&](const FreeSpace::Cell& cell) {
    return std::ranges::none_of(cell.edges, [&](int index) {
      const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
      const Vector2d run = edge.b_W - edge.a_W;
      return (cross(bar, edge.a_W - right_W) > 0.0) != (cross(bar, edge.b_W - right_W) > 0.0) &&
             (cross(run, right_W - edge.a_W) > 0.0) != (cross(run, left_W - edge.a_W) > 0.0);
    });
  });
}

double clearance_m(const FreeSpace& space, const Pose& pose, double most_m) {
  if (safe_distance_m(space, pose) > most_m) return most_m;
  if (!fits(space, pose, 0.0)) return -overrun(space, pose).depth_m;
  double least_m = most_m;
  every_gap(space, pose, 0.0, most_m, [&least_m](double gap_m) {
    least_m = std::min(least_m, gap_m);
    return true;
  });
  return least_m;
}

bool disc_fits(const FreeSpace& space, const Vector2d& p_W, double radius_m) {
  if (space.worked != nullptr && state_at(*space.worked, p_W) == GroundState::kWorked) return false;
  const CellPlace place = place_of(space, p_W);
  const double off_centre_m = (p_W - place.centre_W).norm();
  const double nearest_m =
      std::min<double>(place.cell.edge_distance_m, place.cell.obstacle_distance_m);
  if (nearest_m - off_centre_m > radius_m) return true;
  if (nearest_m + off_centre_m < radius_m || !inside(space, p_W)) return false;
  return every_cell(space, cells_near(space, p_W, radius_m), [&](const FreeSpace::Cell& cell) {
    for (const int index : cell.edges) {
      const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
      if (distance_to_segment(p_W, edge.a_W, edge.b_W) <= radius_m) return false;
    }
    for (const int index : cell.obstacles) {
      const Obstacle& obstacle = space.obstacles[static_cast<std::size_t>(index)];
      if (obstacle_gap_m(obstacle, p_W) <= radius_m) return false;
    }
    return true;
  });
}

Overrun overrun(const FreeSpace& space, const Pose& pose) {
  Overrun worst;
  if (fits(space, pose, 0.0)) return worst;
  const PoseFrame frame(pose);
  const HullBox box = chassis_of(space.hull);
  const auto deepen = [&worst](double depth_m, const Vector2d& p_W, Limit limit) {
    if (depth_m > worst.depth_m + kSameDepth_m) worst = {depth_m, p_W, limit};
  };
  for (const Vector2d& corner : corners_of(box)) {
    const Vector2d p_W = frame.world(corner);
    if (inside(space, p_W)) continue;
    const NearestEdge nearest = nearest_edge(space, p_W);
    deepen(nearest.distance_m, p_W, space.edges[static_cast<std::size_t>(nearest.edge)].limit);
  }
  const CellRange near = cells_near(space, pose.p_W, space.reach_with_bar_m);
  every_cell(space, near, [&](const FreeSpace::Cell& cell) {
    for (const int index : cell.edges) {
      const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
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
    for (const int index : cell.obstacles) {
      const Obstacle& obstacle = space.obstacles[static_cast<std::size_t>(index)];
      const double gap_m = box_gap_m(frame, box, obstacle);
      deepen(-std::min(gap_m, bar_gap_m(space, frame, obstacle)), nearest_of(obstacle, pose.p_W),
             Limit::kObstacle);
    }
    return true;
  });
  return worst;
}

}  // namespace headland
