#include "sim/drivetrain.h"

#include <gtest/gtest.h>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kPlenty_w = 1e9;

Motor small_motor() {
  Motor motor;
  motor.max_torque_nm = 20.0;
  motor.max_power_w = 2000.0;
  motor.max_speed_rad_per_s = 250.0;
  motor.copper_loss_kc = 1.5;
  motor.iron_loss_ki = 0.1;
  motor.windage_loss_kw = 1e-5;
  motor.constant_loss_w = 20.0;
  return motor;
}

TEST(Motor, LossesFollowLarminieAndLowry) {
  // 1.5 x 100 + 0.1 x 100 + 1e-5 x 1e6 + 20 = 190 W
  EXPECT_NEAR(motor_loss_w(small_motor(), 10.0, 100.0), 190.0, 1e-9);
  EXPECT_EQ(motor_loss_w(small_motor(), 10.0, 100.0), motor_loss_w(small_motor(), -10.0, -100.0));
}

TEST(Motor, TorquePowerAndSpeedLimitsClip) {
  const Motor motor = small_motor();
  EXPECT_EQ(limit_motor(motor, 15.0, 50.0, kPlenty_w, kPlenty_w).torque_nm, 15.0);
  EXPECT_FALSE(limit_motor(motor, 15.0, 50.0, kPlenty_w, kPlenty_w).clipped);
  EXPECT_EQ(limit_motor(motor, 30.0, 50.0, kPlenty_w, kPlenty_w).torque_nm, 20.0);
  EXPECT_NEAR(limit_motor(motor, 20.0, 200.0, kPlenty_w, kPlenty_w).torque_nm, 10.0, 1e-9);
  EXPECT_EQ(limit_motor(motor, 20.0, 260.0, kPlenty_w, kPlenty_w).torque_nm, 0.0);
  EXPECT_TRUE(limit_motor(motor, 20.0, 260.0, kPlenty_w, kPlenty_w).clipped);
}

TEST(Motor, BatteryLimitGivesTheTorqueThatUsesAllOfIt) {
  const Motor motor = small_motor();
  constexpr double kAvailable_w = 900.0;
  const MotorTorque torque = limit_motor(motor, 20.0, 100.0, kAvailable_w, kPlenty_w);
  EXPECT_TRUE(torque.clipped);
  EXPECT_NEAR(torque.torque_nm * 100.0 + motor_loss_w(motor, torque.torque_nm, 100.0), kAvailable_w,
              1e-9);
  EXPECT_EQ(limit_motor(motor, 20.0, 100.0, 10.0, kPlenty_w).torque_nm, 0.0);
}

TEST(Motor, ChargeLimitBoundsTheRegeneratedPower) {
  const MotorTorque torque = limit_motor(small_motor(), -15.0, 100.0, kPlenty_w, 300.0);
  EXPECT_NEAR(torque.torque_nm, -3.0, 1e-12);
}

struct Rig {
  Vehicle vehicle = load_vehicle("transplanter");
  PerWheel<WheelDefinition> wheels = define_wheels(vehicle, chassis_mass(vehicle));
  PerWheel<WheelContact> contacts;
  Rig() {
    for (WheelContact& contact : contacts) contact.load_n = 1000.0;
    contacts[0].load_n = 3000.0;
  }
  DrivetrainCommand command(double wanted_nm, double speed_mps, double yaw_torque_nm = 0.0,
                            double direction = 0.0) const {
    const MotorLayout layout = motor_layout(vehicle);
    DriveRequest request;
    request.wheel_torque_nm = split_torque(vehicle, layout, contacts, wanted_nm, yaw_torque_nm);
    request.speed_mps = speed_mps;
    request.direction = direction;
    request.motor_speed_rad_per_s.fill(vehicle.drivetrain.gear_ratio * speed_mps /
                                       wheels[0].radius_m);
    request.available_w = request.acceptable_w = kPlenty_w;
    return command_drive(vehicle, layout, contacts, request);
  }
};

TEST(Drivetrain, DrivingSplitsTheWantedTorqueEvenly) {
  const Rig rig;
  const DrivetrainCommand command = rig.command(400.0, 0.8);
  EXPECT_NEAR(command.wheels[0].drive_nm, 200.0, 1e-9);
  EXPECT_EQ(command.wheels[0].drive_nm, command.wheels[1].drive_nm);
  EXPECT_EQ(command.wheels[2].drive_nm, 0.0);
  EXPECT_EQ(command.wheels[0].brake_max_nm, 0.0);
  const Drivetrain& gear = rig.vehicle.drivetrain;
  EXPECT_NEAR(command.motor_nm[0], 400.0 / (gear.gear_ratio * gear.efficiency), 1e-9);
}

