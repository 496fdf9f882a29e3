// A transplanter without losses of its own.
#pragma once

#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {

// Losses of the machine itself switched off: what is left are the textbook's terms.
inline Vehicle textbook_vehicle() {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.motor.copper_loss_kc = vehicle.motor.iron_loss_ki = 0.0;
  vehicle.motor.windage_loss_kw = vehicle.motor.constant_loss_w = 0.0;
  vehicle.battery.auxiliary_power_w = 0.0;
  vehicle.drivetrain.efficiency = 0.8;
  vehicle.implement.mass_kg = 0.0;
  vehicle.body.com_B.x() = 0.5 * wheelbase_m(vehicle);
  const double wheelbase = vehicle.front.x_B_m;
  vehicle.front = vehicle.rear;
  vehicle.front.x_B_m = wheelbase;
  vehicle.front.driven = true;
  return vehicle;
}

}  // namespace headland::bench
