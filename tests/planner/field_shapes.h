// Fields and machines that the planner's tests share.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "planner/plan.h"
#include "terrains/field.h"

namespace headland {

inline constexpr double kPi = std::numbers::pi;

Ring rectangle_ring(double x0, double y0, double x1, double y1);
Ring reversed(Ring ring);

// Regular polygon, counter-clockwise.
Ring regular_ring(const Eigen::Vector2d& centre_W, double radius_m, int corners);

Field field_of(const std::string& name, Ring boundary);

// Square, rotated rectangle, L, triangle, one and two holes, trees, a thin strip, a neck.
std::vector<Field> field_shapes();

// The field turned about the origin, then shifted.
Field moved(const Field& field, double angle_rad, const Eigen::Vector2d& shift);

// Requests with every parameter of `planner` at its default: a tractor with a 9 m implement, which
// turns within its width, and a 2 m machine that does not.
PlanRequest tractor_request(const Field& field, const std::string& planner);
PlanRequest transplanter_request(const Field& field, const std::string& planner);

}  // namespace headland
