// A vehicle as data: body, wheels, steering, drivetrain, motor, battery, implement, driver.
//
// Body frame B: origin on flat ground below the point that travels where the vehicle heads and
// that follows paths: the rear-axle centre with front steering, the middle between the axles with
// four-wheel and skid steering. x forward, y left, z up. Every number comes from the vehicle's
// folder (vehicle.urdf and drive.yaml), where it stands with its source or the word 'assumed'; the
// key tells the unit. Loader: vehicle_loader.h.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "vehicle_models/implement.h"
#include "vehicle_models/powertrain.h"
#include "vehicle_models/shape.h"

namespace headland {

struct Body {
  double mass_kg = 0.0;                                     // whole machine without implement
  Eigen::Vector3d com_B = Eigen::Vector3d::Zero();          // m
  Eigen::Vector3d inertia_kg_m2 = Eigen::Vector3d::Zero();  // about com, along B's axes
  double length_m = 0.0;                                    // hull box, for collisions
  double width_m = 0.0;
  double height_m = 0.0;
  double rear_overhang_m = 0.0;  // hull box reaches this far behind B's origin
  double ground_clearance_m = 0.0;
};

struct Axle {
  double x_B_m = 0.0;
  double track_m = 0.0;   // between wheel centres
  double radius_m = 0.0;  // loaded rolling radius at static load
  double width_m = 0.0;
  double wheel_inertia_kg_m2 = 0.0;  // one wheel about its axis, with its share of the drivetrain
  double vertical_stiffness_n_per_m = 0.0;  // one tyre
  double vertical_damping_n_s_per_m = 0.0;
  double section_height_m = 0.0;  // of the tyre, rim to tread
  bool driven = false;
  double oscillation_max_rad = 0.0;  // free roll of a pivoted axle to either side; 0: rigid
};

enum class SteeringKind {
  kFront,      // Ackermann, front wheels
  kFourWheel,  // front and rear wheels turn by equal angles to opposite sides
  kSkid,       // no steered wheels: the sides turn at different speeds, also on the spot
};

// As in a drive.yaml: "front", "four_wheel" or "skid".
std::string_view steering_word(SteeringKind kind);

struct Steering {
  SteeringKind kind = SteeringKind::kFront;
  double max_angle_rad = 0.0;  // of the virtual front wheel on the centre line; not for skid
  double max_rate_rad_per_s = 0.0;
  double max_yaw_rate_rad_per_s = 0.0;  // skid: on the spot
  double turning_radius_m = 0.0;        // skid: tightest arc of B's origin
  double actuator_power_w = 0.0;        // mechanical, while the wheels turn at max_rate
  double actuator_efficiency = 1.0;     // electrical to mechanical
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
  std::vector<Shape> shapes;       // the body without wheels as it is drawn, in B; none: its hull
  std::vector<std::string> notes;  // what was read with a reservation, for people
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

// Curvature [1/m] of the circle that B's origin is steered on at a steering angle, and back
// (single-track model).
double curvature_of(const Vehicle& vehicle, double steer_rad);
double steer_for(const Vehicle& vehicle, double curvature_per_m);

// Angle [rad] of a steered wheel whose hub is at `p_B` when B's origin turns on a circle of that
// curvature: square to the line from the circle's centre (Ackermann). 0 on the axle with x_B_m 0.
double wheel_angle_rad(double curvature_per_m, const Eigen::Vector2d& p_B);

// Likewise for a steering angle of the vehicle; 0 for skid steering, whose wheels do not turn.
double wheel_angle_rad(const Vehicle& vehicle, double steer_rad, const Eigen::Vector2d& p_B);

// Radius [m] of the tightest circle of B's origin: by the largest steering angle (single-track
// model), or as given for skid steering.
double min_turning_radius_m(const Vehicle& vehicle);

// Radius [m] that plans are made with: the tightest circle with the margin that keeps steering
// authority for tracking (kTurningRadiusMargin).
inline constexpr double kTurningRadiusMargin = 1.15;
double planning_turning_radius_m(const Vehicle& vehicle);

// Hitch angle [rad]: yaw of a trailed implement less the vehicle's, on a steady circle of B's
// origin of that curvature, tyres without slip; negative on a left one. The pin runs on the radius
// hypot(R, hitch_x_B), the implement's axle on sqrt(R^2 + hitch_x_B^2 - drawbar^2). +-pi where
// there is no such circle and the implement jackknifes.
double steady_hitch_angle_rad(const Trailing& trailing, double curvature_per_m);

// Mass with implement [kg].
double total_mass_kg(const Vehicle& vehicle);

// Motors that drive it: one, or one at each wheel of the driven axles.
int motor_count(const Vehicle& vehicle);

}  // namespace headland
