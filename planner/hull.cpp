#include "planner/hull.h"

#include <algorithm>
#include <cmath>

#include "planner/segment.h"

namespace headland {

using Eigen::Vector2d;

Hull hull_of(const Vehicle& vehicle) {
  Hull hull;
  hull.front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  hull.rear_m = vehicle.body.rear_overhang_m;
  hull.half_width_m = 0.5 * vehicle.body.width_m;
  hull.bar_x_m = vehicle.implement.x_B_m;
  hull.bar_half_width_m = 0.5 * vehicle.implement.working_width_m;
  hull.front_axle_x_m = vehicle.front.x_B_m;
  hull.rear_axle_x_m = vehicle.rear.x_B_m;
  hull.half_track_m = 0.5 * std::max(vehicle.front.track_m, vehicle.rear.track_m);
  if (vehicle.implement.trailing) hull.gears = Gears::kForwardOnly;
  return hull;
}

Hull hull_of(const PlanRequest& request) {
  Hull hull;
  hull.front_m = request.vehicle_front_m;
  hull.rear_m = request.vehicle_rear_m;
  hull.half_width_m = 0.5 * request.vehicle_width_m;
  hull.bar_x_m = request.implement_x_B_m;
  hull.bar_half_width_m = 0.5 * request.working_width_m;
  if (request.forward_only) hull.gears = Gears::kForwardOnly;
  return hull;
}

std::array<Vector2d, 4> wheels_of(const Hull& hull) {
  return {Vector2d(hull.rear_axle_x_m, -hull.half_track_m),
          Vector2d(hull.front_axle_x_m, -hull.half_track_m),
          Vector2d(hull.front_axle_x_m, hull.half_track_m),
          Vector2d(hull.rear_axle_x_m, hull.half_track_m)};
}

double reach_m(const Hull& hull) {
  return std::hypot(std::max(hull.front_m, hull.rear_m), hull.half_width_m);
}

double reach_with_bar_m(const Hull& hull) {
  return std::max(reach_m(hull), std::hypot(std::abs(hull.bar_x_m) + 0.5 * kImplementDepth_m,
                                            hull.bar_half_width_m));
}

double reach_along_m(const Hull& hull, double heading_rad, const Vector2d& along_W) {
  const double forward = along_W.dot(direction_of(heading_rad));
  const double aside = std::abs(along_W.dot(left_of(heading_rad)));
  return (forward > 0.0 ? forward * hull.front_m : -forward * hull.rear_m) +
         aside * hull.half_width_m;
}

HullBox chassis_of(const Hull& hull, double shrunk_m) {
  const Vector2d shrunk = Vector2d::Constant(shrunk_m);
  return {Vector2d(-hull.rear_m, -hull.half_width_m) + shrunk,
          Vector2d(hull.front_m, hull.half_width_m) - shrunk};
}

HullBox bar_of(const Hull& hull) {
  const double half_m = hull.bar_half_width_m > 0.0 ? 0.5 * kImplementDepth_m : 0.0;
  return {{hull.bar_x_m - half_m, -hull.bar_half_width_m},
          {hull.bar_x_m + half_m, hull.bar_half_width_m}};
}

std::array<Vector2d, 4> corners_of(const HullBox& box) {
  return {box.low, Vector2d(box.high.x(), box.low.y()), box.high,
          Vector2d(box.low.x(), box.high.y())};
}

double distance_to_box(const Vector2d& p, const HullBox& box) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

double depth_in_box(const Vector2d& p, const HullBox& box) {
  return (p - box.low).cwiseMin(box.high - p).minCoeff();
}

bool clip(const Vector2d& a, const Vector2d& b, const HullBox& box, double& t0, double& t1) {
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

double segment_to_box(const Vector2d& a, const Vector2d& b, const HullBox& box) {
  double t0 = 0.0;
  double t1 = 0.0;
  if (clip(a, b, box, t0, t1)) return 0.0;
  double nearest = std::min(distance_to_box(a, box), distance_to_box(b, box));
  for (const Vector2d& corner : corners_of(box)) {
    nearest = std::min(nearest, distance_to_segment(corner, a, b));
  }
  return nearest;
}

Vector2d PoseFrame::local(const Vector2d& point_W) const {
  const Vector2d d = point_W - p_W;
  return {d.dot(x_W), cross(x_W, d)};
}

Vector2d PoseFrame::world(const Vector2d& point) const {
  return p_W + point.x() * x_W + point.y() * Vector2d(-x_W.y(), x_W.x());
}

}  // namespace headland
