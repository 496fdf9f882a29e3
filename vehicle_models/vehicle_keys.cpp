#include "vehicle_models/vehicle_keys.h"

#include <numbers>

namespace headland {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

VehicleKey number(std::string_view key, double& target, double min, double max,
                  double scale = 1.0) {
  return {.key = key, .min = min, .max = max, .number = &target, .scale = scale};
}

VehicleKey integer(std::string_view key, int& target, double min, double max) {
  return {.key = key, .min = min, .max = max, .integer = &target};
}

VehicleKey vector(std::string_view key, Eigen::Vector3d& target, double min, double max) {
  return {.key = key, .min = min, .max = max, .vector = &target};
}

std::vector<VehicleKey> axle_keys(Axle& axle, double min_x_m, double max_x_m) {
  return {number("x_B_m", axle.x_B_m, min_x_m, max_x_m),
          number("track_m", axle.track_m, 0.2, 6.0),
          number("radius_m", axle.radius_m, 0.05, 2.0),
          number("width_m", axle.width_m, 0.01, 2.0),
          number("wheel_inertia_kg_m2", axle.wheel_inertia_kg_m2, 1e-4, 1e4),
          number("vertical_stiffness_n_per_m", axle.vertical_stiffness_n_per_m, 1e3, 1e8),
          number("vertical_damping_n_s_per_m", axle.vertical_damping_n_s_per_m, 0.0, 1e6),
          {.key = "driven", .flag = &axle.driven}};
}

}  // namespace

std::vector<VehicleSection> sections_of(Vehicle& v) {
  return {
      {"body",
       {number("mass_kg", v.body.mass_kg, 10.0, 60000.0), vector("com_B", v.body.com_B, -5.0, 10.0),
        vector("inertia_kg_m2", v.body.inertia_kg_m2, 1e-3, 1e6),
        number("length_m", v.body.length_m, 0.3, 20.0),
        number("width_m", v.body.width_m, 0.2, 10.0), number("height_m", v.body.height_m, 0.1, 6.0),
        number("rear_overhang_m", v.body.rear_overhang_m, 0.0, 10.0),
        number("ground_clearance_m", v.body.ground_clearance_m, 0.02, 3.0)}},
      {"rear", axle_keys(v.rear, 0.0, 0.0)},
      {"front", axle_keys(v.front, 0.3, 10.0)},
      {"steering",
       {number("max_angle_deg", v.steering.max_angle_rad, 1.0, 80.0, kDegree),
        number("max_rate_deg_per_s", v.steering.max_rate_rad_per_s, 1.0, 360.0, kDegree)}},
      {"drivetrain",
       {number("gear_ratio", v.drivetrain.gear_ratio, 0.1, 1000.0),
        number("efficiency", v.drivetrain.efficiency, 0.1, 1.0),
        number("brake_torque_max_nm", v.drivetrain.brake_torque_max_nm, 1.0, 1e6)}},
      {"motor",
       {number("max_torque_nm", v.motor.max_torque_nm, 0.1, 1e5),
        number("max_power_w", v.motor.max_power_w, 10.0, 1e6),
        number("max_speed_rad_per_s", v.motor.max_speed_rad_per_s, 1.0, 5000.0),
        number("copper_loss_kc", v.motor.copper_loss_kc, 0.0, 1000.0),
        number("iron_loss_ki", v.motor.iron_loss_ki, 0.0, 1000.0),
        number("windage_loss_kw", v.motor.windage_loss_kw, 0.0, 1.0),
        number("constant_loss_w", v.motor.constant_loss_w, 0.0, 1e5),
        number("regeneration_fraction", v.motor.regeneration_fraction, 0.0, 1.0),
        number("regeneration_min_speed_mps", v.motor.regeneration_min_speed_mps, 0.0, 10.0)}},
      {"battery",
       {{.key = "chemistry", .chemistry = &v.battery.chemistry},
        integer("cells_in_series", v.battery.cells_in_series, 1.0, 1000.0),
        number("capacity_ah", v.battery.capacity_ah, 0.1, 10000.0),
        number("resistance_ohm", v.battery.resistance_ohm, 1e-5, 10.0),
        number("polarisation_resistance_ohm", v.battery.polarisation_resistance_ohm, 0.0, 10.0),
        number("polarisation_time_constant_s", v.battery.polarisation_time_constant_s, 0.1, 1e5),
        number("max_charge_c_rate", v.battery.max_charge_c_rate, 0.0, 20.0),
        number("peukert", v.battery.peukert, 1.0, 1.6),
        number("empty_soc", v.battery.empty_soc, 0.0, 0.9),
        number("auxiliary_power_w", v.battery.auxiliary_power_w, 0.0, 1e5)}},
      {"implement",
       {{.key = "name", .text = &v.implement.name},
        number("mass_kg", v.implement.mass_kg, 0.0, 20000.0),
        number("x_B_m", v.implement.x_B_m, -10.0, 10.0),
        number("working_width_m", v.implement.working_width_m, 0.05, 100.0),
        number("draft_n_per_m", v.implement.draft_n_per_m, 0.0, 1e5),
        number("draft_height_m", v.implement.draft_height_m, -1.0, 2.0),
        number("shaft_power_w", v.implement.shaft_power_w, 0.0, 1e6),
        number("lift_time_s", v.implement.lift_time_s, 0.0, 60.0),
        number("lift_energy_j", v.implement.lift_energy_j, 0.0, 1e6)}},
      {"driver",
       {number("work_speed_mps", v.driver.work_speed_mps, 0.05, 15.0),
        number("turn_speed_mps", v.driver.turn_speed_mps, 0.05, 15.0),
        number("transit_speed_mps", v.driver.transit_speed_mps, 0.05, 15.0),
        number("reverse_speed_mps", v.driver.reverse_speed_mps, 0.05, 15.0),
        number("max_acceleration_mps2", v.driver.max_acceleration_mps2, 0.05, 5.0),
        number("max_lateral_acceleration_mps2", v.driver.max_lateral_acceleration_mps2, 0.05, 5.0),
        number("look_ahead_m", v.driver.look_ahead_m, 0.1, 50.0),
        number("look_ahead_time_s", v.driver.look_ahead_time_s, 0.0, 10.0)}},
  };
}

}  // namespace headland
