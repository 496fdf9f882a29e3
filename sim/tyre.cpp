#include "sim/tyre.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// The tyre law linearised about the present deflection: F = stiffness * z.
struct Bristle {
  double stiffness_x = 0.0;
  double stiffness_y = 0.0;
};

Bristle linearise(const Traction& traction, double lateral_gamma_rad, double load_n, double z_x_m,
                  double z_y_m) {
  const double c_x = traction.slip_stiffness / kRelaxationLength_m;
  const double c_y = 1.0 / (lateral_gamma_rad * kRelaxationLength_m);
  // The secant's limit at no deflection is the initial slope, which this u is close enough to.
  constexpr double kSmall = 1e-9;
  const double u = std::max(Eigen::Vector2d(c_x * z_x_m, c_y * z_y_m).norm(), kSmall);
  const double strength = load_n * gross_pull(traction, u) / u;
  return {strength * c_x, strength * c_y};
}

// Implicit bristle over one step: z+ = (z + dt v+) / relax, F = k (z+ + tau (z+ - z) / dt), and
// v+ = v_free + mobility p with p = -F dt. Returns p.
double bristle_impulse(double stiffness, double z_m, double relax, double v_free, double mobility,
                       double dt_s) {
  const double damped = 1.0 + kBristleDamping_s / dt_s;
  const double free_force =
      stiffness * (damped * (z_m + dt_s * v_free) / relax - (damped - 1.0) * z_m);
  return -dt_s * free_force / (1.0 + dt_s * dt_s * stiffness * damped * mobility / relax);
}

struct WheelRows {
  ImpulseRow x;
  ImpulseRow y;
  Eigen::Vector3d axle;
  Eigen::Vector3d brake_angular;  // change of omega per unit brake impulse on the wheel
  double spin_free = 0.0;         // predicted with the drive torque alone
  double coulomb_impulse = 0.0;   // signed, on the wheel, brake and rolling together
  double coulomb_limit = 0.0;     // impulse
  double brake_share = 0.0;       // of the limit
  double soil_impulse = 0.0;      // of the soil against the motion, on the hub
  double soil_limit = 0.0;        // impulse
  double relax_speed_mps = 0.0;
  double z_x_new = 0.0;
  double z_y_new = 0.0;
};

double relaxation(const WheelRows& row, double dt_s) {
  return 1.0 + dt_s * row.relax_speed_mps / kRelaxationLength_m;
}

// Longitudinal force and spin together: rolling forwards, rolling backwards, or locked: by the
// brake to the chassis, by rolling resistance to the ground.
void solve_along(WheelRows& rows, Motion& motion, const WheelDefinition& wheel,
                 const WheelState& state, double stiffness, double limit_impulse, double relax,
                 double dt_s) {
  const double radius_m = wheel.radius_m;
  const double locked = rows.brake_share > 0.5 ? motion.omega_W.dot(rows.axle) : 0.0;
  const double brake_before = rows.coulomb_impulse * rows.brake_share;
  motion.omega_W -= brake_before * rows.brake_angular;
  const double hub_velocity = rows.x.velocity(motion) - rows.x.mobility * rows.x.impulse;
  const double spin_per_impulse = radius_m / wheel.inertia_kg_m2;
  const auto rolling = [&](double coulomb) {
    const double spin = rows.spin_free + coulomb / wheel.inertia_kg_m2;
    return std::clamp(
        bristle_impulse(stiffness, state.bristle_x_m, relax, hub_velocity - radius_m * spin,
                        rows.x.mobility + radius_m * spin_per_impulse, dt_s),
        -limit_impulse, limit_impulse);
  };
  const auto spin_after = [&](double coulomb, double impulse) {
    return rows.spin_free + coulomb / wheel.inertia_kg_m2 - spin_per_impulse * impulse;
  };

  double coulomb = -rows.coulomb_limit;
  double impulse = rolling(coulomb);
  double spin = spin_after(coulomb, impulse);
  if (spin <= locked) {
    coulomb = rows.coulomb_limit;
    impulse = rolling(coulomb);
    spin = spin_after(coulomb, impulse);
    if (spin >= locked) {
      impulse = std::clamp(bristle_impulse(stiffness, state.bristle_x_m, relax,
                                           hub_velocity - radius_m * locked, rows.x.mobility, dt_s),
                           -limit_impulse, limit_impulse);
      coulomb = std::clamp(wheel.inertia_kg_m2 * (locked - rows.spin_free) + radius_m * impulse,
                           -rows.coulomb_limit, rows.coulomb_limit);
      spin = locked;
    }
  }
  rows.x.apply(motion, impulse - rows.x.impulse);
  rows.coulomb_impulse = coulomb;
  motion.omega_W += coulomb * rows.brake_share * rows.brake_angular;
  const double contact_velocity = hub_velocity + rows.x.mobility * impulse - radius_m * spin;
  rows.z_x_new = (state.bristle_x_m + dt_s * contact_velocity) / relax;
}

