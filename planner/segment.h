// Vectors and line segments of the plane.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace headland {

// z of the cross product: positive where b is to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// From p to the segment ab, which may be a point.
inline double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

// Direction of a line along `vector`, 0 to pi without pi.
inline double line_direction_rad(const Eigen::Vector2d& vector) {
  const double angle_rad = std::atan2(vector.y(), vector.x());
  const double folded_rad = angle_rad < 0.0 ? angle_rad + std::numbers::pi : angle_rad;
  return folded_rad >= std::numbers::pi ? 0.0 : folded_rad;
}

}  // namespace headland
