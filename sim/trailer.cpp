#include "sim/trailer.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "planner/arcs.h"
#include "vehicle_models/draft.h"

namespace headland {
namespace {

// Velocity of a body's point per unit impulse there: (1 / m) 1 - [r]x I^-1 [r]x, in the body.
Eigen::Matrix3d mobility_at(const ChassisMass& mass, const Eigen::Vector3d& arm) {
  Eigen::Matrix3d cross;
  cross << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
  const Eigen::Matrix3d inverse_inertia = mass.inertia_kg_m2.cwiseInverse().asDiagonal();
  return Eigen::Matrix3d::Identity() / mass.mass_kg - cross * inverse_inertia * cross;
}

double most_mobile(const ChassisMass& mass, const Eigen::Vector3d& arm) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mobility_at(mass, arm),
                                                        Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// An even rectangle of working width and drawbar length.
ChassisMass trailer_mass(const Implement& implement, const Trailing& trailing) {
  const double width_m = implement.working_width_m;
  const double length_m = trailing.drawbar_length_m;
  ChassisMass mass;
  mass.mass_kg = implement.mass_kg;
  mass.com_B = {trailing.com_ahead_m, 0.0, implement.com_height_m};
  const double roll_kg_m2 = implement.mass_kg * width_m * width_m / 12.0;
  const double pitch_kg_m2 = implement.mass_kg * length_m * length_m / 12.0;
  mass.inertia_kg_m2 = {roll_kg_m2, pitch_kg_m2, roll_kg_m2 + pitch_kg_m2};
  return mass;
}

WheelDefinition trailer_wheel(const Trailing& trailing, const ChassisMass& mass, bool left,
                              double load_n) {
  const double y_m = (left ? 0.5 : -0.5) * trailing.track_m;
  const double sag_m = load_n / trailing.vertical_stiffness_n_per_m;
  WheelDefinition wheel;
  wheel.hub_C = Eigen::Vector3d(0.0, y_m, trailing.wheel_radius_m) - mass.com_B;
  wheel.radius_m = trailing.wheel_radius_m;
  wheel.free_radius_m = trailing.wheel_radius_m + sag_m;
  wheel.tyre = {trailing.wheel_width_m, 2.0 * wheel.free_radius_m, trailing.section_height_m};
  wheel.inertia_kg_m2 = trailing.wheel_inertia_kg_m2;
  wheel.stiffness_n_per_m = trailing.vertical_stiffness_n_per_m;
  wheel.damping_n_s_per_m = trailing.vertical_damping_n_s_per_m;
  wheel.p_B = {0.0, y_m};
  wheel.partner = left ? 1 : 0;
  wheel.rolling_resistance = trailing.rolling_resistance;
  return wheel;
}

}  // namespace

std::optional<Trailer> make_trailer(const Vehicle& vehicle, const ChassisMass& vehicle_mass) {
  const Implement& implement = vehicle.implement;
  if (!implement.trailing) return std::nullopt;
  const Trailing& trailing = *implement.trailing;
  Trailer trailer;
  trailer.mass = trailer_mass(implement, trailing);
  const double wheel_load_n = 0.5 * (trailer.mass.mass_kg * kGravity_mps2 - hitch_load_n(vehicle));
  for (std::size_t i = 0; i < kTrailerWheels; ++i) {
    trailer.wheels[i] = trailer_wheel(trailing, trailer.mass, i == 0, wheel_load_n);
  }
  trailer.pin_on_vehicle_C =
      Eigen::Vector3d(trailing.hitch_x_B_m, 0.0, trailing.hitch_height_m) - vehicle_mass.com_B;
  trailer.pin_C =
      Eigen::Vector3d(trailing.drawbar_length_m, 0.0, trailing.hitch_height_m) - trailer.mass.com_B;
  const double axle_x_B_m = trailing.hitch_x_B_m - trailing.drawbar_length_m;
  trailer.tool_C = Eigen::Vector3d(implement.x_B_m - axle_x_B_m, 0.0, implement.draft_height_m) -
                   trailer.mass.com_B;
  trailer.pin_mass_kg = 1.0 / (most_mobile(vehicle_mass, trailer.pin_on_vehicle_C) +
                               most_mobile(trailer.mass, trailer.pin_C));
  return trailer;
}

ChassisState place_trailer(const Trailer& trailer, const Heightfield& terrain,
                           const ChassisState& vehicle) {
  const Eigen::Vector3d pin_W = vehicle.p_WC + vehicle.R_WB * trailer.pin_on_vehicle_C;
  ChassisState state;
  state.R_WB = vehicle.R_WB;
  // The pin's height and the ground under the axle fix the pitch, which moves the axle: a few
  // rounds settle it to well below a tyre's sag.
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector3d com_W = pin_W - state.R_WB * trailer.pin_C;
    std::array<Eigen::Vector3d, kTrailerWheels> foot;
    for (std::size_t i = 0; i < kTrailerWheels; ++i) {
      foot[i] = com_W + state.R_WB * (trailer.wheels[i].hub_C -
                                      trailer.wheels[i].radius_m * Eigen::Vector3d::UnitZ());
      foot[i].z() = surface_at(terrain, foot[i].x(), foot[i].y()).height_m;
    }
    const double pin_height_m = trailer.pin_C.z() + trailer.mass.com_B.z();
    const Eigen::Vector3d below_pin_W = pin_W - pin_height_m * state.R_WB.col(2);
    const Eigen::Vector3d x_axis = (below_pin_W - 0.5 * (foot[0] + foot[1])).normalized();
    const Eigen::Vector3d z_axis = x_axis.cross(foot[0] - foot[1]).normalized();
    state.R_WB.col(0) = x_axis;
    state.R_WB.col(1) = z_axis.cross(x_axis);
    state.R_WB.col(2) = z_axis;
  }
  state.p_WC = pin_W - state.R_WB * trailer.pin_C;
  return state;
}

