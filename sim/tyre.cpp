#include "sim/tyre.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// What does not change while the impulses of a step are looked for: one tyre on its soil.
struct Grip {
  Traction traction;
  double load_n = 0.0;
  double u_per_x = 0.0;  // combined slip per deflection [1/m]
  double u_per_y = 0.0;
  double limit = 0.0;  // impulse of the full pull
};

// The tyre law linearised about the present deflection, times the step: impulse = -stiffness * z.
struct Bristle {
  double stiffness_x = 0.0;
  double stiffness_y = 0.0;
};

Bristle linearise(const Grip& grip, double z_x_m, double z_y_m, double dt_s) {
  // The secant's limit at no deflection is the initial slope, which this u is close enough to.
  constexpr double kSmall = 1e-9;
  const double u =
      std::max(Eigen::Vector2d(grip.u_per_x * z_x_m, grip.u_per_y * z_y_m).norm(), kSmall);
  const double strength = dt_s * grip.load_n * gross_pull(grip.traction, u) / u;
  return {strength * grip.u_per_x, strength * grip.u_per_y};
}

// Implicit bristle over one step: z+ = (z + dt v+) / relax, F = k (z+ + tau (z+ - z) / dt), and
// v+ = v_free + mobility p with p = -F dt. `held_m` is what F / k would be at v+ = 0, times relax.
struct BristleStep {
  double relax = 1.0;
  double per_relax = 1.0;
  double damped_s = 0.0;  // dt + tau
  double held_x_m = 0.0;
  double held_y_m = 0.0;
};

BristleStep bristle_step(double relax_speed_mps, const WheelState& state, double dt_s) {
  BristleStep step;
  step.relax = 1.0 + dt_s * relax_speed_mps / kRelaxationLength_m;
  step.per_relax = 1.0 / step.relax;
  step.damped_s = dt_s + kBristleDamping_s;
  const double held_share = (step.damped_s - kBristleDamping_s * step.relax) / dt_s;
  step.held_x_m = held_share * state.bristle_x_m;
  step.held_y_m = held_share * state.bristle_y_m;
  return step;
}

// Returns p for a stiffness times the step.
double bristle_impulse(const BristleStep& step, double stiffness, double held_m, double v_free,
                       double mobility) {
  return -stiffness * (held_m + step.damped_s * v_free) /
         (step.relax + stiffness * step.damped_s * mobility);
}

