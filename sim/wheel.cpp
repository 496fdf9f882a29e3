#include "sim/wheel.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

WheelDefinition define_wheel(const Axle& axle, bool left, SteeringKind steering,
                             const ChassisMass& mass, double static_load_n) {
  WheelDefinition wheel;
  const double half_track_m = 0.5 * axle.track_m;
  wheel.hub_C =
      Eigen::Vector3d(axle.x_B_m, left ? half_track_m : -half_track_m, axle.radius_m) - mass.com_B;
  wheel.radius_m = axle.radius_m;
  wheel.free_radius_m = axle.radius_m + static_load_n / axle.vertical_stiffness_n_per_m;
  wheel.tyre = tyre_size(axle, static_load_n);
  wheel.inertia_kg_m2 = axle.wheel_inertia_kg_m2;
  wheel.stiffness_n_per_m = axle.vertical_stiffness_n_per_m;
  wheel.damping_n_s_per_m = axle.vertical_damping_n_s_per_m;
  wheel.driven = axle.driven;
  wheel.steered = steering != SteeringKind::kSkid && axle.x_B_m != 0.0;
  wheel.p_B = {axle.x_B_m, left ? half_track_m : -half_track_m};
  wheel.oscillation_max_rad = axle.oscillation_max_rad;
  return wheel;
}

constexpr double kLeastUprightness = 0.5;  // a vehicle past 60 deg has rolled over

// Vertical gap geometry of one wheel before its axle's pivot is considered.
struct Gap {
  Eigen::Vector3d hub_W;
  Eigen::Vector3d slope_normal;  // (-hx, -hy, 1), not normalised
  double deflection_m = 0.0;     // may be negative: in the air
  double rate_mps = 0.0;
  bool on_terrain = true;
};

Gap measure_gap(const Heightfield& terrain, const ChassisState& chassis,
                const WheelDefinition& wheel, double per_tilt) {
  Gap gap;
  const Eigen::Vector3d arm = chassis.R_WB * wheel.hub_C;
  gap.hub_W = chassis.p_WC + arm;
  const SurfacePoint ground = surface_at(terrain, gap.hub_W.x(), gap.hub_W.y());
  gap.slope_normal = {-ground.gradient.x(), -ground.gradient.y(), 1.0};
  gap.deflection_m = wheel.free_radius_m * per_tilt - (gap.hub_W.z() - ground.height_m);
  gap.rate_mps = -gap.slope_normal.dot(point_velocity(chassis.v_W, chassis.omega_W, arm));
  gap.on_terrain = ground.inside;
  return gap;
}

}  // namespace

PerWheel<WheelDefinition> define_wheels(const Vehicle& vehicle, const ChassisMass& mass) {
  const AxleLoads loads = static_axle_loads(vehicle);
  PerWheel<WheelDefinition> wheels;
  for (int i = 0; i < kWheels; ++i) {
    const bool front = i >= 2;
    const double load_n = 0.5 * (front ? loads.front_n : loads.rear_n);
    auto& wheel = wheels[static_cast<std::size_t>(i)];
    wheel = define_wheel(front ? vehicle.front : vehicle.rear, i % 2 == 0, vehicle.steering.kind,
                         mass, load_n);
    wheel.partner = i ^ 1;
  }
  return wheels;
}

PerWheel<WheelContact> touch_ground(const Heightfield& terrain, const ChassisState& chassis,
                                    std::span<const WheelDefinition> wheels,
                                    double curvature_per_m) {
  const double per_tilt = 1.0 / std::max(chassis.R_WB(2, 2), kLeastUprightness);
  PerWheel<Gap> gaps;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    gaps[i] = measure_gap(terrain, chassis, wheels[i], per_tilt);
  }

  PerWheel<WheelContact> contacts;
  const Eigen::Vector3d forward = chassis.R_WB.col(0);
  const Eigen::Vector3d left = chassis.R_WB.col(1);
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const WheelDefinition& wheel = wheels[i];
    const Gap& gap = gaps[i];
    WheelContact& contact = contacts[i];
    contact.on_terrain = gap.on_terrain;
    contact.hub_arm = gap.hub_W - chassis.p_WC;
    contact.normal_arm = contact.hub_arm;
    const double steepness = gap.slope_normal.norm();
    contact.normal = gap.slope_normal / steepness;

    const bool pivoted = wheel.oscillation_max_rad > 0.0;
    double deflection_m = gap.deflection_m;
    double rate_mps = gap.rate_mps;
    if (pivoted) {
      // The massless axle turns about its pivot until both wheels carry the same.
      const Gap& other = gaps[static_cast<std::size_t>(wheel.partner)];
      const double half_difference_m = 0.5 * (gap.deflection_m - other.deflection_m);
      const double limit_m = std::abs(wheel.hub_C.y()) * std::tan(wheel.oscillation_max_rad);
      const double beyond_m = half_difference_m - std::clamp(half_difference_m, -limit_m, limit_m);
      deflection_m = 0.5 * (gap.deflection_m + other.deflection_m) + beyond_m;
      if (beyond_m == 0.0) {
        rate_mps = 0.5 * (gap.rate_mps + other.rate_mps);
        contact.normal_arm -= left * wheel.hub_C.y();
      }
    }
    if (deflection_m > 0.0) {
      const double spring_n = wheel.stiffness_n_per_m * deflection_m;
      // A tyre does not pull: damping can at most cancel the spring.
      const double damping_n = std::max(wheel.damping_n_s_per_m * rate_mps, -spring_n);
      contact.deflection_m = deflection_m;
      contact.load_n = steepness * (spring_n + damping_n);
      contact.damping_n = steepness * damping_n;
    }

    Eigen::Vector3d heading = forward;
    contact.axle = left;
    if (wheel.steered) {
      // Cosine and sine of wheel_angle_rad().
      const Eigen::Vector2d heading_B =
          Eigen::Vector2d(1.0 - wheel.p_B.y() * curvature_per_m, wheel.p_B.x() * curvature_per_m)
              .normalized();
      heading = heading_B.x() * forward + heading_B.y() * left;
      contact.axle = heading_B.x() * left - heading_B.y() * forward;
    }
    contact.along = (heading - heading.dot(contact.normal) * contact.normal).normalized();
    contact.across = contact.normal.cross(contact.along);
    // With a pivot the lateral force reaches the chassis at the pivot, not at the ground.
    contact.lateral_arm =
        pivoted ? contact.hub_arm : contact.hub_arm - wheel.radius_m * contact.normal;
  }
  return contacts;
}

double spring_energy_j(std::span<const WheelContact> contacts,
                       std::span<const WheelDefinition> wheels, double uprightness) {
  const double lift = 1.0 / std::max(uprightness, kLeastUprightness) - 1.0;
  double energy_j = 0.0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const double deflection_m = contacts[i].deflection_m;
    energy_j += wheels[i].stiffness_n_per_m * deflection_m *
                (0.5 * deflection_m - wheels[i].free_radius_m * lift);
  }
  return energy_j;
}

}  // namespace headland
