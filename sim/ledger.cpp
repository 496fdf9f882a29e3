#include "sim/ledger.h"

#include <cmath>

namespace headland {
namespace {

double& of(CauseLosses& causes, EnergyCause cause) {
  return causes[static_cast<std::size_t>(cause)];
}

}  // namespace

StoredEnergy stored_energy(const ChassisMass& mass, const ChassisState& chassis,
                           std::span<const WheelDefinition> wheels,
                           std::span<const WheelState> states,
                           std::span<const WheelContact> contacts, double belly_spring_j) {
  StoredEnergy stored;
  stored.grade_j = mass.mass_kg * kGravity_mps2 * chassis.p_WC.z();
  const Eigen::Vector3d omega_B = chassis.R_WB.transpose() * chassis.omega_W;
  stored.kinetic_j = 0.5 * mass.mass_kg * chassis.v_W.squaredNorm() +
                     0.5 * omega_B.dot(mass.inertia_kg_m2.cwiseProduct(omega_B));
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    stored.kinetic_j +=
        0.5 * wheels[i].inertia_kg_m2 * states[i].spin_rad_per_s * states[i].spin_rad_per_s;
  }
  stored.spring_j = spring_energy_j(contacts, wheels, chassis.R_WB(2, 2)) + belly_spring_j;
  return stored;
}

PerWheel<double> charge_wheels(const WheelWork& work, CauseLosses& cause_w) {
  const Eigen::Vector3d v_mid = 0.5 * (work.before.v_W + work.after.v_W);
  const Eigen::Vector3d omega_mid = 0.5 * (work.before.omega_W + work.after.omega_W);
  PerWheel<double> relative_spin{};
  for (std::size_t i = 0; i < work.wheels.size(); ++i) {
    const WheelContact& contact = work.contacts[i];
    const double spin_mid = 0.5 * (work.spin_before[i] + work.states[i].spin_rad_per_s);
    relative_spin[i] = spin_mid - omega_mid.dot(contact.axle);
    const double along_mps = contact.along.dot(point_velocity(v_mid, omega_mid, contact.hub_arm));
    const double across_mps =
        contact.across.dot(point_velocity(v_mid, omega_mid, contact.lateral_arm));
    const double normal_mps =
        contact.normal.dot(point_velocity(v_mid, omega_mid, contact.normal_arm));
    of(cause_w, EnergyCause::kSlip) -=
        work.tyres.along_n[i] * (along_mps - work.wheels[i].radius_m * spin_mid);
    of(cause_w, EnergyCause::kScrub) -= work.tyres.across_n[i] * across_mps;
    of(cause_w, EnergyCause::kRolling) -=
        work.tyres.rolling_nm[i] * spin_mid + work.tyres.soil_n[i] * along_mps;
    of(cause_w, EnergyCause::kBrake) -= work.tyres.brake_nm[i] * relative_spin[i];
    of(cause_w, EnergyCause::kSuspension) -= contact.damping_n * normal_mps;
  }
  return relative_spin;
}

double power_taken_w(const Eigen::Vector3d& force_W, const Eigen::Vector3d& arm,
                     const ChassisState& before, const ChassisState& after) {
  return -force_W.dot(
      point_velocity(0.5 * (before.v_W + after.v_W), 0.5 * (before.omega_W + after.omega_W), arm));
}

StepLosses step_losses(const StepWork& work) {
  StepLosses losses;
  auto& cause_w = losses.cause_w;
  const PerWheel<double> relative_spin = charge_wheels(work.wheels, cause_w);
  double wheel_power_w = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    wheel_power_w += work.torques[i].drive_nm * relative_spin[i];
  }
  losses.motor_speed_rad_per_s = motor_speeds(work.layout, relative_spin, work.gear_ratio);
  for (std::size_t m = 0; m < kWheels; ++m) {
    losses.motor_shaft_w += work.motor_nm[m] * losses.motor_speed_rad_per_s[m];
  }
  of(cause_w, EnergyCause::kDrivetrain) = losses.motor_shaft_w - wheel_power_w;
  of(cause_w, EnergyCause::kDraft) =
      power_taken_w(work.draft_W, work.draft_arm, work.wheels.before, work.wheels.after);
  for (std::size_t i = 0; i < work.belly.size(); ++i) {
    const BellyContact& contact = work.belly[i];
    of(cause_w, EnergyCause::kBelly) +=
        power_taken_w(work.wheels.tyres.belly_W[i] + contact.damping_n * contact.normal,
                      contact.arm, work.wheels.before, work.wheels.after);
  }
  return losses;
}

void add(EnergyBalance& sum, const EnergyBalance& part) {
  sum.battery_j += part.battery_j;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) sum.cause_j[i] += part.cause_j[i];
}

double unaccounted_j(const EnergyBalance& balance) {
  double sum_j = balance.battery_j;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    if (i != static_cast<std::size_t>(EnergyCause::kResidual)) sum_j -= balance.cause_j[i];
  }
  return sum_j;
}

}  // namespace headland
