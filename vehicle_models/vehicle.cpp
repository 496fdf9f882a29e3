#include "vehicle_models/vehicle.h"

#include <cmath>

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

double min_turning_radius_m(const Vehicle& vehicle) {
  const Steering& steering = vehicle.steering;
  switch (steering.kind) {
    case SteeringKind::kFront:
      return wheelbase_m(vehicle) / std::tan(steering.max_angle_rad);
    case SteeringKind::kFourWheel:
      return wheelbase_m(vehicle) / (2.0 * std::tan(steering.max_angle_rad));
    case SteeringKind::kSkid:
      return steering.turning_radius_m;
  }
  return 0.0;
}

double planning_turning_radius_m(const Vehicle& vehicle) {
  return kTurningRadiusMargin * min_turning_radius_m(vehicle);
}

double total_mass_kg(const Vehicle& vehicle) {
  return vehicle.body.mass_kg + vehicle.implement.mass_kg;
}

int motor_count(const Vehicle& vehicle) {
  if (!vehicle.drivetrain.motor_per_wheel) return 1;
  return 2 * (static_cast<int>(vehicle.rear.driven) + static_cast<int>(vehicle.front.driven));
}

}  // namespace headland
