// Figures of a vehicle with round numbers, against values worked out by hand.
#include "vehicle_models/vehicle_figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace headland {
namespace {

constexpr double kExact = 1e-12;  // relative: only rounding between

// 800 kg on a wheelbase of 2 m and tracks of 1.2 m and 1.6 m, centre of mass 0.8 m ahead and 0.6 m
// up; 200 kg implement 1 m behind the rear axle, 0.6 m up: together 1000 kg, 0.44 m ahead.
Vehicle round_vehicle() {
  Vehicle vehicle;
  vehicle.body.mass_kg = 800.0;
  vehicle.body.com_B = {0.8, 0.0, 0.6};
  vehicle.front.x_B_m = 2.0;
  vehicle.rear.track_m = 1.2;
  vehicle.front.track_m = 1.6;
  vehicle.rear.radius_m = vehicle.front.radius_m = 0.5;
  vehicle.rear.driven = true;
  vehicle.steering.max_angle_rad = std::atan(0.5);
  vehicle.drivetrain.gear_ratio = 20.0;
  vehicle.drivetrain.efficiency = 0.8;
  vehicle.motor.max_torque_nm = 50.0;
  vehicle.motor.max_power_w = 4000.0;
  vehicle.motor.max_speed_rad_per_s = 200.0;
  vehicle.implement.mass_kg = 200.0;
  vehicle.implement.x_B_m = -1.0;
  vehicle.implement.com_height_m = 0.6;
  vehicle.implement.working_width_m = 2.0;
  vehicle.implement.draft_n_per_m = 100.0;
  vehicle.implement.shaft_power_w = 300.0;
  vehicle.implement.shaft_efficiency = 0.75;
  vehicle.battery.chemistry = Chemistry::kLfp;
  vehicle.battery.cells_in_series = 15;  // 48 V
  vehicle.battery.resistance_ohm = 0.02;
  vehicle.battery.polarisation_resistance_ohm = 0.0;
  vehicle.battery.capacity_ah = 100.0;
  vehicle.battery.empty_soc = 0.1;
  vehicle.battery.auxiliary_power_w = 40.0;
  return vehicle;
}

TEST(VehicleFigures, WeighsMachineAndMountedImplementTogether) {
  const Vehicle vehicle = round_vehicle();
  EXPECT_NEAR(total_com_B(vehicle).x(), 0.44, kExact);
  EXPECT_NEAR(total_com_B(vehicle).z(), 0.6, kExact);
  const AxleLoads loads = static_axle_loads(vehicle);
  EXPECT_NEAR(loads.front_n, 220.0 * kGravity_mps2, 1e-9);
  EXPECT_NEAR(loads.rear_n, 780.0 * kGravity_mps2, 1e-9);
}

TEST(VehicleFigures, LeavesATrailedImplementOnItsOwnWheels) {
  Vehicle vehicle = round_vehicle();
  vehicle.implement.trailing.emplace();
  EXPECT_NEAR(total_com_B(vehicle).x(), 0.8, kExact);
  EXPECT_NEAR(static_axle_loads(vehicle).front_n, 320.0 * kGravity_mps2, 1e-9);
  EXPECT_EQ(total_mass_kg(vehicle), 1000.0);
}

TEST(VehicleFigures, TipsWhereGravityPassesTheGroundPoints) {
  const Vehicle vehicle = round_vehicle();
  // Track where the centre of mass is: 1.2 m and 22 % of the way to 1.6 m.
  EXPECT_NEAR(std::tan(side_stability_angle_rad(vehicle)), 0.5 * 1.288 / 0.6, kExact);
  EXPECT_NEAR(std::tan(nose_up_stability_angle_rad(vehicle)), 0.44 / 0.6, kExact);
  EXPECT_NEAR(std::tan(nose_down_stability_angle_rad(vehicle)), 1.56 / 0.6, kExact);
}

TEST(VehicleFigures, APivotedAxleHoldsAtItsPivotOnly) {
  Vehicle vehicle = round_vehicle();
  const double rigid = side_stability_angle_rad(vehicle);
  vehicle.front.oscillation_max_rad = 0.2;
  const double pivoted = side_stability_angle_rad(vehicle);
  EXPECT_LT(pivoted, rigid);
  // The other way: gravity's moment about the line from the wheel's ground point to the pivot.
  const Eigen::Vector3d foot(0.0, 0.6, 0.0);
  const Eigen::Vector3d line = Eigen::Vector3d(2.0, 0.0, 0.5) - foot;
  const Eigen::Vector3d gravity(0.0, std::sin(pivoted), -std::cos(pivoted));
  EXPECT_NEAR(line.dot((total_com_B(vehicle) - foot).cross(gravity)), 0.0, 1e-12);
}

TEST(VehicleFigures, TurnsOnTheRadiusOfItsSteering) {
  Vehicle vehicle = round_vehicle();
  EXPECT_NEAR(min_turning_radius_m(vehicle), 4.0, kExact);
  vehicle.steering.kind = SteeringKind::kFourWheel;
  vehicle.front.x_B_m *= 0.5;  // B's origin is the middle between the axles
  vehicle.rear.x_B_m = -vehicle.front.x_B_m;
  EXPECT_NEAR(min_turning_radius_m(vehicle), 2.0, kExact);
  vehicle.steering.kind = SteeringKind::kSkid;
  vehicle.steering.turning_radius_m = 0.7;
  EXPECT_EQ(min_turning_radius_m(vehicle), 0.7);
}

TEST(VehicleFigures, DrivesByItsMotors) {
  Vehicle vehicle = round_vehicle();
  EXPECT_NEAR(top_speed_mps(vehicle), 5.0, kExact);
  EXPECT_NEAR(drive_force_n(vehicle, 0.0), 50.0 * 20.0 * 0.8 / 0.5, 1e-9);
  EXPECT_NEAR(drive_force_n(vehicle, 4.0), 4000.0 * 0.8 / 4.0, 1e-9);
  EXPECT_EQ(drive_force_n(vehicle, 5.1), 0.0);
  vehicle.drivetrain.motor_per_wheel = true;
  EXPECT_EQ(motor_count(vehicle), 2);
  EXPECT_NEAR(drive_force_n(vehicle, 0.0), 2 * 1600.0, 1e-9);
  vehicle.front.driven = true;
  EXPECT_EQ(motor_count(vehicle), 4);
  EXPECT_NEAR(drive_force_n(vehicle, 4.0), 4 * 800.0, 1e-9);
}

TEST(VehicleFigures, ClimbsByGripAsTheShiftingWeightLets) {
  Vehicle vehicle = round_vehicle();
  const double pull = 0.5;
  const double rolling = 0.06;
  const auto slope_force = [&](double rear_share, double front_share, double grade) {
    // Weight per axle over the weight's normal part, on a slope.
    const double rear = 0.78 + 0.3 * grade;
    const double front = 0.22 - 0.3 * grade;
    return pull * (rear_share * rear + front_share * front) -
           rolling * ((1.0 - rear_share) * rear + (1.0 - front_share) * front) - grade;
  };
  EXPECT_NEAR(slope_force(1, 0, max_grade_by_grip(vehicle, pull, rolling)), 0.0, kExact);
  vehicle.front.driven = true;
  EXPECT_NEAR(max_grade_by_grip(vehicle, pull, rolling), pull, kExact);
  vehicle.rear.driven = false;
  EXPECT_NEAR(slope_force(0, 1, max_grade_by_grip(vehicle, pull, rolling)), 0.0, kExact);
  EXPECT_EQ(max_grade_by_grip(vehicle, 0.1, 0.3), 0.0);
}

TEST(VehicleFigures, LastsAsLongAsTheBatteryFeedsTheMotor) {
  const Vehicle vehicle = round_vehicle();
  // 0.05 m g at 2 m/s through a loss-free motor: the wheels' power over the gear's efficiency.
  const double rolling_n = 0.05 * 1000.0 * kGravity_mps2;
  const Endurance raised = endurance(vehicle, 2.0, 0.05, false);
  const double raised_w = rolling_n * 2.0 / 0.8 + 40.0;
  EXPECT_NEAR(raised.power_w, raised_w, 1e-9);
  // R I^2 - E I + P = 0 with E 48 V, R 0.02 ohm; 90 of 100 Ah.
  const double current_a = (48.0 - std::sqrt(48.0 * 48.0 - 0.08 * raised_w)) / 0.04;
  EXPECT_NEAR(raised.time_h, 90.0 / current_a, 1e-9);
  EXPECT_NEAR(raised.distance_m, raised.time_h * 7200.0, 1e-6);
  const Endurance working = endurance(vehicle, 2.0, 0.05, true);
  EXPECT_NEAR(working.power_w, (rolling_n + 200.0) * 2.0 / 0.8 + 40.0 + 400.0, 1e-9);
  EXPECT_LT(working.time_h, raised.time_h);
}

TEST(VehicleFigures, CountsMotorInverterAndPeukertLosses) {
  Vehicle vehicle = round_vehicle();
  const double free_w = endurance(vehicle, 2.0, 0.05, false).power_w;
  vehicle.motor.constant_loss_w = 50.0;
  vehicle.motor.inverter_efficiency = 0.9;
  EXPECT_NEAR(endurance(vehicle, 2.0, 0.05, false).power_w, (free_w - 40.0 + 50.0) / 0.9 + 40.0,
              1e-9);
  vehicle.battery.chemistry = Chemistry::kLeadAcid;
  vehicle.battery.cells_in_series = 24;
  vehicle.battery.peukert = 1.0;
  const double plain_h = endurance(vehicle, 2.0, 0.05, false).time_h;
  vehicle.battery.peukert = 1.2;
  // Current in units of the 20 h current of 5 A, to the power of 0.2.
  EXPECT_NEAR(endurance(vehicle, 2.0, 0.05, false).time_h,
              plain_h / std::pow(90.0 / plain_h / 5.0, 0.2), 1e-9);
}

TEST(VehicleFigures, SaysNothingLastsAtASpeedThatCannotBeHeld) {
  Vehicle vehicle = round_vehicle();
  EXPECT_EQ(endurance(vehicle, 5.5, 0.05, false).time_h, 0.0);
  EXPECT_EQ(endurance(vehicle, 2.0, 0.5, false).time_h, 0.0);
  vehicle.battery.resistance_ohm = 1.0;
  EXPECT_EQ(endurance(vehicle, 2.0, 0.05, false).time_h, 0.0);
}

}  // namespace
}  // namespace headland