void solve_across(WheelRows& rows, Motion& motion, const WheelState& state, double stiffness,
                  double limit_impulse, double relax, double dt_s) {
  const double velocity = rows.y.velocity(motion) - rows.y.mobility * rows.y.impulse;
  const double impulse = std::clamp(
      bristle_impulse(stiffness, state.bristle_y_m, relax, velocity, rows.y.mobility, dt_s),
      -limit_impulse, limit_impulse);
  rows.y.apply(motion, impulse - rows.y.impulse);
  rows.z_y_new = (state.bristle_y_m + dt_s * (velocity + rows.y.mobility * impulse)) / relax;
}

// The soil's resistance to being rolled over pushes on the hub like dry friction.
void solve_soil(WheelRows& rows, Motion& motion) {
  const double velocity = rows.x.velocity(motion) - rows.x.mobility * rows.soil_impulse;
  const double impulse = std::clamp(-velocity / rows.x.mobility, -rows.soil_limit, rows.soil_limit);
  const double change = impulse - rows.soil_impulse;
  motion.add_impulse(change * rows.x.direction, change * rows.x.angular);
  rows.soil_impulse = impulse;
}

// The last step's forces: close to this one's, they save sweeps.
void start_from(const WheelState& state, double dt_s, WheelRows& row, Motion& motion) {
  row.x.apply(motion, dt_s * state.along_n);
  row.y.apply(motion, dt_s * state.across_n);
  row.soil_impulse = std::clamp(dt_s * state.soil_n, -row.soil_limit, row.soil_limit);
  motion.add_impulse(row.soil_impulse * row.x.direction, row.soil_impulse * row.x.angular);
  row.coulomb_impulse = dt_s * state.coulomb_nm;
  motion.omega_W += row.coulomb_impulse * row.brake_share * row.brake_angular;
}

// A tyre that is given one figure for rolling has it on any soil.
void roll_by(double rolling_resistance, Traction& traction) {
  traction.tyre_resistance = rolling_resistance;
  traction.soil_resistance = traction.soil_resistance_per_slip = 0.0;
}

// Slip ratio as defined for driving (over the wheel's speed) and braking (over the ground speed).
// Below kSlowest_mps it is taken over that speed: moving off winds the tyres up by millimetres,
// which over a speed near zero would read as wheel spin.
double slip_ratio(double hub_mps, double rim_mps) {
  constexpr double kSlowest_mps = 0.5;
  const double faster_mps = std::max({std::abs(hub_mps), std::abs(rim_mps), kSlowest_mps});
  return std::min(1.0, std::abs(rim_mps - hub_mps) / faster_mps);
}

}  // namespace

