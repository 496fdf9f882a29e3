#include "sim/drivetrain.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// Torque against a slower motion than this drives and does not brake: a vehicle held by the soil
// that has sunk back by a hair must still be able to move off.
constexpr double kNoMotion_mps = 0.02;

// Largest torque in the direction of rotation whose input power is at most `available_w`.
double torque_for_power(const Motor& motor, double speed_rad_per_s, double available_w) {
  const double speed = std::abs(speed_rad_per_s);
  const double spare_w = available_w - motor_loss_w(motor, 0.0, speed);
  if (spare_w <= 0.0) return 0.0;
  const double kc = motor.copper_loss_kc;
  // kc T^2 + w T = spare, in the form that holds for kc = 0 and for w = 0.
  const double root = speed + std::sqrt(speed * speed + 4.0 * kc * spare_w);
  return root > 0.0 ? 2.0 * spare_w / root : motor.max_torque_nm;
}

template <typename T>
using PerAxle = std::array<T, 2>;

// Of the loads on a side's wheels that have motors; equal where none carries any.
PerAxle<double> load_shares(const MotorLayout& layout, const PerWheel<WheelContact>& contacts,
                            std::size_t side) {
  PerAxle<double> share{};
  double sum = 0.0;
  for (const bool by_load : {true, false}) {
    for (const std::size_t axle : {0U, 1U}) {
      const std::size_t wheel = 2 * axle + side;
      if (layout.motor_of[wheel] >= 0) share[axle] = by_load ? contacts[wheel].load_n : 1.0;
    }
    sum = share[0] + share[1];
    if (sum > 0.0) break;
  }
  return {share[0] / sum, share[1] / sum};
}

// A force by shares; what is beyond an axle's room goes to the other one as far as it has room.
PerAxle<double> share_out(double wanted_n, const PerAxle<double>& share,
                          const PerAxle<double>& room_n) {
  PerAxle<double> given_n{};
  double rest_n = wanted_n;
  for (const std::size_t axle : {0U, 1U}) {
    given_n[axle] = std::clamp(wanted_n * share[axle], -room_n[axle], room_n[axle]);
    rest_n -= given_n[axle];
  }
  for (const std::size_t axle : {0U, 1U}) {
    const double before_n = given_n[axle];
    given_n[axle] = std::clamp(before_n + rest_n, -room_n[axle], room_n[axle]);
    rest_n -= given_n[axle] - before_n;
  }
  return given_n;
}

}  // namespace

double motor_loss_w(const Motor& motor, double torque_nm, double speed_rad_per_s) {
  const double speed = std::abs(speed_rad_per_s);
  return motor.copper_loss_kc * torque_nm * torque_nm + motor.iron_loss_ki * speed +
         motor.windage_loss_kw * speed * speed * speed + motor.constant_loss_w;
}

MotorTorque limit_motor(const Motor& motor, double wanted_nm, double speed_rad_per_s,
                        double available_w, double acceptable_w) {
  const double speed = std::abs(speed_rad_per_s);
  double limit_nm = motor.max_torque_nm;
  if (speed * limit_nm > motor.max_power_w) limit_nm = motor.max_power_w / speed;
  const bool motoring = wanted_nm * speed_rad_per_s >= 0.0;
  if (motoring) {
    if (speed > motor.max_speed_rad_per_s) limit_nm = 0.0;
    limit_nm = std::min(limit_nm, torque_for_power(motor, speed, available_w));
  } else {
    // Shaft power w T comes in, less the losses; bounding the shaft power bounds what is charged.
    limit_nm = std::min(limit_nm, acceptable_w / speed);
  }
  const double torque_nm = std::clamp(wanted_nm, -limit_nm, limit_nm);
  return {torque_nm, torque_nm != wanted_nm};
}

