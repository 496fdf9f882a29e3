#include "sim/belly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace headland {
namespace {

// Largest slope of any triangle of the surface.
double steepest_slope(const Heightfield& terrain) {
  double steepest_squared = 0.0;
  for (int j = 0; j + 1 < terrain.rows; ++j) {
    for (int i = 0; i + 1 < terrain.columns; ++i) {
      const double h10 = terrain.at(i + 1, j);
      const double h01 = terrain.at(i, j + 1);
      for (const double corner : {terrain.at(i, j), terrain.at(i + 1, j + 1)}) {
        const double x = h10 - corner;
        const double y = h01 - corner;
        steepest_squared = std::max(steepest_squared, x * x + y * y);
      }
    }
  }
  return std::sqrt(steepest_squared) / terrain.cell_m;
}

double between(double low, double high, int step, int steps) {
  return low + (high - low) * step / (steps - 1);
}

}  // namespace

Belly make_belly(const Vehicle& vehicle, const ChassisMass& mass, const Heightfield& terrain) {
  Belly belly;
  const Body& body = vehicle.body;
  for (int i = 0; i < kBellyProbesAlong; ++i) {
    for (int j = 0; j < kBellyProbesAcross; ++j) {
      const Eigen::Vector3d probe_B(
          between(-body.rear_overhang_m, body.length_m - body.rear_overhang_m, i,
                  kBellyProbesAlong),
          between(-0.5 * body.width_m, 0.5 * body.width_m, j, kBellyProbesAcross),
          body.ground_clearance_m);
      belly.probes_C.push_back(probe_B - mass.com_B);
      belly.reach_m = std::max(belly.reach_m, belly.probes_C.back().norm());
    }
  }
  const double stiffness_n_per_m = mass.mass_kg * kGravity_mps2 / kBellySink_m;
  const auto probes = static_cast<double>(belly.probes_C.size());
  belly.stiffness_n_per_m = stiffness_n_per_m / probes;
  belly.damping_n_s_per_m =
      2.0 * kBellyDamping * std::sqrt(stiffness_n_per_m * mass.mass_kg) / probes;
  const double steepest = steepest_slope(terrain);
  belly.way_per_height = std::sqrt(1.0 + steepest * steepest);
  return belly;
}

BellyTouch touch_belly(const Belly& belly, const Heightfield& terrain,
                       const ChassisState& chassis) {
  BellyTouch touch;
  double least_gap_m = std::numeric_limits<double>::max();
  for (const Eigen::Vector3d& probe_C : belly.probes_C) {
    const Eigen::Vector3d arm = chassis.R_WB * probe_C;
    const Eigen::Vector3d p_W = chassis.p_WC + arm;
    const SurfacePoint ground = surface_at(terrain, p_W.x(), p_W.y());
    const double gap_m = p_W.z() - ground.height_m;
    least_gap_m = std::min(least_gap_m, gap_m);
    if (!(gap_m < 0.0)) continue;
    const Eigen::Vector3d slope_normal(-ground.gradient.x(), -ground.gradient.y(), 1.0);
    const double scale = slope_normal.norm();
    const double rate_mps = -slope_normal.dot(point_velocity(chassis.v_W, chassis.omega_W, arm));
    const double spring_n = belly.stiffness_n_per_m * -gap_m;
    // The ground does not pull: damping can at most cancel the spring.
    const double damping_n = std::max(belly.damping_n_s_per_m * rate_mps, -spring_n);
    touch.contacts.push_back(
        {arm, slope_normal / scale, scale * (spring_n + damping_n), scale * damping_n, -gap_m});
  }
  touch.clear_m = std::max(0.0, least_gap_m / belly.way_per_height);
  return touch;
}

std::vector<BellyContact> watch_belly(const Belly& belly, const Heightfield& terrain,
                                      const ChassisState& chassis, double dt_s, double& clear_m) {
  clear_m -= dt_s * (chassis.v_W.norm() + belly.reach_m * chassis.omega_W.norm());
  if (clear_m > 0.0) return {};
  BellyTouch touch = touch_belly(belly, terrain, chassis);
  clear_m = touch.clear_m;
  return std::move(touch.contacts);
}

double belly_spring_j(const Belly& belly, const std::vector<BellyContact>& contacts) {
  double energy_j = 0.0;
  for (const BellyContact& contact : contacts) {
    energy_j += 0.5 * belly.stiffness_n_per_m * contact.depth_m * contact.depth_m;
  }
  return energy_j;
}

BellyRows belly_rows(const BellyContact& contact, const Motion& motion, double dt_s) {
  const Eigen::Vector3d along =
      (Eigen::Vector3d::UnitX() - contact.normal.x() * contact.normal).normalized();
  return {ImpulseRow(motion, contact.arm, along),
          ImpulseRow(motion, contact.arm, contact.normal.cross(along)),
          dt_s * kBellyFriction * contact.load_n};
}

void solve_belly(BellyRows& rows, Motion& motion) {
  const Eigen::Vector2d wanted(
      rows.along.impulse - rows.along.velocity(motion) / rows.along.mobility,
      rows.across.impulse - rows.across.velocity(motion) / rows.across.mobility);
  const double size = wanted.norm();
  const Eigen::Vector2d given =
      size > rows.limit ? Eigen::Vector2d(rows.limit / size * wanted) : wanted;
  rows.along.apply(motion, given.x() - rows.along.impulse);
  rows.across.apply(motion, given.y() - rows.across.impulse);
}

}  // namespace headland