TEST(Drivetrain, BrakingWithoutRegenerationIsAllFrictionByWheelLoad) {
  Rig rig;
  rig.vehicle.motor.regeneration_fraction = 0.0;
  const DrivetrainCommand command = rig.command(-300.0, 0.8);
  EXPECT_EQ(command.motor_nm[0], 0.0);
  EXPECT_NEAR(command.wheels[0].brake_max_nm, 150.0, 1e-9);
  EXPECT_NEAR(command.wheels[3].brake_max_nm, 50.0, 1e-9);
}

TEST(Drivetrain, RegenerationTakesItsShareAboveTheLeastSpeed) {
  Rig rig;
  rig.vehicle.motor.regeneration_fraction = 0.6;
  rig.vehicle.motor.regeneration_min_speed_mps = 0.5;
  const DrivetrainCommand fast = rig.command(-300.0, 0.8);
  EXPECT_NEAR(fast.wheels[0].drive_nm + fast.wheels[1].drive_nm, -180.0, 1e-9);
  double friction_nm = 0.0;
  for (const WheelTorques& wheel : fast.wheels) friction_nm += wheel.brake_max_nm;
  EXPECT_NEAR(friction_nm, 120.0, 1e-9);
  EXPECT_EQ(rig.command(-300.0, 0.4).motor_nm[0], 0.0);
}

// Soil holds a standing vehicle, at a speed of either sign that is nothing but rounding.
TEST(Drivetrain, DrivesAVehicleThatHasSunkBackByAHair) {
  const Rig rig;
  EXPECT_NEAR(rig.command(400.0, -1e-9).wheels[0].drive_nm, 200.0, 1e-6);
  EXPECT_EQ(rig.command(400.0, -1e-9).wheels[0].brake_max_nm, 0.0);
  EXPECT_GT(rig.command(400.0, -0.1).wheels[0].brake_max_nm, 0.0);
}

// Torque in the direction that is meant drives whichever way the vehicle still rolls, as a motor
// does that pulls away on a slope; the same torque against that direction brakes.
TEST(Drivetrain, PullsAwayWhileItRollsBack) {
  const Rig rig;
  const DrivetrainCommand uphill = rig.command(400.0, -0.1, 0.0, 1.0);
  EXPECT_NEAR(uphill.wheels[0].drive_nm, 200.0, 1e-6);
  EXPECT_EQ(uphill.wheels[0].brake_max_nm, 0.0);
  EXPECT_GT(uphill.motor_nm[0], 0.0);
  const DrivetrainCommand braked = rig.command(400.0, -0.1, 0.0, -1.0);
  EXPECT_EQ(braked.wheels[0].drive_nm, 0.0);
  EXPECT_GT(braked.wheels[0].brake_max_nm, 0.0);
}

// Only beyond what tyres need to pull, in proportion, and only where wheels have motors of their
// own.
TEST(Drivetrain, HoldsSpinningWheelsBack) {
  Rig rig;
  rig.vehicle.drivetrain.motor_per_wheel = true;
  rig.vehicle.front.driven = rig.vehicle.rear.driven = true;
  const MotorLayout layout = motor_layout(rig.vehicle);
  ChassisState chassis;
  chassis.v_W = {2.0, 0.0, 0.0};
  PerWheel<WheelState> states;
  constexpr PerWheel<double> kRim_mps{2.0, 2.29, 2.4, 1.6};  // free: 2.0 +- 0.3
  for (std::size_t i = 0; i < kWheels; ++i) {
    states[i].spin_rad_per_s = kRim_mps[i] / rig.wheels[i].radius_m;
  }
  PerMotor<double> torque_nm{};
  limit_slip(rig.vehicle, layout, rig.wheels, rig.contacts, states, chassis, torque_nm);
  const auto held_nm = [&](std::size_t wheel, double beyond_mps) {
    const WheelDefinition& w = rig.wheels[wheel];
    return -kSlipGain_per_s * w.inertia_kg_m2 * beyond_mps / w.radius_m;
  };
  EXPECT_EQ(torque_nm[0], 0.0);
  EXPECT_EQ(torque_nm[1], 0.0);
  EXPECT_NEAR(torque_nm[2], held_nm(2, 0.1), 1e-9);
  EXPECT_NEAR(torque_nm[3], held_nm(3, -0.1), 1e-9);
  // Dragged sideways at 0.19 m/s they may slip by twice as much.
  chassis.v_W.y() = -0.19;
  torque_nm.fill(0.0);
  limit_slip(rig.vehicle, layout, rig.wheels, rig.contacts, states, chassis, torque_nm);
  EXPECT_NEAR(torque_nm[2], held_nm(2, 0.02), 1e-9);
  EXPECT_NEAR(torque_nm[3], held_nm(3, -0.02), 1e-9);
  rig.vehicle.drivetrain.motor_per_wheel = false;
  torque_nm.fill(7.0);
  limit_slip(rig.vehicle, motor_layout(rig.vehicle), rig.wheels, rig.contacts, states, chassis,
             torque_nm);
  EXPECT_EQ(torque_nm[0], 7.0);
}

