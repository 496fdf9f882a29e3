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
  double spring_j = 0.0;   // tyres, ground under the belly, pin of a trailed implement
};

// Of one body with its wheels.
StoredEnergy stored_energy(const ChassisMass& mass, const ChassisState& chassis,
                           std::span<const WheelDefinition> wheels,
                           std::span<const WheelState> states,
                           std::span<const WheelContact> contacts, double belly_spring_j = 0.0);

using CauseLosses = std::array<double, kEnergyCauses>;  // W, by EnergyCause

// What the wheels of one body did in a step, with its velocities before and after it.
struct WheelWork {
  const ChassisState& before;
  const ChassisState& after;
  std::span<const WheelDefinition> wheels;
  std::span<const WheelContact> contacts;
  std::span<const double> spin_before;
  std::span<const WheelState> states;  // after
  const TyreResult& tyres;
};

// Charges slip, scrub, rolling, brake and tyre damping at the mid-step velocities. Returns the
// mid-step spins [rad/s] relative to the body.
PerWheel<double> charge_wheels(const WheelWork& work, CauseLosses& cause_w);

// Power [W] that a force on a body through an offset from its centre of mass takes from it.
double power_taken_w(const Eigen::Vector3d& force_W, const Eigen::Vector3d& arm,
                     const ChassisState& before, const ChassisState& after);

// Everything that did work on the vehicle in a step.
struct StepWork {
  WheelWork wheels;
  const PerWheel<WheelTorques>& torques;
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
  CauseLosses cause_w{};
  PerMotor<double> motor_speed_rad_per_s{};
  double motor_shaft_w = 0.0;  // all motors
};
StepLosses step_losses(const StepWork& work);

void add(EnergyBalance& sum, const EnergyBalance& part);

// Battery minus all causes but the residual.
double unaccounted_j(const EnergyBalance& balance);

}  // namespace headland
