// Tyres: wheel spin and the forces along and across the wheels.
#pragma once

#include "sim/chassis.h"
#include "sim/wheel.h"
#include "terrains/soil.h"

namespace headland {

inline constexpr double kRelaxationLength_m = 0.3;  // bristle length of the tyre, both directions
inline constexpr double kBristleDamping_s = 0.02;   // LuGre-like; only felt while forces build up
inline constexpr int kTyreIterations = 3;           // Gauss-Seidel sweeps over all wheels

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
  PerWheel<double> brake_nm{};                        // on the wheel, signed
  PerWheel<double> rolling_nm{};                      // on the wheel, signed
  PerWheel<double> slip{};                            // 0..1, driving or braking
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();  // all on the chassis, besides normal forces
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();
};

// Wheel spin and both tyre forces of all wheels, solved implicitly together over one step, with
// `v_W` and `omega_W` the chassis velocities predicted with everything but tyres and brakes.
// Longitudinal and lateral bristles of relaxation length kRelaxationLength_m, saturated together:
//   F = N mu (1 - exp(-|u|)) u / |u|,  u = (c_x z_x, c_y z_y) / relaxation length,
// whose steady state is N mu (1 - exp(-c_x s)) in slip and N mu (1 - exp(-|a| / gamma)) in slip
// angle (Crolla). Advances `states`.
TyreResult solve_tyres(const PerWheel<WheelContact>& contacts,
                       const PerWheel<WheelDefinition>& wheels,
                       const PerWheel<WheelTorques>& torques, const Soil& soil,
                       const ChassisMass& mass, const ChassisState& chassis,
                       const Eigen::Vector3d& v_W, const Eigen::Vector3d& omega_W, double dt_s,
                       PerWheel<WheelState>& states);

}  // namespace headland
