// The energy ledger: where the battery's energy went, step by step.
#pragma once

#include <span>

#include "sim/battery.h"
#include "sim/chassis.h"
#include "sim/drivetrain.h"
#include "sim/run_record.h"
#include "sim/tyre.h"

namespace headland {

// Energy in the stores [J]: functions of state, not integrals of forces, so that what the
// integration loses shows up as residual.
struct StoredEnergy {
  double grade_j = 0.0;    // potential energy of the whole machine
  double kinetic_j = 0.0;  // body and wheel spin
  double spring_j = 0.0;   // vertical springs of the tyres and of the ground under the belly
};

StoredEnergy stored_energy(const ChassisMass& mass, const ChassisState& chassis,
                           const PerWheel<WheelDefinition>& wheels,
                           const PerWheel<WheelState>& states,
                           const PerWheel<WheelContact>& contacts, double belly_spring_j = 0.0);

// Everything that did work in a step, with the velocities before and after it.
struct StepWork {
  const ChassisState& before;
  const ChassisState& after;
  const PerWheel<WheelDefinition>& wheels;
  const PerWheel<WheelContact>& contacts;
  const PerWheel<WheelTorques>& torques;
  const PerWheel<double>& spin_before;
  const PerWheel<WheelState>& states;  // after
  const TyreResult& tyres;
  const MotorLayout& layout;
  const PerMotor<double>& motor_nm;
  double gear_ratio = 1.0;
  Eigen::Vector3d draft_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d draft_arm = Eigen::Vector3d::Zero();
  std::span<const BellyContact> belly{};
};

// Losses [W] of a step but for the battery's, by cause, each force taken at the mid-step velocity
// (v_n + v_n+1) / 2, at which its work is exactly the change of kinetic energy; and the mid-step
// motor speeds. Grade, kinetic and stored stay zero here: they come from StoredEnergy.
struct StepLosses {
  std::array<double, kEnergyCauses> cause_w{};
  PerMotor<double> motor_speed_rad_per_s{};
  double motor_shaft_w = 0.0;  // all motors
};
StepLosses step_losses(const StepWork& work);

void add(EnergyBalance& sum, const EnergyBalance& part);

// Battery minus all causes but the residual.
double unaccounted_j(const EnergyBalance& balance);

}  // namespace headland