double hitch_angle_rad(const ChassisState& vehicle, const ChassisState& trailer) {
  return wrap_angle(yaw_pitch_roll(trailer.R_WB).x() - yaw_pitch_roll(vehicle.R_WB).x());
}

PinForce pin_force(const Trailer& trailer, const ChassisState& vehicle, const ChassisState& state,
                   double dt_s) {
  const double rate_rad_per_s = kPinAnglePerStep_rad / dt_s;
  const double stiffness_n_per_m = trailer.pin_mass_kg * rate_rad_per_s * rate_rad_per_s;
  const double damping_n_s_per_m = 2.0 * kPinDamping * trailer.pin_mass_kg * rate_rad_per_s;
  PinForce pin;
  pin.vehicle_arm = vehicle.R_WB * trailer.pin_on_vehicle_C;
  pin.trailer_arm = state.R_WB * trailer.pin_C;
  const Eigen::Vector3d apart_W = state.p_WC + pin.trailer_arm - vehicle.p_WC - pin.vehicle_arm;
  const Eigen::Vector3d parting_W = point_velocity(state.v_W, state.omega_W, pin.trailer_arm) -
                                    point_velocity(vehicle.v_W, vehicle.omega_W, pin.vehicle_arm);
  pin.damping_W = damping_n_s_per_m * parting_W;
  pin.force_W = stiffness_n_per_m * apart_W + pin.damping_W;
  pin.spring_j = 0.5 * stiffness_n_per_m * apart_W.squaredNorm();
  return pin;
}

double draft_now_n(const Implement& implement, const Soil& under, double speed_mps,
                   double lowered) {
  return draft_n(implement, under.texture, speed_mps) * lowered *
         std::clamp(speed_mps / kDraftFullSpeed_mps, -1.0, 1.0);
}

TrailerStep pull_trailer(const Trailer& trailer, const Implement& implement,
                         const Heightfield& terrain, const SoilMap& soil,
                         const ChassisState& vehicle, const ChassisState& state, double lowered,
                         double dt_s, PerWheel<WheelState>& wheels) {
  TrailerStep step;
  step.before = state;
  step.contacts = touch_ground(terrain, state, trailer.own_wheels(), 0.0);
  step.pin = pin_force(trailer, vehicle, state, dt_s);
  step.stored = trailer_energy(trailer, state, wheels, step.contacts, step.pin);

  Load load;
  for (std::size_t i = 0; i < kTrailerWheels; ++i) {
    load.add(step.contacts[i].load_n * step.contacts[i].normal, step.contacts[i].normal_arm);
    step.spin_before[i] = wheels[i].spin_rad_per_s;
  }
  load.add(-step.pin.force_W, step.pin.trailer_arm);
  step.draft_arm = state.R_WB * trailer.tool_C;
  const Eigen::Vector3d x_axis = state.R_WB.col(0);
  step.draft_n =
      draft_now_n(implement, soil_at(soil, (state.p_WC + step.draft_arm).head<2>()),
                  x_axis.dot(point_velocity(state.v_W, state.omega_W, step.draft_arm)), lowered);
  step.draft_W = -step.draft_n * x_axis;
  load.add(step.draft_W, step.draft_arm);

  const Velocities free = velocities_after(state, trailer.mass, load, dt_s);
  const PerWheel<WheelTorques> no_torques{};
  step.tyres = solve_tyres(
      std::span<const WheelContact>(step.contacts).first(kTrailerWheels), trailer.own_wheels(),
      std::span<const WheelTorques>(no_torques).first(kTrailerWheels), soil, trailer.mass, state,
      free.v_W, free.omega_W, dt_s, std::span(wheels).first(kTrailerWheels));
  step.load = {load.force_W + step.tyres.force_W, load.torque_W + step.tyres.torque_W};
  return step;
}

StoredEnergy trailer_energy(const Trailer& trailer, const ChassisState& state,
                            const PerWheel<WheelState>& wheels,
                            const PerWheel<WheelContact>& contacts, const PinForce& pin) {
  StoredEnergy stored = stored_energy(trailer.mass, state, trailer.own_wheels(), wheels, contacts);
  stored.spring_j += pin.spring_j;
  return stored;
}

void charge_trailer(const Trailer& trailer, const TrailerStep& step, const ChassisState& after,
                    const PerWheel<WheelState>& wheels, const ChassisState& vehicle_before,
                    const ChassisState& vehicle_after, CauseLosses& cause_w) {
  charge_wheels({step.before, after, trailer.own_wheels(), step.contacts, step.spin_before, wheels,
                 step.tyres},
                cause_w);
  cause_w[static_cast<std::size_t>(EnergyCause::kDraft)] +=
      power_taken_w(step.draft_W, step.draft_arm, step.before, after);
  cause_w[static_cast<std::size_t>(EnergyCause::kSuspension)] +=
      power_taken_w(step.pin.damping_W, step.pin.vehicle_arm, vehicle_before, vehicle_after) -
      power_taken_w(step.pin.damping_W, step.pin.trailer_arm, step.before, after);
}

}  // namespace headland
