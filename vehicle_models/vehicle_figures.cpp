#include "vehicle_models/vehicle_figures.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

constexpr double kLeadAcidNominal_v = 2.0;
constexpr double kLfpNominal_v = 3.2;
constexpr double kLfpEmpty_v = 2.9;

double driven_radius_m(const Vehicle& vehicle) {
  return vehicle.rear.driven ? vehicle.rear.radius_m : vehicle.front.radius_m;
}

}  // namespace

AxleLoads static_axle_loads(const Vehicle& vehicle) {
  const double moment_kg_m = vehicle.body.mass_kg * vehicle.body.com_B.x() +
                             vehicle.implement.mass_kg * vehicle.implement.x_B_m;
  const double front_kg = moment_kg_m / wheelbase_m(vehicle);
  return {kGravity_mps2 * (total_mass_kg(vehicle) - front_kg), kGravity_mps2 * front_kg};
}

double side_stability_angle_rad(const Vehicle& vehicle) {
  const double track_m = std::max(vehicle.rear.track_m, vehicle.front.track_m);
  return std::atan(track_m / (2.0 * vehicle.body.com_B.z()));
}

double nose_up_stability_angle_rad(const Vehicle& vehicle) {
  const AxleLoads loads = static_axle_loads(vehicle);
  const double ahead_m = wheelbase_m(vehicle) * loads.front_n / (loads.rear_n + loads.front_n);
  return std::atan(ahead_m / vehicle.body.com_B.z());
}

double top_speed_mps(const Vehicle& vehicle) {
  return vehicle.motor.max_speed_rad_per_s / vehicle.drivetrain.gear_ratio *
         driven_radius_m(vehicle);
}

double drive_force_n(const Vehicle& vehicle, double speed_mps) {
  if (speed_mps > top_speed_mps(vehicle)) return 0.0;
  const double radius_m = driven_radius_m(vehicle);
  const double efficiency = vehicle.drivetrain.efficiency;
  const double by_torque_n =
      vehicle.motor.max_torque_nm * vehicle.drivetrain.gear_ratio * efficiency / radius_m;
  if (speed_mps <= 0.0) return by_torque_n;
  return std::min(by_torque_n, vehicle.motor.max_power_w * efficiency / speed_mps);
}

double max_grade(const Vehicle& vehicle, double rolling_resistance) {
  const double pull = drive_force_n(vehicle, 0.0) / (kGravity_mps2 * total_mass_kg(vehicle));
  // sin a + Crr cos a = pull, solved as one shifted sine.
  const double amplitude = std::hypot(1.0, rolling_resistance);
  const double angle_rad =
      std::asin(std::min(pull / amplitude, 1.0)) - std::atan(rolling_resistance);
  return std::tan(std::max(angle_rad, 0.0));
}

double motor_peak_input_w(const Motor& motor) {
  const double speed = std::min(motor.max_power_w / motor.max_torque_nm, motor.max_speed_rad_per_s);
  return motor.max_torque_nm * speed +
         motor.copper_loss_kc * motor.max_torque_nm * motor.max_torque_nm +
         motor.iron_loss_ki * speed + motor.windage_loss_kw * std::pow(speed, 3) +
         motor.constant_loss_w;
}

double nominal_voltage_v(const Battery& battery) {
  const double cell_v =
      battery.chemistry == Chemistry::kLeadAcid ? kLeadAcidNominal_v : kLfpNominal_v;
  return battery.cells_in_series * cell_v;
}

double nominal_energy_wh(const Battery& battery) {
  return nominal_voltage_v(battery) * battery.capacity_ah;
}

double max_battery_power_w(const Battery& battery) {
  const double cell_v =
      battery.chemistry == Chemistry::kLeadAcid ? kLeadAcidNominal_v : kLfpEmpty_v;
  const double emf_v = battery.cells_in_series * cell_v;
  return emf_v * emf_v / (4.0 * (battery.resistance_ohm + battery.polarisation_resistance_ohm));
}

}  // namespace headland
