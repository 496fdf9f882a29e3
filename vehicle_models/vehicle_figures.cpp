#include "vehicle_models/vehicle_figures.h"

#include <algorithm>
#include <cmath>

#include "vehicle_models/draft.h"

namespace headland {
namespace {

constexpr double kLeadAcidNominal_v = 2.0;
constexpr double kLfpNominal_v = 3.2;
constexpr double kLfpEmpty_v = 2.9;
constexpr double kPeukertRate_h = 20.0;  // lead-acid capacities are given for it

// On the vehicle's wheels; a trailed implement is not.
double mounted_kg(const Vehicle& vehicle) {
  return vehicle.implement.trailing ? 0.0 : vehicle.implement.mass_kg;
}

// Force [N] that rolls the vehicle itself along the flat.
double own_rolling_n(const Vehicle& vehicle, double rolling_resistance) {
  return (kGravity_mps2 * carried_mass_kg(vehicle) + hitch_load_n(vehicle)) * rolling_resistance;
}

double driven_radius_m(const Vehicle& vehicle) {
  return vehicle.rear.driven ? vehicle.rear.radius_m : vehicle.front.radius_m;
}

double motor_input_w(const Motor& motor, double torque_nm, double speed) {
  return torque_nm * speed + motor.copper_loss_kc * torque_nm * torque_nm +
         motor.iron_loss_ki * speed + motor.windage_loss_kw * std::pow(speed, 3) +
         motor.constant_loss_w;
}

}  // namespace

double carried_mass_kg(const Vehicle& vehicle) {
  return vehicle.body.mass_kg + mounted_kg(vehicle);
}

double hitch_load_n(const Vehicle& vehicle) {
  const auto& trailing = vehicle.implement.trailing;
  if (!trailing || trailing->com_ahead_m == 0.0) return 0.0;
  return kGravity_mps2 * vehicle.implement.mass_kg * trailing->com_ahead_m /
         trailing->drawbar_length_m;
}

Eigen::Vector3d total_com_B(const Vehicle& vehicle) {
  const Implement& implement = vehicle.implement;
  const Eigen::Vector3d implement_B(implement.x_B_m, 0.0, implement.com_height_m);
  return (vehicle.body.mass_kg * vehicle.body.com_B + mounted_kg(vehicle) * implement_B) /
         carried_mass_kg(vehicle);
}

double front_load_share(const Vehicle& vehicle) {
  return (total_com_B(vehicle).x() - vehicle.rear.x_B_m) / wheelbase_m(vehicle);
}

AxleLoads static_axle_loads(const Vehicle& vehicle) {
  const double front_share = front_load_share(vehicle);
  const double weight_n = kGravity_mps2 * carried_mass_kg(vehicle);
  AxleLoads loads{(1.0 - front_share) * weight_n, front_share * weight_n};
  if (vehicle.implement.trailing) {
    const double hitch_n = hitch_load_n(vehicle);
    const double hitch_share =
        (vehicle.implement.trailing->hitch_x_B_m - vehicle.rear.x_B_m) / wheelbase_m(vehicle);
    loads.rear_n += (1.0 - hitch_share) * hitch_n;
    loads.front_n += hitch_share * hitch_n;
  }
  return loads;
}

double ahead_of_pivot_m(const Vehicle& vehicle) {
  const AxleLoads loads = static_axle_loads(vehicle);
  return loads.rear_n >= loads.front_n ? -vehicle.rear.x_B_m : -vehicle.front.x_B_m;
}

TyreSize tyre_size(const Axle& axle, double load_n) {
  const double sag_m = load_n / axle.vertical_stiffness_n_per_m;
  return {axle.width_m, 2.0 * (axle.radius_m + sag_m), axle.section_height_m};
}

SoilFigures figures_on(const Vehicle& vehicle, const Soil& soil) {
  const AxleLoads loads = static_axle_loads(vehicle);
  SoilFigures figures;
  double driven_n = 0.0;
  const auto add = [&](const Axle& axle, double axle_load_n) {
    const double load_n = 0.5 * axle_load_n;
    const Traction traction = traction_on(soil, tyre_size(axle, load_n), load_n,
                                          load_n / axle.vertical_stiffness_n_per_m);
    figures.rolling_resistance += axle_load_n * rolling_resistance(traction);
    if (!axle.driven) return;
    figures.net_pull += axle_load_n * best_pull(traction).net_pull;
    driven_n += axle_load_n;
  };
  add(vehicle.rear, loads.rear_n);
  add(vehicle.front, loads.front_n);
  figures.rolling_resistance /= loads.rear_n + loads.front_n;
  if (driven_n > 0.0) figures.net_pull /= driven_n;
  return figures;
}

double side_stability_angle_rad(const Vehicle& vehicle) {
  const Eigen::Vector3d com_B = total_com_B(vehicle);
  const double front_share = front_load_share(vehicle);
  // Half track and height of the tipping line below the centre of mass.
  const auto support = [](const Axle& axle) {
    return axle.oscillation_max_rad > 0.0 ? Eigen::Vector2d(0.0, axle.radius_m)
                                          : Eigen::Vector2d(0.5 * axle.track_m, 0.0);
  };
  const Eigen::Vector2d line =
      (1.0 - front_share) * support(vehicle.rear) + front_share * support(vehicle.front);
  return std::atan2(line.x() - std::abs(com_B.y()), com_B.z() - line.y());
}

double nose_up_stability_angle_rad(const Vehicle& vehicle) {
  const Eigen::Vector3d com_B = total_com_B(vehicle);
  return std::atan2(com_B.x() - vehicle.rear.x_B_m, com_B.z());
}

double nose_down_stability_angle_rad(const Vehicle& vehicle) {
  const Eigen::Vector3d com_B = total_com_B(vehicle);
  return std::atan2(vehicle.front.x_B_m - com_B.x(), com_B.z());
}

double top_speed_mps(const Vehicle& vehicle) {
  return vehicle.motor.max_speed_rad_per_s / vehicle.drivetrain.gear_ratio *
         driven_radius_m(vehicle);
}

double drive_force_n(const Vehicle& vehicle, double speed_mps) {
  if (speed_mps > top_speed_mps(vehicle)) return 0.0;
  const double radius_m = driven_radius_m(vehicle);
  const double efficiency = vehicle.drivetrain.efficiency;
  const int motors = motor_count(vehicle);
  const double by_torque_n =
      motors * vehicle.motor.max_torque_nm * vehicle.drivetrain.gear_ratio * efficiency / radius_m;
  if (speed_mps <= 0.0) return by_torque_n;
  return std::min(by_torque_n, motors * vehicle.motor.max_power_w * efficiency / speed_mps);
}

double max_grade(const Vehicle& vehicle, double rolling_resistance) {
  const double pull = drive_force_n(vehicle, 0.0) / (kGravity_mps2 * total_mass_kg(vehicle));
  // sin a + Crr cos a = pull, solved as one shifted sine.
  const double amplitude = std::hypot(1.0, rolling_resistance);
  const double angle_rad =
      std::asin(std::min(pull / amplitude, 1.0)) - std::atan(rolling_resistance);
  return std::tan(std::max(angle_rad, 0.0));
}

double max_grade_by_grip(const Vehicle& vehicle, double net_pull, double rolling_resistance) {
  const double weight_n = kGravity_mps2 * total_mass_kg(vehicle);
  const AxleLoads loads = static_axle_loads(vehicle);
  const bool rear = vehicle.rear.driven;
  const bool front = vehicle.front.driven;
  const double driven = ((rear ? loads.rear_n : 0.0) + (front ? loads.front_n : 0.0)) / weight_n;
  const double lift =
      total_com_B(vehicle).z() / wheelbase_m(vehicle) * (loads.rear_n + loads.front_n) / weight_n;
  const double shift = (rear ? lift : 0.0) - (front ? lift : 0.0);
  // pull (driven + shift tan a) = tan a + Crr (1 - driven - shift tan a), over the whole weight;
  // a trailed implement's own rolling resistance counts as the vehicle's.
  const double climb = (net_pull * driven - rolling_resistance * (1.0 - driven)) /
                       (1.0 - (net_pull + rolling_resistance) * shift);
  return std::max(0.0, climb);
}

double needed_pull_n(const Vehicle& vehicle, double rolling_resistance, SoilTexture texture,
                     double speed_mps, bool working) {
  double pull_n = 0.0;
  if (const auto& trailing = vehicle.implement.trailing) {
    const double own = trailing->rolling_resistance;
    pull_n = (kGravity_mps2 * vehicle.implement.mass_kg - hitch_load_n(vehicle)) *
             (own > 0.0 ? own : rolling_resistance);
  }
  return working ? pull_n + draft_n(vehicle.implement, texture, speed_mps) : pull_n;
}

HitchPull hitch_pull(const Vehicle& vehicle, const SoilFigures& on_soil, double speed_mps) {
  const AxleLoads loads = static_axle_loads(vehicle);
  const double driven_n =
      (vehicle.rear.driven ? loads.rear_n : 0.0) + (vehicle.front.driven ? loads.front_n : 0.0);
  const double rolling = on_soil.rolling_resistance;
  const double undriven_n = loads.rear_n + loads.front_n - driven_n;
  return {std::max(0.0, drive_force_n(vehicle, speed_mps) - own_rolling_n(vehicle, rolling)),
          std::max(0.0, on_soil.net_pull * driven_n - rolling * undriven_n)};
}

Endurance endurance(const Vehicle& vehicle, double speed_mps, double rolling_resistance,
                    bool working, SoilTexture texture) {
  const Implement& implement = vehicle.implement;
  const Motor& motor = vehicle.motor;
  const Battery& battery = vehicle.battery;
  const double force_n = own_rolling_n(vehicle, rolling_resistance) +
                         needed_pull_n(vehicle, rolling_resistance, texture, speed_mps, working);
  Endurance result;
  if (force_n > drive_force_n(vehicle, speed_mps)) return result;
  const int motors = motor_count(vehicle);
  const double speed = speed_mps / driven_radius_m(vehicle) * vehicle.drivetrain.gear_ratio;
  const double torque_nm = force_n * speed_mps / (motors * vehicle.drivetrain.efficiency * speed);
  result.power_w = motors * motor_input_w(motor, torque_nm, speed) / motor.inverter_efficiency +
                   battery.auxiliary_power_w +
                   (working ? shaft_power_w(implement) / implement.shaft_efficiency : 0.0);
  const double emf_v = nominal_voltage_v(battery);
  const double resistance_ohm = battery.resistance_ohm + battery.polarisation_resistance_ohm;
  const double root = emf_v * emf_v - 4.0 * resistance_ohm * result.power_w;
  if (root < 0.0) return result;
  double current_a = (emf_v - std::sqrt(root)) / (2.0 * resistance_ohm);
  const double rated_a = battery.capacity_ah / kPeukertRate_h;
  if (battery.chemistry == Chemistry::kLeadAcid && current_a > rated_a) {
    current_a *= std::pow(current_a / rated_a, battery.peukert - 1.0);
  }
  result.time_h = battery.capacity_ah * (1.0 - battery.empty_soc) / current_a;
  result.distance_m = 3600.0 * result.time_h * speed_mps;
  return result;
}

double motor_peak_input_w(const Motor& motor) {
  const double speed = std::min(motor.max_power_w / motor.max_torque_nm, motor.max_speed_rad_per_s);
  return motor_input_w(motor, motor.max_torque_nm, speed);
}

double drive_peak_input_w(const Vehicle& vehicle) {
  return motor_count(vehicle) * motor_peak_input_w(vehicle.motor) /
         vehicle.motor.inverter_efficiency;
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