struct WheelRows {
  ImpulseRow x;
  ImpulseRow y;
  double coupling = 0.0;  // change of the velocity along y per unit impulse along x
  Grip grip;
  BristleStep step;
  Eigen::Vector3d axle;
  Eigen::Vector3d brake_angular;  // change of omega per unit brake impulse on the wheel
  double spin_per_impulse = 0.0;  // on the wheel about its axle
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

// Longitudinal force and spin together: rolling forwards, rolling backwards, or locked: by the
// brake to the chassis, by rolling resistance to the ground. From the hub's velocity without the
// row's impulse; returns by how much the impulse changed.
double solve_along(WheelRows& rows, double hub_mps, double locked_rad_per_s, double radius_m,
                   double z_m, double stiffness, double dt_s) {
  const double limit = rows.grip.limit;
  const double spin_per_impulse = radius_m * rows.spin_per_impulse;
  const auto rolling = [&](double coulomb) {
    const double spin = rows.spin_free + coulomb * rows.spin_per_impulse;
    return std::clamp(
        bristle_impulse(rows.step, stiffness, rows.step.held_x_m, hub_mps - radius_m * spin,
                        rows.x.mobility + radius_m * spin_per_impulse),
        -limit, limit);
  };
  const auto spin_after = [&](double coulomb, double impulse) {
    return rows.spin_free + coulomb * rows.spin_per_impulse - spin_per_impulse * impulse;
  };

  double coulomb = -rows.coulomb_limit;
  double impulse = rolling(coulomb);
  double spin = spin_after(coulomb, impulse);
  if (spin <= locked_rad_per_s) {
    coulomb = rows.coulomb_limit;
    impulse = rolling(coulomb);
    spin = spin_after(coulomb, impulse);
    if (spin >= locked_rad_per_s) {
      spin = locked_rad_per_s;
      impulse = std::clamp(bristle_impulse(rows.step, stiffness, rows.step.held_x_m,
                                           hub_mps - radius_m * spin, rows.x.mobility),
                           -limit, limit);
      coulomb = std::clamp((spin - rows.spin_free) / rows.spin_per_impulse + radius_m * impulse,
                           -rows.coulomb_limit, rows.coulomb_limit);
    }
  }
  rows.coulomb_impulse = coulomb;
  const double contact_mps = hub_mps + rows.x.mobility * impulse - radius_m * spin;
  rows.z_x_new = (z_m + dt_s * contact_mps) * rows.step.per_relax;
  const double change = impulse - rows.x.impulse;
  rows.x.impulse = impulse;
  return change;
}

// Likewise across, where the force along leaves `limit` of the grip.
double solve_across(WheelRows& rows, double hub_mps, double z_m, double stiffness, double limit,
                    double dt_s) {
  const double impulse = std::clamp(
      bristle_impulse(rows.step, stiffness, rows.step.held_y_m, hub_mps, rows.y.mobility), -limit,
      limit);
  rows.z_y_new = (z_m + dt_s * (hub_mps + rows.y.mobility * impulse)) * rows.step.per_relax;
  const double change = impulse - rows.y.impulse;
  rows.y.impulse = impulse;
  return change;
}

// The soil's resistance to being rolled over pushes on the hub like dry friction.
double solve_soil(WheelRows& rows, double hub_mps) {
  const double impulse = std::clamp(-hub_mps / rows.x.mobility, -rows.soil_limit, rows.soil_limit);
  const double change = impulse - rows.soil_impulse;
  rows.soil_impulse = impulse;
  return change;
}

// One sweep over a wheel: brake and force along, soil, force across. The velocities follow the
// impulses by the rows' couplings, so that the motion is read once and written once.
void solve_wheel(WheelRows& rows, double radius_m, const WheelState& state, double dt_s,
                 Motion& motion) {
  const Bristle bristle = linearise(rows.grip, rows.z_x_new, rows.z_y_new, dt_s);
  double locked_rad_per_s = 0.0;
  if (rows.brake_share > 0.0) {
    if (rows.brake_share > 0.5) locked_rad_per_s = motion.omega_W.dot(rows.axle);
    motion.omega_W -= rows.coulomb_impulse * rows.brake_share * rows.brake_angular;
  }
  const double along_mps = rows.x.velocity(motion);
  double across_mps = rows.y.velocity(motion);
  double along = solve_along(rows, along_mps - rows.x.mobility * rows.x.impulse, locked_rad_per_s,
                             radius_m, state.bristle_x_m, bristle.stiffness_x, dt_s);
  if (rows.soil_limit > 0.0) {
    along += solve_soil(rows, along_mps + rows.x.mobility * (along - rows.soil_impulse));
  }
  if (rows.brake_share > 0.0) {
    motion.omega_W += rows.coulomb_impulse * rows.brake_share * rows.brake_angular;
    across_mps = rows.y.velocity(motion);
  }
  const double left_over =
      std::sqrt(std::max(0.0, rows.grip.limit * rows.grip.limit - rows.x.impulse * rows.x.impulse));
  const double across =
      solve_across(rows, across_mps + rows.coupling * along - rows.y.mobility * rows.y.impulse,
                   state.bristle_y_m, bristle.stiffness_y, left_over, dt_s);
  motion.add_impulse(along * rows.x.direction + across * rows.y.direction,
                     along * rows.x.angular + across * rows.y.angular);
}

// The last step's forces: close to this one's, they save sweeps.
void start_from(const WheelState& state, double dt_s, WheelRows& row, Motion& motion) {
  row.x.impulse = dt_s * state.along_n;
  row.soil_impulse = std::clamp(dt_s * state.soil_n, -row.soil_limit, row.soil_limit);
  const double along = row.x.impulse + row.soil_impulse;
  motion.add_impulse(along * row.x.direction, along * row.x.angular);
  row.y.apply(motion, dt_s * state.across_n);
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

Grip grip_of(const Soil& soil, const WheelDefinition& wheel, const WheelContact& contact,
             double dt_s) {
  Grip grip;
  grip.load_n = contact.load_n;
  if (contact.load_n > 0.0) {
    grip.traction = traction_on(soil, wheel.tyre, contact.load_n, contact.deflection_m);
    if (wheel.rolling_resistance > 0.0) roll_by(wheel.rolling_resistance, grip.traction);
  }
  grip.u_per_x = grip.traction.slip_stiffness / kRelaxationLength_m;
  grip.u_per_y = 1.0 / (soil.lateral_gamma_rad * kRelaxationLength_m);
  grip.limit = dt_s * grip.traction.full_pull * contact.load_n;
  return grip;
}

// Rows of one wheel before any impulse.
void set_rows(const WheelContact& contact, const WheelDefinition& wheel,
              const WheelTorques& torques, const WheelState& state, const SoilMap& soil,
              const ChassisState& chassis, const Motion& motion, double dt_s, WheelRows& row) {
  row.x = ImpulseRow(motion, contact.hub_arm, contact.along);
  row.y = ImpulseRow(motion, contact.lateral_arm, contact.across);
  // The directions are at right angles: only turning couples them.
  row.coupling = row.y.moment.dot(row.x.angular);
  row.axle = contact.axle;
  row.brake_angular = -(motion.inverse_inertia_W * contact.axle);
  row.spin_per_impulse = 1.0 / wheel.inertia_kg_m2;
  row.spin_free = state.spin_rad_per_s + dt_s * torques.drive_nm * row.spin_per_impulse;
  row.grip =
      grip_of(soil_at(soil, (chassis.p_WC + contact.hub_arm).head<2>()), wheel, contact, dt_s);
  const Traction& traction = row.grip.traction;
  const double slip = std::min(1.0, std::abs(state.bristle_x_m) / kRelaxationLength_m);
  row.soil_limit =
      dt_s * contact.load_n * (traction.soil_resistance + traction.soil_resistance_per_slip * slip);
  const double coulomb_nm =
      traction.tyre_resistance * contact.load_n * wheel.radius_m + torques.brake_max_nm;
  row.coulomb_limit = dt_s * coulomb_nm;
  row.brake_share = coulomb_nm > 0.0 ? torques.brake_max_nm / coulomb_nm : 0.0;
  const double rim_mps = wheel.radius_m * state.spin_rad_per_s;
  // From the velocities before the step: the predicted ones contain gravity not yet held by the
  // tyres, and a braked vehicle would creep.
  const double hub_mps = row.x.velocity(chassis.v_W, chassis.omega_W);
  const double across_mps = row.y.velocity(chassis.v_W, chassis.omega_W);
  row.relax_speed_mps = std::max(
      {std::abs(rim_mps), std::abs(hub_mps), std::abs(hub_mps - rim_mps), std::abs(across_mps)});
  row.step = bristle_step(row.relax_speed_mps, state, dt_s);
  row.z_x_new = state.bristle_x_m;
  row.z_y_new = state.bristle_y_m;
}

// What wheel i did, and its state after the step.
void take_result(const WheelRows& row, const Motion& motion, const WheelDefinition& wheel,
                 std::size_t i, double dt_s, WheelState& state, TyreResult& result) {
  state.spin_rad_per_s =
      row.spin_free + (row.coulomb_impulse - wheel.radius_m * row.x.impulse) * row.spin_per_impulse;
  state.angle_rad += dt_s * state.spin_rad_per_s;
  // From the velocities all rows ended up with, not those each row saw: otherwise the bristles
  // forget part of the motion and a braked vehicle creeps.
  const double hub_mps = row.x.velocity(motion);
  const double rim_mps = wheel.radius_m * state.spin_rad_per_s;
  state.bristle_x_m = (state.bristle_x_m + dt_s * (hub_mps - rim_mps)) * row.step.per_relax;
  state.bristle_y_m = (state.bristle_y_m + dt_s * row.y.velocity(motion)) * row.step.per_relax;
  // What of the contact's velocity does not go into the bristles.
  result.sliding_mps[i] = row.relax_speed_mps / kRelaxationLength_m *
                          Eigen::Vector2d(state.bristle_x_m, state.bristle_y_m).norm();
  const double per_s = 1.0 / dt_s;
  state.along_n = result.along_n[i] = row.x.impulse * per_s;
  state.across_n = result.across_n[i] = row.y.impulse * per_s;
  state.soil_n = result.soil_n[i] = row.soil_impulse * per_s;
  state.coulomb_nm = row.coulomb_impulse * per_s;
  result.brake_nm[i] = row.brake_share * state.coulomb_nm;
  result.rolling_nm[i] = state.coulomb_nm - result.brake_nm[i];
  result.slip[i] = slip_ratio(hub_mps, rim_mps);
  const double along_n = state.along_n + state.soil_n;
  result.force_W += along_n * row.x.direction + state.across_n * row.y.direction;
  result.torque_W +=
      along_n * row.x.moment + state.across_n * row.y.moment - result.brake_nm[i] * row.axle;
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
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    set_rows(contacts[i], wheels[i], torques[i], states[i], soil, chassis, motion, dt_s, rows[i]);
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) start_from(states[i], dt_s, rows[i], motion);

  std::vector<BellyRows> belly_friction;
  for (const BellyContact& contact : belly) {
    belly_friction.push_back(belly_rows(contact, motion, dt_s));
  }

  for (int iteration = 0; iteration < kTyreIterations; ++iteration) {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      solve_wheel(rows[i], wheels[i].radius_m, states[i], dt_s, motion);
    }
    for (BellyRows& contact : belly_friction) solve_belly(contact, motion);
  }

  TyreResult result;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    take_result(rows[i], motion, wheels[i], i, dt_s, states[i], result);
  }
  for (const BellyRows& contact : belly_friction) {
    const double along_n = contact.along.impulse / dt_s;
    const double across_n = contact.across.impulse / dt_s;
    const Eigen::Vector3d force_W =
        along_n * contact.along.direction + across_n * contact.across.direction;
    result.belly_W.push_back(force_W);
    result.force_W += force_W;
    result.torque_W += along_n * contact.along.moment + across_n * contact.across.moment;
  }
  return result;
}

}  // namespace headland
