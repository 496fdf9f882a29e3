#include "sim/chassis.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// Inertia of a point mass at d from the common centre of mass (parallel axes).
Eigen::Vector3d steiner(double mass_kg, const Eigen::Vector3d& d) {
  return mass_kg * Eigen::Vector3d(d.y() * d.y() + d.z() * d.z(), d.x() * d.x() + d.z() * d.z(),
                                   d.x() * d.x() + d.y() * d.y());
}

}  // namespace

ChassisMass chassis_mass(const Vehicle& vehicle) {
  ChassisMass chassis;
  chassis.mass_kg = carried_mass_kg(vehicle);
  chassis.com_B = total_com_B(vehicle);
  chassis.inertia_kg_m2 = vehicle.body.inertia_kg_m2;
  const Implement& implement = vehicle.implement;
  if (implement.trailing) return chassis;
  const Eigen::Vector3d implement_B(implement.x_B_m, 0.0, implement.com_height_m);
  const double bar =
      implement.mass_kg * implement.working_width_m * implement.working_width_m / 12.0;
  chassis.inertia_kg_m2 = vehicle.body.inertia_kg_m2 + Eigen::Vector3d(bar, 0.0, bar) +
                          steiner(vehicle.body.mass_kg, vehicle.body.com_B - chassis.com_B) +
                          steiner(implement.mass_kg, implement_B - chassis.com_B);
  return chassis;
}

Velocities velocities_after(const ChassisState& chassis, const ChassisMass& mass, const Load& load,
                            double dt_s) {
  const Eigen::Vector3d gravity(0.0, 0.0, -kGravity_mps2);
  const Eigen::Vector3d torque_B = chassis.R_WB.transpose() * load.torque_W;
  return {chassis.v_W + dt_s * (gravity + load.force_W / mass.mass_kg),
          chassis.omega_W + dt_s * (chassis.R_WB * torque_B.cwiseQuotient(mass.inertia_kg_m2))};
}

Eigen::Vector3d yaw_pitch_roll(const Eigen::Matrix3d& R_WB) {
  const double yaw = std::atan2(R_WB(1, 0), R_WB(0, 0));
  const double pitch = std::asin(std::clamp(R_WB(2, 0), -1.0, 1.0));
  const double roll = std::atan2(R_WB(2, 1), R_WB(2, 2));
  return {yaw, pitch, roll};
}

}  // namespace headland
