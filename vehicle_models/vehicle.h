// A vehicle as data: body, wheels, steering, drivetrain, motor, battery, implement, driver.
//
// Body frame B: origin on the ground below the rear-axle centre on flat ground, x forward, y left,
// z up. Every number is read from vehicle_models/NAME/vehicle.yaml under the same key, where it
// stands with its source or the word 'assumed'; the key tells the unit. Loader: vehicle_loader.h.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>

namespace headland {

struct Body {
  double mass_kg = 0.0;                                     // whole machine without implement
  Eigen::Vector3d com_B = Eigen::Vector3d::Zero();          // m
  Eigen::Vector3d inertia_kg_m2 = Eigen::Vector3d::Zero();  // about com, along B's axes
  double length_m = 0.0;                                    // hull box, for collisions
  double width_m = 0.0;
  double height_m = 0.0;
  double rear_overhang_m = 0.0;  // hull box reaches this far behind the rear axle
  double ground_clearance_m = 0.0;
};

struct Axle {
  double x_B_m = 0.0;     // 0 for the rear axle, wheelbase for the front
  double track_m = 0.0;   // between wheel centres
  double radius_m = 0.0;  // loaded rolling radius at static load
  double width_m = 0.0;
  double wheel_inertia_kg_m2 = 0.0;  // one wheel about its axis, with its share of the drivetrain
  double vertical_stiffness_n_per_m = 0.0;  // one tyre
  double vertical_damping_n_s_per_m = 0.0;
  bool driven = false;
  double oscillation_max_rad = 0.0;  // free roll of a pivoted axle to either side; 0: rigid
};

struct Steering {
  double max_angle_rad = 0.0;  // of the virtual front wheel on the centre line
  double max_rate_rad_per_s = 0.0;
};

// Motor by the loss model of Larminie and Lowry: P_in = T w + kc T^2 + ki w + kw w^3 + C.
struct Motor {
  double max_torque_nm = 0.0;
  double max_power_w = 0.0;
  double max_speed_rad_per_s = 0.0;
  double copper_loss_kc = 0.0;
  double iron_loss_ki = 0.0;
  double windage_loss_kw = 0.0;
  double constant_loss_w = 0.0;
  double regeneration_fraction = 0.0;  // of the braking power that the motor takes, 0..1
  double regeneration_min_speed_mps = 0.5;
};

struct Drivetrain {
  double gear_ratio = 1.0;           // motor speed / wheel speed
  double efficiency = 1.0;           // motor shaft to wheel hubs
  double brake_torque_max_nm = 0.0;  // all wheels together
};

enum class Chemistry { kLeadAcid, kLfp };

struct Battery {
  Chemistry chemistry = Chemistry::kLfp;
  int cells_in_series = 16;
  double capacity_ah = 100.0;
  double resistance_ohm = 0.01;              // R0 of the pack
  double polarisation_resistance_ohm = 0.0;  // R1 of the pack
  double polarisation_time_constant_s = 30.0;
  double max_charge_c_rate = 0.5;
  double peukert = 1.0;
  double empty_soc = 0.05;  // the run ends with kBatteryEmpty below this
  double auxiliary_power_w = 0.0;
};

// Mounted implement, a bar across the vehicle at x_B_m (negative: behind the rear axle).
struct Implement {
  std::string name;
  double mass_kg = 0.0;
  double x_B_m = 0.0;  // of the working line
  double working_width_m = 0.0;
  double draft_n_per_m = 0.0;   // per metre of width, at any speed
  double draft_height_m = 0.3;  // height of the draft force's line of action
  double shaft_power_w = 0.0;   // while down
  double lift_time_s = 2.0;
  double lift_energy_j = 0.0;  // per raise
};

struct Driver {
  double work_speed_mps = 1.0;
  double turn_speed_mps = 0.6;
  double transit_speed_mps = 1.0;
  double reverse_speed_mps = 0.5;
  double max_acceleration_mps2 = 0.5;
  double max_lateral_acceleration_mps2 = 0.8;
  double look_ahead_m = 1.5;       // at standstill
  double look_ahead_time_s = 0.5;  // times speed is added
};

struct Vehicle {
  std::string name;
  std::string description;
  std::filesystem::path folder;
  std::filesystem::path mesh_file;  // body without wheels, frame B, metres; see render/
  Body body;
  Axle rear;
  Axle front;
  Steering steering;
  Drivetrain drivetrain;
  Motor motor;
  Battery battery;
  Implement implement;
  Driver driver;
};

inline double wheelbase_m(const Vehicle& vehicle) {
  return vehicle.front.x_B_m - vehicle.rear.x_B_m;
}

// Radius [m] of the rear-axle centre's tightest circle (single-track model).
double min_turning_radius_m(const Vehicle& vehicle);

// Radius [m] that plans are made with: the tightest circle with the margin that keeps steering
// authority for tracking (kTurningRadiusMargin).
inline constexpr double kTurningRadiusMargin = 1.15;
double planning_turning_radius_m(const Vehicle& vehicle);

// Mass with implement [kg].
double total_mass_kg(const Vehicle& vehicle);

}  // namespace headland
