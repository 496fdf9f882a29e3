// The vehicle seen from above: what must keep clear of boundary, holes and obstacles.
#pragma once

#include <Eigen/Core>
#include <array>

#include "planner/arcs.h"
#include "planner/plan.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// From B's origin: a box for the chassis, and the implement as a bar across, kImplementDepth_m
// deep, which may hang over boundary and holes but not through obstacles.
struct Hull {
  double front_m = 0.0;  // reach ahead of B's origin
  double rear_m = 0.0;   // reach behind it
  double half_width_m = 0.0;
  double bar_x_m = 0.0;
  double bar_half_width_m = 0.0;  // 0: no bar
  Gears gears = Gears::kBoth;
  // Wheels: two on each axle; 0: not known.
  double front_axle_x_m = 0.0;
  double rear_axle_x_m = 0.0;
  double half_track_m = 0.0;
};

std::array<Eigen::Vector2d, 4> wheels_of(const Hull& hull);

Hull hull_of(const Vehicle& vehicle);
Hull hull_of(const PlanRequest& request);
// Distance [m] from B's origin to the chassis's furthest corner.
double reach_m(const Hull& hull);
// The same with the ends of the bar.
double reach_with_bar_m(const Hull& hull);
// How far [m] the chassis reaches from B's origin along a unit vector of W.
double reach_along_m(const Hull& hull, double heading_rad, const Eigen::Vector2d& along_W);

// A part of the hull in the frame of a pose: x along its heading.
struct HullBox {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

// The chassis, `shrunk_m` smaller on every side.
HullBox chassis_of(const Hull& hull, double shrunk_m = 0.0);
HullBox bar_of(const Hull& hull);
std::array<Eigen::Vector2d, 4> corners_of(const HullBox& box);
double distance_to_box(const Eigen::Vector2d& p, const HullBox& box);
// Depth of a point inside the box, negative outside.
double depth_in_box(const Eigen::Vector2d& p, const HullBox& box);
// The part of segment ab in the box, as fractions; false when there is none (Liang-Barsky).
bool clip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const HullBox& box, double& t0,
          double& t1);
double segment_to_box(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const HullBox& box);

// Into the frame of a pose and back.
struct PoseFrame {
  explicit PoseFrame(const Pose& pose) : p_W(pose.p_W), x_W(direction_of(pose.heading_rad)) {}
  Eigen::Vector2d local(const Eigen::Vector2d& point_W) const;
  Eigen::Vector2d world(const Eigen::Vector2d& point) const;
  Eigen::Vector2d p_W;
  Eigen::Vector2d x_W;
};

}  // namespace headland
