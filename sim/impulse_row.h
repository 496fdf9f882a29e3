// Impulses on the rigid body within one step, one scalar at a time.
#pragma once

#include <Eigen/Core>

#include "sim/chassis.h"

namespace headland {

// Chassis velocities while impulses accumulate.
struct Motion {
  Eigen::Vector3d v_W;
  Eigen::Vector3d omega_W;
  double inverse_mass = 0.0;
  Eigen::Matrix3d inverse_inertia_W;

  void add_impulse(const Eigen::Vector3d& impulse, const Eigen::Vector3d& angular) {
    v_W += inverse_mass * impulse;
    omega_W += angular;
  }
};

// One scalar force: how the chassis point at offset `arm` from the centre of mass moves along
// `direction` per unit impulse there.
struct ImpulseRow {
  Eigen::Vector3d direction;
  Eigen::Vector3d moment;   // arm x direction: what the force does about the centre of mass
  Eigen::Vector3d angular;  // change of omega per unit impulse
  double mobility = 0.0;    // change of velocity along direction per unit impulse
  double impulse = 0.0;

  ImpulseRow() = default;
  ImpulseRow(const Motion& motion, const Eigen::Vector3d& arm, const Eigen::Vector3d& direction_in)
      : direction(direction_in),
        moment(arm.cross(direction)),
        angular(motion.inverse_inertia_W * moment),
        mobility(motion.inverse_mass + angular.dot(moment)) {}
  // Of the point along the direction: direction . (v + omega x arm).
  double velocity(const Eigen::Vector3d& v_W, const Eigen::Vector3d& omega_W) const {
    return direction.dot(v_W) + moment.dot(omega_W);
  }
  double velocity(const Motion& motion) const { return velocity(motion.v_W, motion.omega_W); }
  void apply(Motion& motion, double change) {
    motion.add_impulse(change * direction, change * angular);
    impulse += change;
  }
};

}  // namespace headland
