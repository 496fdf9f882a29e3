// Finds the wheels of a robot description, what steers them and which axle pivots.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "vehicle_models/robot_file.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct Wheel {
  int link = 0;
  std::string joint;
  Eigen::Vector3d centre_R = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
  double width_m = 0.0;
  double inertia_kg_m2 = 0.0;       // about its axle
  std::optional<double> left_rad;   // largest steering angles; none: not steered
  std::optional<double> right_rad;  // both > 0
  std::optional<double> pivot_rad;  // largest roll of the axle that carries it
};

struct RunningGear {
  std::array<Wheel, 4> wheels;  // rear left, rear right, front left, front right
  SteeringKind steering = SteeringKind::kFront;
  double max_angle_rad = 0.0;  // of the virtual wheel on the centre line; 0 for skid
  Eigen::Vector3d origin_R = Eigen::Vector3d::Zero();  // of frame B, whose axes are those of R
  std::vector<std::string> notes;                      // joints that are held still
};

// A wheel is what a continuous joint carries, and needs a cylinder or a sphere, best as its
// <collision>. There must be four, in two axles, turning about y with all joints at zero, on one
// level. Between root and wheel, a revolute joint about z steers, one about x is an axle's pivot;
// all others are held still and told in the notes. The steering angle of the virtual wheel is the
// largest at which no wheel passes its limit (Ackermann). Throws InputError.
RunningGear find_running_gear(const Robot& robot);

}  // namespace headland
