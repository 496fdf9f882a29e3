// Rigid bodies: what a vehicle with a mounted implement makes, its motion, the forces on it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicle_models/vehicle_figures.h"

namespace headland {

// Mass, centre of mass and principal inertia of body and mounted implement together. The implement
// is a bar of its working width at its com_height_m; a trailed one is a body of its own. Products
// of inertia are neglected: machines are close to symmetric about the x-z plane.
struct ChassisMass {
  double mass_kg = 0.0;
  Eigen::Vector3d com_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d inertia_kg_m2 = Eigen::Vector3d::Zero();
};

ChassisMass chassis_mass(const Vehicle& vehicle);

// Motion of the rigid body: position of the centre of mass C, attitude, velocities, all in W.
struct ChassisState {
  Eigen::Vector3d p_WC = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d omega_W = Eigen::Vector3d::Zero();
};

// Velocity of the body's point that is at offset `r_W` from the centre of mass.
inline Eigen::Vector3d point_velocity(const Eigen::Vector3d& v_W, const Eigen::Vector3d& omega_W,
                                      const Eigen::Vector3d& r_W) {
  return v_W + omega_W.cross(r_W);
}

// Forces on a body through offsets from its centre of mass, in W.
struct Load {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& force, const Eigen::Vector3d& arm) {
    force_W += force;
    torque_W += arm.cross(force);
  }
};

// The velocities after a step with gravity and this load, by the Euler step that Bullet makes but
// for its gyroscopic torque.
struct Velocities {
  Eigen::Vector3d v_W;
  Eigen::Vector3d omega_W;
};
Velocities velocities_after(const ChassisState& chassis, const ChassisMass& mass, const Load& load,
                            double dt_s);

// Yaw, pitch (nose up positive) and roll (right side down positive) of an attitude.
Eigen::Vector3d yaw_pitch_roll(const Eigen::Matrix3d& R_WB);

}  // namespace headland
