// Motor, reduction gear and brakes.
#pragma once

#include "sim/tyre.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Torque that the motor gives for a request, and whether a limit cut it.
struct MotorTorque {
  double torque_nm = 0.0;
  bool clipped = false;
};

// Losses [W] of motor and inverter: kc T^2 + ki |w| + kw |w|^3 + C (Larminie and Lowry), >= 0.
double motor_loss_w(const Motor& motor, double torque_nm, double speed_rad_per_s);

// Limits by torque, power and speed, and by the electrical power that the battery can give
// (`available_w`) or take (`acceptable_w`), both >= 0.
MotorTorque limit_motor(const Motor& motor, double wanted_nm, double speed_rad_per_s,
                        double available_w, double acceptable_w);

// What one step asks of the wheels.
struct DrivetrainCommand {
  double motor_nm = 0.0;  // on the motor shaft, forward positive
  PerWheel<WheelTorques> wheels;
  bool clipped = false;
};

// Splits a wanted wheel torque (all driven wheels together) into motor and friction brake. Open
// differentials: every driven wheel gets the same torque. Braking goes to the motor up to its
// regeneration fraction above the least speed for it, the rest to the brakes of all wheels in
// proportion to their load. `hold` sets the brakes fully.
DrivetrainCommand command_drive(const Vehicle& vehicle, const PerWheel<WheelDefinition>& wheels,
                                const PerWheel<WheelContact>& contacts, double wanted_nm,
                                double motor_speed_rad_per_s, double speed_mps, double available_w,
                                double acceptable_w, bool hold);

}  // namespace headland
