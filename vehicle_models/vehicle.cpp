#include "vehicle_models/vehicle.h"

#include <cmath>

namespace headland {

double min_turning_radius_m(const Vehicle& vehicle) {
  return wheelbase_m(vehicle) / std::tan(vehicle.steering.max_angle_rad);
}

double planning_turning_radius_m(const Vehicle& vehicle) {
  return kTurningRadiusMargin * min_turning_radius_m(vehicle);
}

double total_mass_kg(const Vehicle& vehicle) {
  return vehicle.body.mass_kg + vehicle.implement.mass_kg;
}

}  // namespace headland