// A couple about z comes from the wheels' forward forces, right minus left, at half the track.
TEST(Drivetrain, MotorsAtTheWheelsTurnTheVehicle) {
  Rig rig;
  rig.vehicle.drivetrain.motor_per_wheel = true;
  rig.vehicle.front.driven = rig.vehicle.rear.driven = true;
  rig.vehicle.motor.max_torque_nm = 1e3;
  rig.vehicle.motor.max_power_w = 1e6;
  const DrivetrainCommand command = rig.command(100.0, 0.8, 240.0);
  double total_n = 0.0;
  double couple_nm = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const double drive_nm = command.wheels[i].drive_nm;
    // The wheels that run against the wish of their motor also brake.
    const double brake_nm = drive_nm <= 0.0 ? command.wheels[i].brake_max_nm : 0.0;
    total_n += (drive_nm - brake_nm) / rig.wheels[i].radius_m;
    couple_nm -= (drive_nm - brake_nm) / rig.wheels[i].radius_m * rig.wheels[i].p_B.y();
  }
  EXPECT_NEAR(total_n, 100.0 / rig.vehicle.rear.radius_m, 1e-9);
  EXPECT_NEAR(couple_nm, 240.0, 1e-9);
}

// Contacts of the rig carry 3000, 1000, 1000 and 1000 N: the left side shares 3 to 1, until the
// rear motor is at its limit and the front one takes the rest.
TEST(Drivetrain, MotorsOfOneSideShareByLoadAndFillInForEachOther) {
  Rig rig;
  rig.vehicle.drivetrain.motor_per_wheel = true;
  rig.vehicle.front.driven = rig.vehicle.rear.driven = true;
  const MotorLayout layout = motor_layout(rig.vehicle);
  const Drivetrain& gear = rig.vehicle.drivetrain;
  const double most_nm = rig.vehicle.motor.max_torque_nm * gear.gear_ratio * gear.efficiency;
  rig.vehicle.front.radius_m = rig.vehicle.rear.radius_m;
  const auto split = [&](double total_nm) {
    return split_torque(rig.vehicle, layout, rig.contacts, total_nm, 0.0);
  };
  const PerMotor<double> small = split(most_nm);
  EXPECT_NEAR(small[0], 0.375 * most_nm, 1e-9);
  EXPECT_NEAR(small[2], 0.125 * most_nm, 1e-9);
  EXPECT_NEAR(small[1], 0.25 * most_nm, 1e-9);
  const PerMotor<double> large = split(3.2 * most_nm);
  EXPECT_NEAR(large[0], most_nm, 1e-9);
  EXPECT_NEAR(large[2], 0.6 * most_nm, 1e-9);
  // Beyond what the side can, all of it is asked for: the cut is counted where it is made.
  const PerMotor<double> beyond = split(5.0 * most_nm);
  EXPECT_NEAR(beyond[0] + beyond[2], 2.5 * most_nm, 1e-9);
  EXPECT_GT(beyond[0], most_nm);
}

TEST(Drivetrain, OneMotorCannotTurnTheVehicle) {
  const Rig rig;
  EXPECT_EQ(rig.command(100.0, 0.8, 500.0).wheels[0].drive_nm,
            rig.command(100.0, 0.8).wheels[0].drive_nm);
}

}  // namespace
}  // namespace headland
