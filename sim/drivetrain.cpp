#include "sim/drivetrain.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// Largest torque in the direction of rotation whose input power is at most `available_w`.
double torque_for_power(const Motor& motor, double speed_rad_per_s, double available_w) {
  const double speed = std::abs(speed_rad_per_s);
  const double spare_w = available_w - motor_loss_w(motor, 0.0, speed);
  if (spare_w <= 0.0) return 0.0;
  const double kc = motor.copper_loss_kc;
  // kc T^2 + w T = spare, in the form that holds for kc = 0 and for w = 0.
  const double root = speed + std::sqrt(speed * speed + 4.0 * kc * spare_w);
  return root > 0.0 ? 2.0 * spare_w / root : motor.max_torque_nm;
}

}  // namespace

double motor_loss_w(const Motor& motor, double torque_nm, double speed_rad_per_s) {
  const double speed = std::abs(speed_rad_per_s);
  return motor.copper_loss_kc * torque_nm * torque_nm + motor.iron_loss_ki * speed +
         motor.windage_loss_kw * speed * speed * speed + motor.constant_loss_w;
}

MotorTorque limit_motor(const Motor& motor, double wanted_nm, double speed_rad_per_s,
                        double available_w, double acceptable_w) {
  const double speed = std::abs(speed_rad_per_s);
  double limit_nm = motor.max_torque_nm;
  if (speed * limit_nm > motor.max_power_w) limit_nm = motor.max_power_w / speed;
  const bool motoring = wanted_nm * speed_rad_per_s >= 0.0;
  if (motoring) {
    if (speed > motor.max_speed_rad_per_s) limit_nm = 0.0;
    limit_nm = std::min(limit_nm, torque_for_power(motor, speed, available_w));
  } else {
    // Shaft power w T comes in, less the losses; bounding the shaft power bounds what is charged.
    limit_nm = std::min(limit_nm, acceptable_w / speed);
  }
  const double torque_nm = std::clamp(wanted_nm, -limit_nm, limit_nm);
  return {torque_nm, torque_nm != wanted_nm};
}

DrivetrainCommand command_drive(const Vehicle& vehicle, const PerWheel<WheelDefinition>& wheels,
                                const PerWheel<WheelContact>& contacts, double wanted_nm,
                                double motor_speed_rad_per_s, double speed_mps, double available_w,
                                double acceptable_w, bool hold) {
  const Drivetrain& drivetrain = vehicle.drivetrain;
  DrivetrainCommand command;
  double brake_nm = hold ? drivetrain.brake_torque_max_nm : 0.0;
  if (!hold) {
    const bool braking = wanted_nm * speed_mps < 0.0;
    double to_motor_nm = wanted_nm;
    if (braking) {
      const bool regenerates = std::abs(speed_mps) >= vehicle.motor.regeneration_min_speed_mps;
      to_motor_nm *= regenerates ? vehicle.motor.regeneration_fraction : 0.0;
    }
    const double through_gear = to_motor_nm * motor_speed_rad_per_s >= 0.0
                                    ? drivetrain.efficiency
                                    : 1.0 / drivetrain.efficiency;
    const MotorTorque motor =
        limit_motor(vehicle.motor, to_motor_nm / (drivetrain.gear_ratio * through_gear),
                    motor_speed_rad_per_s, available_w, acceptable_w);
    command.motor_nm = motor.torque_nm;
    const double driven_nm = motor.torque_nm * drivetrain.gear_ratio * through_gear;
    if (braking) {
      brake_nm = std::min(std::abs(wanted_nm - driven_nm), drivetrain.brake_torque_max_nm);
    } else {
      command.clipped = motor.clipped;
    }
    const auto driven_wheels = std::count_if(
        wheels.begin(), wheels.end(), [](const WheelDefinition& wheel) { return wheel.driven; });
    for (std::size_t i = 0; i < kWheels; ++i) {
      if (wheels[i].driven) {
        command.wheels[i].drive_nm = driven_nm / static_cast<double>(driven_wheels);
      }
    }
  }
  double load_n = 0.0;
  for (const WheelContact& contact : contacts) load_n += contact.load_n;
  for (std::size_t i = 0; i < kWheels; ++i) {
    command.wheels[i].brake_max_nm =
        load_n > 0.0 ? brake_nm * contacts[i].load_n / load_n : brake_nm / kWheels;
  }
  return command;
}

}  // namespace headland
