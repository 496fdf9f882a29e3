// A vehicle with round figures for the planner's tests.
#pragma once

#include <cmath>

#include "vehicle_models/vehicle.h"

namespace headland {

// Small electric machine: 1.9 m wheelbase, hull 3.0 x 1.4 m with 0.6 m behind the rear axle,
// implement `working_width_m` wide and 0.8 m behind the axle, planning radius as given.
inline Vehicle made_up_vehicle(double radius_m, double working_width_m) {
  Vehicle vehicle;
  vehicle.name = "made-up";
  vehicle.body.length_m = 3.0;
  vehicle.body.width_m = 1.4;
  vehicle.body.rear_overhang_m = 0.6;
  vehicle.front.x_B_m = 1.9;
  vehicle.steering.max_angle_rad = std::atan(1.9 / (radius_m / kTurningRadiusMargin));
  vehicle.implement.x_B_m = -0.8;
  vehicle.implement.working_width_m = working_width_m;
  return vehicle;
}

}  // namespace headland