MotorLayout motor_layout(const Vehicle& vehicle) {
  MotorLayout layout;
  const bool per_wheel = vehicle.drivetrain.motor_per_wheel;
  for (int i = 0; i < kWheels; ++i) {
    const bool driven = (i < 2 ? vehicle.rear : vehicle.front).driven;
    layout.motor_of[static_cast<std::size_t>(i)] = !driven ? -1 : per_wheel ? layout.motors++ : 0;
  }
  if (!per_wheel) layout.motors = 1;
  return layout;
}

PerMotor<double> motor_speeds(const MotorLayout& layout, const PerWheel<double>& relative_spin,
                              double gear_ratio) {
  PerMotor<double> speed_rad_per_s{};
  PerMotor<int> wheels{};
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (layout.motor_of[i] < 0) continue;
    const auto m = static_cast<std::size_t>(layout.motor_of[i]);
    speed_rad_per_s[m] += gear_ratio * relative_spin[i];
    ++wheels[m];
  }
  for (std::size_t m = 0; m < kWheels; ++m) {
    if (wheels[m] > 0) speed_rad_per_s[m] /= wheels[m];
  }
  return speed_rad_per_s;
}

PerMotor<double> split_torque(const Vehicle& vehicle, const MotorLayout& layout,
                              const PerWheel<WheelContact>& contacts, double total_nm,
                              double yaw_torque_nm) {
  PerMotor<double> torque_nm{};
  if (!vehicle.drivetrain.motor_per_wheel) {
    torque_nm[0] = total_nm;
    return torque_nm;
  }
  const double most_nm =
      vehicle.motor.max_torque_nm * vehicle.drivetrain.gear_ratio * vehicle.drivetrain.efficiency;
  const double onward_n =
      0.5 * total_nm / (vehicle.rear.driven ? vehicle.rear : vehicle.front).radius_m;
  for (const std::size_t side : {0U, 1U}) {
    const PerAxle<double> share = load_shares(layout, contacts, side);
    const PerAxle<double> radius_m{vehicle.rear.radius_m, vehicle.front.radius_m};
    PerAxle<double> room_n{};
    for (const std::size_t axle : {0U, 1U}) {
      if (share[axle] > 0.0) room_n[axle] = most_nm / radius_m[axle];
    }
    // Headway comes first: a vehicle that scrubs on the spot turns easier once it moves.
    const PerAxle<double> given_n = share_out(onward_n, share, room_n);
    const double beyond_n = onward_n - given_n[0] - given_n[1];
    for (const std::size_t axle : {0U, 1U}) room_n[axle] -= std::abs(given_n[axle]);
    const double couple_n =
        yaw_torque_nm / (share[0] * vehicle.rear.track_m + share[1] * vehicle.front.track_m);
    const PerAxle<double> turning_n = share_out(side == 0 ? -couple_n : couple_n, share, room_n);
    for (const std::size_t axle : {0U, 1U}) {
      const int motor = layout.motor_of[2 * axle + side];
      if (motor < 0) continue;
      // What no motor can give is asked for all the same, and counted where it is cut off.
      torque_nm[static_cast<std::size_t>(motor)] =
          radius_m[axle] * (given_n[axle] + turning_n[axle] + share[axle] * beyond_n);
    }
  }
  return torque_nm;
}

void limit_slip(const Vehicle& vehicle, const MotorLayout& layout,
                const PerWheel<WheelDefinition>& wheels, const PerWheel<WheelContact>& contacts,
                const PerWheel<WheelState>& states, const ChassisState& chassis,
                PerMotor<double>& wheel_torque_nm) {
  if (!vehicle.drivetrain.motor_per_wheel) return;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (layout.motor_of[i] < 0) continue;
    const double rim_mps = wheels[i].radius_m * states[i].spin_rad_per_s;
    const Eigen::Vector3d v_W = point_velocity(chassis.v_W, chassis.omega_W, contacts[i].hub_arm);
    const double hub_mps = contacts[i].along.dot(v_W);
    const double sliding_mps = std::abs(contacts[i].across.dot(v_W));
    const double free_mps =
        std::max({kFreeSlip * std::abs(hub_mps), kFreeSlipSpeed_mps, kScrubbingSlip * sliding_mps});
    const double slip_mps = rim_mps - hub_mps;
    const double beyond_mps = slip_mps - std::clamp(slip_mps, -free_mps, free_mps);
    wheel_torque_nm[static_cast<std::size_t>(layout.motor_of[i])] -=
        kSlipGain_per_s * wheels[i].inertia_kg_m2 * beyond_mps / wheels[i].radius_m;
  }
}

