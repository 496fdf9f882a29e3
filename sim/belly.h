// The belly: where the hull's underside rests on the ground, and what that costs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/impulse_row.h"
#include "terrains/heightfield.h"

namespace headland {

// Probes on the hull's underside, along and across it: corners, edges and inside.
inline constexpr int kBellyProbesAlong = 5;
inline constexpr int kBellyProbesAcross = 3;
// The weight of the machine on all probes presses them this far into the ground [m] (assumed: firm
// soil under a steel plate).
inline constexpr double kBellySink_m = 0.01;
// Of critical damping, for the machine's mass on all probes (assumed).
inline constexpr double kBellyDamping = 0.3;
// Steel sliding on soil (assumed; 0.3 on wet clay, 0.6 on sand).
inline constexpr double kBellyFriction = 0.5;

// What never changes in a run. Frame B with its origin at the centre of mass (C).
struct Belly {
  std::vector<Eigen::Vector3d> probes_C;
  double reach_m = 0.0;            // of the furthest probe from C
  double stiffness_n_per_m = 0.0;  // of each
  double damping_n_s_per_m = 0.0;  // of each
  double way_per_height = 1.0;     // sqrt(1 + steepest slope of the terrain squared)
};
Belly make_belly(const Vehicle& vehicle, const ChassisMass& mass, const Heightfield& terrain);

// A probe below the surface. Vectors in W, `arm` from the centre of mass.
struct BellyContact {
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double load_n = 0.0;     // normal force, >= 0
  double damping_n = 0.0;  // part of it that is damping
  double depth_m = 0.0;    // vertical, > 0
};

// Probes that are below the surface, pressed back by a spring over the vertical depth along
// (-hx, -hy, 1) with damping, like a wheel (wheel.h); and how far [m] any point of the belly can
// move before another look is needed.
struct BellyTouch {
  std::vector<BellyContact> contacts;
  double clear_m = 0.0;
};
BellyTouch touch_belly(const Belly& belly, const Heightfield& terrain, const ChassisState& chassis);

// The contacts, looked for only when the way since the last look could have brought a probe to the
// ground: no gap closes faster than the probe moves times way_per_height. `clear_m` is what is left
// of that way, at first 0.
std::vector<BellyContact> watch_belly(const Belly& belly, const Heightfield& terrain,
                                      const ChassisState& chassis, double dt_s, double& clear_m);

// Energy [J] in the springs.
double belly_spring_j(const Belly& belly, const std::vector<BellyContact>& contacts);

// Coulomb friction of one contact, solved with the tyres: at most kBellyFriction of its load,
// against the sliding that would be left without it.
struct BellyRows {
  ImpulseRow along;
  ImpulseRow across;
  double limit = 0.0;  // impulse
};
BellyRows belly_rows(const BellyContact& contact, const Motion& motion, double dt_s);
void solve_belly(BellyRows& rows, Motion& motion);

}  // namespace headland
