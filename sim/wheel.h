// Wheels: where they stand on the terrain and what carries them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "sim/chassis.h"
#include "terrains/heightfield.h"
#include "terrains/traction.h"
#include "vehicle_models/vehicle.h"

namespace headland {

inline constexpr int kWheels = 4;  // rear left, rear right, front left, front right

// What a body with fewer wheels has in it beyond them stays as it is constructed. Functions take a
// span of the body's own wheels.
template <typename T>
using PerWheel = std::array<T, kWheels>;

// What never changes in a run. Frame B with its origin moved to the centre of mass (C).
struct WheelDefinition {
  Eigen::Vector3d hub_C = Eigen::Vector3d::Zero();
  double radius_m = 0.0;       // rolling radius: lever of the tyre force
  double free_radius_m = 0.0;  // unloaded: radius plus the static deflection
  TyreSize tyre;
  double inertia_kg_m2 = 0.0;
  double stiffness_n_per_m = 0.0;
  double damping_n_s_per_m = 0.0;
  bool driven = false;
  bool steered = false;
  Eigen::Vector2d p_B = Eigen::Vector2d::Zero();  // hub seen from above
  int partner = 0;                                // the other wheel of the axle
  double oscillation_max_rad = 0.0;               // of the axle; 0: rigid
  double rolling_resistance = 0.0;                // of load, whatever the soil; 0: the soil's
};

PerWheel<WheelDefinition> define_wheels(const Vehicle& vehicle, const ChassisMass& mass);

struct WheelState {
  double spin_rad_per_s = 0.0;  // absolute, about the axle, forward rolling positive
  double angle_rad = 0.0;
  double bristle_x_m = 0.0;  // deflection of the tyre along and across the wheel
  double bristle_y_m = 0.0;
  // Of the last step, as in TyreResult: where the next one starts to look for its own.
  double along_n = 0.0;
  double across_n = 0.0;
  double soil_n = 0.0;
  double coulomb_nm = 0.0;  // brake and rolling together
};

// A wheel's contact in one step. Vectors in W, offsets from the centre of mass.
struct WheelContact {
  Eigen::Vector3d normal_arm = Eigen::Vector3d::Zero();   // where the normal force acts
  Eigen::Vector3d hub_arm = Eigen::Vector3d::Zero();      // where the longitudinal force acts
  Eigen::Vector3d lateral_arm = Eigen::Vector3d::Zero();  // where the lateral force acts
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();       // in the ground plane, wheel's heading
  Eigen::Vector3d across = Eigen::Vector3d::UnitY();      // in the ground plane, to the left
  Eigen::Vector3d axle = Eigen::Vector3d::UnitY();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double load_n = 0.0;        // normal force, >= 0
  double damping_n = 0.0;     // part of it that is tyre damping
  double deflection_m = 0.0;  // vertical, 0 in the air
  bool on_terrain = true;
};

// Normal forces: a spring over the vertical gap, R / cos(tilt) - (z_hub - h), along (-hx, -hy, 1),
// with damping; applied on the line from the hub along the terrain normal, so that it never pushes
// the vehicle uphill. The body's tilt stands for the slope's: with the facet's own slope the
// energy would jump at every edge between triangles, with none the hub would sink by
// R (1 - cos(slope)) into a slope. A pivoted axle shares
// its load equally between its wheels up to its oscillation limit. Steered wheels point along the
// circle of `curvature_per_m` that B's origin is steered on.
PerWheel<WheelContact> touch_ground(const Heightfield& terrain, const ChassisState& chassis,
                                    std::span<const WheelDefinition> wheels,
                                    double curvature_per_m);

// Energy [J] in the tyres' vertical springs of a body whose z axis has the vertical part
// `uprightness`. A tilt lifts the hubs by R (1 / cos(tilt) - 1), which no force pays for: it is
// taken off again here, or slopes would owe the ledger that much until they are left.
double spring_energy_j(std::span<const WheelContact> contacts,
                       std::span<const WheelDefinition> wheels, double uprightness);

}  // namespace headland
