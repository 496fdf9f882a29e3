#include "vehicle_models/vehicle.h"

#include <cmath>
#include <numbers>

namespace headland {

std::string_view steering_word(SteeringKind kind) {
  switch (kind) {
    case SteeringKind::kFront:
      return "front";
    case SteeringKind::kFourWheel:
      return "four_wheel";
    case SteeringKind::kSkid:
      return "skid";
  }
  return "";
}

double curvature_of(const Vehicle& vehicle, double steer_rad) {
  return std::tan(steer_rad) / vehicle.front.x_B_m;
}

double steer_for(const Vehicle& vehicle, double curvature_per_m) {
  return std::atan(vehicle.front.x_B_m * curvature_per_m);
}

double wheel_angle_rad(double curvature_per_m, const Eigen::Vector2d& p_B) {
  return std::atan2(p_B.x() * curvature_per_m, 1.0 - p_B.y() * curvature_per_m);
}

double wheel_angle_rad(const Vehicle& vehicle, double steer_rad, const Eigen::Vector2d& p_B) {
  if (vehicle.steering.kind == SteeringKind::kSkid) return 0.0;
  return wheel_angle_rad(curvature_of(vehicle, steer_rad), p_B);
}

double min_turning_radius_m(const Vehicle& vehicle) {
  if (vehicle.steering.kind == SteeringKind::kSkid) return vehicle.steering.turning_radius_m;
  return 1.0 / curvature_of(vehicle, vehicle.steering.max_angle_rad);
}

double planning_turning_radius_m(const Vehicle& vehicle) {
  return kTurningRadiusMargin * min_turning_radius_m(vehicle);
}

double steady_hitch_angle_rad(const Trailing& trailing, double curvature_per_m) {
  if (curvature_per_m == 0.0) return 0.0;
  const double radius_m = 1.0 / std::abs(curvature_per_m);
  const double pin_m = std::hypot(radius_m, trailing.hitch_x_B_m);
  const double length_m = trailing.drawbar_length_m;
  if (length_m >= pin_m) return std::copysign(std::numbers::pi, -curvature_per_m);
  const double angle_rad = std::asin(length_m / pin_m) - std::atan(trailing.hitch_x_B_m / radius_m);
  return std::copysign(angle_rad, -curvature_per_m);
}

double total_mass_kg(const Vehicle& vehicle) {
  return vehicle.body.mass_kg + vehicle.implement.mass_kg;
}

int motor_count(const Vehicle& vehicle) {
  if (!vehicle.drivetrain.motor_per_wheel) return 1;
  return 2 * (static_cast<int>(vehicle.rear.driven) + static_cast<int>(vehicle.front.driven));
}

}  // namespace headland
