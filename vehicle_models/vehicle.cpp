#include "vehicle_models/vehicle.h"

#include <cmath>

namespace headland {

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

}  // namespace headland