TyreResult solve_tyres(std::span<const WheelContact> contacts,
                       std::span<const WheelDefinition> wheels,
                       std::span<const WheelTorques> torques, const SoilMap& soil,
                       const ChassisMass& mass, const ChassisState& chassis,
                       const Eigen::Vector3d& v_W, const Eigen::Vector3d& omega_W, double dt_s,
                       std::span<WheelState> states, std::span<const BellyContact> belly) {
  Motion motion{
      v_W, omega_W, 1.0 / mass.mass_kg,
      chassis.R_WB * mass.inertia_kg_m2.cwiseInverse().asDiagonal() * chassis.R_WB.transpose()};
  PerWheel<WheelRows> rows;
  PerWheel<Traction> tractions;
  PerWheel<double> lateral_gammas{};
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const WheelContact& contact = contacts[i];
    const WheelDefinition& wheel = wheels[i];
    WheelRows& row = rows[i];
    row.x = ImpulseRow(motion, contact.hub_arm, contact.along);
    row.y = ImpulseRow(motion, contact.lateral_arm, contact.across);
    row.axle = contact.axle;
    row.brake_angular = -(motion.inverse_inertia_W * contact.axle);
    row.spin_free = states[i].spin_rad_per_s + dt_s * torques[i].drive_nm / wheel.inertia_kg_m2;
    const Soil& under = soil_at(soil, (chassis.p_WC + contact.hub_arm).head<2>());
    lateral_gammas[i] = under.lateral_gamma_rad;
    if (contact.load_n > 0.0) {
      tractions[i] = traction_on(under, wheel.tyre, contact.load_n, contact.deflection_m);
      if (wheel.rolling_resistance > 0.0) roll_by(wheel.rolling_resistance, tractions[i]);
    }
    const Traction& traction = tractions[i];
    const double rolling_nm = traction.tyre_resistance * contact.load_n * wheel.radius_m;
    const double slip = std::min(1.0, std::abs(states[i].bristle_x_m) / kRelaxationLength_m);
    row.soil_limit = dt_s * contact.load_n *
                     (traction.soil_resistance + traction.soil_resistance_per_slip * slip);
    const double coulomb_nm = rolling_nm + torques[i].brake_max_nm;
    row.coulomb_limit = dt_s * coulomb_nm;
    row.brake_share = coulomb_nm > 0.0 ? torques[i].brake_max_nm / coulomb_nm : 0.0;
    const double rim_mps = wheel.radius_m * states[i].spin_rad_per_s;
    // From the velocities before the step: the predicted ones contain gravity not yet held by the
    // tyres, and a braked vehicle would creep.
    const double hub_mps =
        row.x.direction.dot(point_velocity(chassis.v_W, chassis.omega_W, row.x.arm));
    const double across_mps =
        row.y.direction.dot(point_velocity(chassis.v_W, chassis.omega_W, row.y.arm));
    row.relax_speed_mps = std::max(
        {std::abs(rim_mps), std::abs(hub_mps), std::abs(hub_mps - rim_mps), std::abs(across_mps)});
    row.z_x_new = states[i].bristle_x_m;
    row.z_y_new = states[i].bristle_y_m;
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) start_from(states[i], dt_s, rows[i], motion);

  std::vector<BellyRows> belly_friction;
  for (const BellyContact& contact : belly) {
    belly_friction.push_back(belly_rows(contact, motion, dt_s));
  }

  for (int iteration = 0; iteration < kTyreIterations; ++iteration) {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      WheelRows& row = rows[i];
      const Bristle bristle =
          linearise(tractions[i], lateral_gammas[i], contacts[i].load_n, row.z_x_new, row.z_y_new);
      const double relax = relaxation(row, dt_s);
      const double limit = dt_s * tractions[i].full_pull * contacts[i].load_n;
      solve_along(row, motion, wheels[i], states[i], bristle.stiffness_x, limit, relax, dt_s);
      const double left_over =
          std::sqrt(std::max(0.0, limit * limit - row.x.impulse * row.x.impulse));
      solve_across(row, motion, states[i], bristle.stiffness_y, left_over, relax, dt_s);
      if (row.soil_limit > 0.0) solve_soil(row, motion);
    }
    for (BellyRows& contact : belly_friction) solve_belly(contact, motion);
  }

  TyreResult result;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    WheelRows& row = rows[i];
    WheelState& state = states[i];
    state.spin_rad_per_s =
        row.spin_free +
        (row.coulomb_impulse - wheels[i].radius_m * row.x.impulse) / wheels[i].inertia_kg_m2;
    state.angle_rad += dt_s * state.spin_rad_per_s;
    // From the velocities all rows ended up with, not those each row saw: otherwise the bristles
    // forget part of the motion and a braked vehicle creeps.
    const double contact_mps = row.x.velocity(motion) - wheels[i].radius_m * state.spin_rad_per_s;
    const double relax = relaxation(row, dt_s);
    state.bristle_x_m = (state.bristle_x_m + dt_s * contact_mps) / relax;
    state.bristle_y_m = (state.bristle_y_m + dt_s * row.y.velocity(motion)) / relax;
    // What of the contact's velocity does not go into the bristles.
    result.sliding_mps[i] = row.relax_speed_mps / kRelaxationLength_m *
                            Eigen::Vector2d(state.bristle_x_m, state.bristle_y_m).norm();
    state.along_n = result.along_n[i] = row.x.impulse / dt_s;
    state.across_n = result.across_n[i] = row.y.impulse / dt_s;
    state.soil_n = result.soil_n[i] = row.soil_impulse / dt_s;
    state.coulomb_nm = row.coulomb_impulse / dt_s;
    result.brake_nm[i] = row.brake_share * state.coulomb_nm;
    result.rolling_nm[i] = state.coulomb_nm - result.brake_nm[i];
    result.slip[i] = slip_ratio(row.x.velocity(motion), wheels[i].radius_m * state.spin_rad_per_s);
    const Eigen::Vector3d along = (result.along_n[i] + result.soil_n[i]) * row.x.direction;
    const Eigen::Vector3d across = result.across_n[i] * row.y.direction;
    result.force_W += along + across;
    result.torque_W +=
        row.x.arm.cross(along) + row.y.arm.cross(across) - result.brake_nm[i] * contacts[i].axle;
  }
  for (const BellyRows& contact : belly_friction) {
    const Eigen::Vector3d force_W = (contact.along.impulse * contact.along.direction +
                                     contact.across.impulse * contact.across.direction) /
                                    dt_s;
    result.belly_W.push_back(force_W);
    result.force_W += force_W;
    result.torque_W += contact.along.arm.cross(force_W);
  }
  return result;
}

}  // namespace headland
