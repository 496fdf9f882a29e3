// Tyres: wheel spin and the forces along and across the wheels.
#pragma once

#include <span>
#include <vector>

#include "sim/belly.h"
#include "sim/chassis.h"
#include "sim/wheel.h"
#include "terrains/soil_map.h"

namespace headland {

inline constexpr double kRelaxationLength_m = 0.3;  // bristle length of the tyre, both directions
inline constexpr double kBristleDamping_s = 0.02;   // LuGre-like; only felt while forces build up
inline constexpr int kTyreIterations = 2;           // Gauss-Seidel sweeps over all wheels

// Torques [N m] about a wheel's axle. Drive acts between chassis and wheel; brake and rolling
// resistance are Coulomb limits >= 0 that may lock the wheel.
struct WheelTorques {
  double drive_nm = 0.0;
  double brake_max_nm = 0.0;
};

// What the tyres did in one step.
struct TyreResult {
  PerWheel<double> along_n{};  // on the chassis, along and across the wheel
  PerWheel<double> across_n{};
  PerWheel<double> soil_n{};             // soil's resistance on the hub, along the wheel, signed
  PerWheel<double> brake_nm{};           // on the wheel, signed
  PerWheel<double> rolling_nm{};         // on the wheel, signed
  PerWheel<double> slip{};               // 0..1, driving or braking
  PerWheel<double> sliding_mps{};        // of the tread over the ground, any direction
  std::vector<Eigen::Vector3d> belly_W;  // friction on the chassis at each belly contact
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();  // all on the chassis, besides normal forces
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();
};

// Wheel spin and both tyre forces of all wheels of one body, solved implicitly together over one
// step, with `v_W` and `omega_W` the chassis velocities predicted with everything but tyres and
// brakes. Longitudinal and lateral bristles of relaxation length kRelaxationLength_m, saturated
// together by the soil's law (terrains/traction.h):
//   F = N gross_pull(|u|) u / |u|,  u = (slip_stiffness z_x, z_y / gamma) / relaxation length,
// whose steady state is the law itself in slip and, across, in slip angle over gamma (Crolla). The
// tyre's own resistance is a Coulomb torque on the wheel, the soil's a Coulomb force on the hub.
// Friction of the `belly` where it rests on the ground is solved with them. Advances `states`.
TyreResult solve_tyres(std::span<const WheelContact> contacts,
                       std::span<const WheelDefinition> wheels,
                       std::span<const WheelTorques> torques, const SoilMap& soil,
                       const ChassisMass& mass, const ChassisState& chassis,
                       const Eigen::Vector3d& v_W, const Eigen::Vector3d& omega_W, double dt_s,
                       std::span<WheelState> states, std::span<const BellyContact> belly = {});

}  // namespace headland
