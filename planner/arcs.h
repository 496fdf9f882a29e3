// Poses of the vehicle and the arcs that join them: what turns and routes are made of.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/path.h"

namespace headland {

// Rear-axle centre p_W [m] and direction of the body's x axis.
struct Pose {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
};

// What may be driven: a trailed implement folds up in reverse.
enum class Gears { kBoth, kForwardOnly };

inline Pose pose_of(const PathPoint& point) { return {point.p_W, point.heading_rad}; }

// A piece of constant curvature (0: a line), or one that changes evenly along it (a clothoid),
// driven in one gear. Curvature as in PathPoint: positive with the wheels to the left, so that in
// reverse a positive one turns the body clockwise.
struct Arc {
  double length_m = 0.0;
  double curvature_per_m = 0.0;  // where it begins
  Gear gear = Gear::kForward;
  double sharpness_per_m2 = 0.0;  // by which the curvature changes a metre
};

double end_curvature_per_m(const Arc& arc);

// The angle in [-pi, pi).
double wrap_angle(double angle_rad);

Eigen::Vector2d direction_of(double heading_rad);  // unit vector along the heading
Eigen::Vector2d left_of(double heading_rad);       // unit vector to its left

// The pose after `distance_m` of the arc.
Pose pose_along(const Pose& from, const Arc& arc, double distance_m);
Pose end_of(const Pose& from, const std::vector<Arc>& arcs);

// The same way driven back, from its end to where it began.
std::vector<Arc> driven_back(const std::vector<Arc>& arcs);

// On a line of two points or more, along its first and its last edge.
Pose begin_pose(const std::vector<Eigen::Vector2d>& line_W);
Pose end_pose(const std::vector<Eigen::Vector2d>& line_W);

double length_m(const std::vector<Arc>& arcs);
double reverse_length_m(const std::vector<Arc>& arcs);
int cusp_count(const std::vector<Arc>& arcs);  // changes of gear

// Points at most `spacing_m` apart, evenly within each arc; one segment per gear, all of one
// kind and manoeuvre 0, joined at their ends. At a joint of two arcs the curvature is that of the
// arc that begins there. Empty for no length.
std::vector<PathSegment> sample(const Pose& from, const std::vector<Arc>& arcs, double spacing_m);

}  // namespace headland