DrivetrainCommand command_drive(const Vehicle& vehicle, const MotorLayout& layout,
                                const PerWheel<WheelContact>& contacts,
                                const DriveRequest& request) {
  const Drivetrain& drivetrain = vehicle.drivetrain;
  DrivetrainCommand command;
  double load_n = 0.0;
  for (const WheelContact& contact : contacts) load_n += contact.load_n;
  const auto brake_all = [&](double brake_nm) {
    for (std::size_t i = 0; i < kWheels; ++i) {
      command.wheels[i].brake_max_nm +=
          load_n > 0.0 ? brake_nm * contacts[i].load_n / load_n : brake_nm / kWheels;
    }
  };
  if (request.hold) {
    brake_all(drivetrain.brake_torque_max_nm);
    return command;
  }
  for (int m = 0; m < layout.motors; ++m) {
    const auto motor_index = static_cast<std::size_t>(m);
    const double wanted_nm = request.wheel_torque_nm[motor_index];
    const double speed_rad_per_s = request.motor_speed_rad_per_s[motor_index];
    const auto wheel = std::find(layout.motor_of.begin(), layout.motor_of.end(), m);
    const Axle& axle = wheel - layout.motor_of.begin() < 2 ? vehicle.rear : vehicle.front;
    const double moving_mps = drivetrain.motor_per_wheel
                                  ? axle.radius_m * speed_rad_per_s / drivetrain.gear_ratio
                                  : request.speed_mps;
    const bool against = wanted_nm * moving_mps < 0.0 && std::abs(moving_mps) > kNoMotion_mps;
    const bool braking = against && wanted_nm * request.direction <= 0.0;
    double to_motor_nm = wanted_nm;
    if (braking) {
      const bool regenerates =
          std::abs(request.speed_mps) >= vehicle.motor.regeneration_min_speed_mps;
      to_motor_nm *= regenerates ? vehicle.motor.regeneration_fraction : 0.0;
    }
    const double through_gear =
        to_motor_nm * speed_rad_per_s >= 0.0 ? drivetrain.efficiency : 1.0 / drivetrain.efficiency;
    const MotorTorque motor = limit_motor(
        vehicle.motor, to_motor_nm / (drivetrain.gear_ratio * through_gear), speed_rad_per_s,
        request.available_w / layout.motors, request.acceptable_w / layout.motors);
    command.motor_nm[motor_index] = motor.torque_nm;
    const double driven_nm = motor.torque_nm * drivetrain.gear_ratio * through_gear;
    if (!against) command.clipped = command.clipped || motor.clipped;
    const double brake_nm = against ? std::min(std::abs(wanted_nm - driven_nm),
                                               drivetrain.brake_torque_max_nm / layout.motors)
                                    : 0.0;
    const auto wheels = std::count(layout.motor_of.begin(), layout.motor_of.end(), m);
    for (std::size_t i = 0; i < kWheels; ++i) {
      if (layout.motor_of[i] != m) continue;
      command.wheels[i].drive_nm = driven_nm / static_cast<double>(wheels);
      if (drivetrain.motor_per_wheel) command.wheels[i].brake_max_nm = brake_nm;
    }
    if (!drivetrain.motor_per_wheel) brake_all(brake_nm);
  }
  return command;
}

}  // namespace headland
