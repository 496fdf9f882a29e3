#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

class SteeringKinds : public testing::TestWithParam<const char*> {};

TEST_P(SteeringKinds, DrivesRowsAndTurnsOnTheirPath) {
  const Vehicle vehicle = load_vehicle(GetParam());
  const Path path = test::rows_for(vehicle, 4, 40.0);
  const RunRecord run = test::run(path, vehicle, test::hills(0.3, 25.0), test::soil_named("firm"));
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const test::TrackingError tracking = test::tracking_error(path, run);
  EXPECT_LE(tracking.rows_m, test::kRows_m);
  EXPECT_LE(tracking.turns_m, test::kTurns_m);
  EXPECT_LE(std::abs(test::cause_j(run.energy, EnergyCause::kResidual)),
            1e-4 * run.energy.battery_j);
  for (const EnergyCause cause :
       {EnergyCause::kSlip, EnergyCause::kScrub, EnergyCause::kRolling, EnergyCause::kMotor}) {
    EXPECT_GT(test::cause_j(run.energy, cause), 0.0) << energy_cause_name(cause);
  }
  EXPECT_EQ(test::cause_j(run.energy, EnergyCause::kInverter) > 0.0,
            vehicle.motor.inverter_efficiency < 1.0);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, SteeringKinds,
                         testing::Values("four_wheel_steer_robot", "horticultural_tractor",
                                         "skid_steer_robot", "utility_tractor_trailed"),
                         [](const auto& test) { return std::string(test.param); });

// Slopes of up to 15 % shift the weight to and fro between the axles and take part of the grip; on
// concrete the motors are at their limit.
TEST(SteeringKinds, SkidSteeringKeepsToItsPathOnHills) {
  const Vehicle vehicle = load_vehicle("skid_steer_robot");
  const Path path = test::rows_for(vehicle, 3, 60.0);
  for (const char* soil : {"firm", "concrete"}) {
    const RunRecord run = test::run(path, vehicle, test::hills(0.7, 30.0), test::soil_named(soil));
    ASSERT_EQ(run.outcome, Outcome::kFinished) << soil << ": " << run.outcome_detail;
    const test::TrackingError tracking = test::tracking_error(path, run);
    EXPECT_LE(tracking.rows_m, test::kRows_m) << soil;
    EXPECT_LE(tracking.turns_m, test::kTurns_m) << soil;
  }
}

// Turning by wheel speeds drags the wheels sideways; turning by steered wheels hardly does.
TEST(SteeringKinds, SkidSteeringScrubsMoreThanSteeredWheels) {
  const auto scrub_share = [](const char* name) {
    const Vehicle vehicle = load_vehicle(name);
    Path path;
    test::extend(path, PathKind::kTurn, Gear::kForward, false, 20.0, 1.0 / 3.0);
    const RunRecord run = test::run(path, vehicle, test::plane(0.0, 0.0), test::soil_named("firm"));
    EXPECT_EQ(run.outcome, Outcome::kFinished) << name << ' ' << run.outcome_detail;
    return test::cause_j(run.energy, EnergyCause::kScrub) /
           test::cause_j(run.energy, EnergyCause::kRolling);
  };
  EXPECT_GT(scrub_share("skid_steer_robot"), 5.0 * scrub_share("four_wheel_steer_robot"));
}

// Friction hardly cares how fast a tyre slides sideways: the tyres of the axle that carries more
// hold against the others, and a couple turns the vehicle about it. To hold, they slide at the
// small angle at which their law gives what the lighter axle's give in full, N_heavy (1 -
// exp(-angle / gamma)) = N_light, which moves the point they turn about by the angle times half the
// track.
TEST(SteeringKinds, PivotsAboutItsHeavierAxle) {
  for (const double com_shift_m : {-0.15, 0.15}) {
    Vehicle vehicle = load_vehicle("skid_steer_robot");
    vehicle.body.com_B.x() += com_shift_m;
    const Heightfield terrain = test::plane(0.0, 0.0);
    const SoilMap soil = test::textbook_soil(0.6, 0.05);
    const Machine machine = make_machine(vehicle, terrain, soil);
    BulletWorld world(test::open_field(), terrain, vehicle);
    stand(machine, {0.0, 0.0}, 0.0, world);
    MachineState state;
    DriverCommand turning;
    double yaw_rad = 0.0;
    double speed_mps = 0.0;
    double rate_rad_per_s = 0.0;
    for (int i = 0; i < 2400 && yaw_rad < 0.5 * std::numbers::pi; ++i) {
      turning.yaw_torque_nm = 2000.0 * (0.5 - rate_rad_per_s);
      turning.wheel_torque_nm = -200.0 * speed_mps;
      step_machine(machine, turning, {}, 0.0, 1.0 / 240.0, world, state);
      const ChassisState chassis = world.state();
      yaw_rad = yaw_pitch_roll(chassis.R_WB).x();
      rate_rad_per_s = chassis.omega_W.z();
      speed_mps = chassis.v_W.dot(chassis.R_WB.col(0));
    }
    ASSERT_GE(yaw_rad, 0.5 * std::numbers::pi);
    const AxleLoads loads = static_axle_loads(vehicle);
    const double lighter = std::min(loads.front_n / loads.rear_n, loads.rear_n / loads.front_n);
    const double slide_rad = -soil.soils.front().lateral_gamma_rad * std::log(1.0 - lighter);
    const double axle_m = ahead_of_pivot_m(vehicle);
    EXPECT_EQ(axle_m > 0.0, com_shift_m < 0.0);
    const double ahead_m = axle_m - std::copysign(0.5 * slide_rad * vehicle.rear.track_m, axle_m);
    const Eigen::Vector3d p_WB = origin_of(world.state(), machine.mass);
    // Tyres build their force up over a few centimetres of sliding when they begin.
    constexpr double kTolerance_m = 0.06;
    EXPECT_NEAR(p_WB.x(), -ahead_m, kTolerance_m);
    EXPECT_NEAR(p_WB.y(), ahead_m, kTolerance_m);
  }
}

// On a 10 % slope, uphill along x: it turns to the left and drives across.
TEST(SteeringKinds, PivotsOnASlopeWithoutRunningAway) {
  const Vehicle vehicle = load_vehicle("skid_steer_robot");
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 5.0, 0.0);
  PathSegment across;
  across.kind = PathKind::kTransit;
  across.manoeuvre = 1;
  const double left_rad = 0.5 * std::numbers::pi;
  for (int i = 0; i <= 40; ++i) across.points.push_back({{5.0, 0.1 * i}, left_rad, 0.0});
  path.segments.push_back(across);
  const RunRecord run = test::run(path, vehicle, test::plane(0.1, 0.0), test::soil_named("firm"));
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  double furthest_m = 0.0;
  for (const RunSample& sample : run.samples) {
    if (sample.segment == 1) furthest_m = std::max(furthest_m, std::abs(sample.p_WB.x() - 5.0));
  }
  // Turned about its heavier axle alone it would end half a wheelbase, 0.46 m, off the line across,
  // and the slope would add to that: the driver steers against both while it turns.
  constexpr double kOff_m = 0.15;
  EXPECT_LT(furthest_m, kOff_m);
  EXPECT_NEAR(run.samples.back().p_WB.y(), 4.0, 0.1);
}

// Four wheels that turn to opposite sides halve the radius of two.
TEST(SteeringKinds, FourSteeredWheelsTurnOnHalfTheRadius) {
  Vehicle vehicle = load_vehicle("four_wheel_steer_robot");
  const double four_m = min_turning_radius_m(vehicle);
  vehicle.steering.kind = SteeringKind::kFront;
  vehicle.front.x_B_m = wheelbase_m(vehicle);
  vehicle.rear.x_B_m = 0.0;
  EXPECT_NEAR(four_m, 0.5 * min_turning_radius_m(vehicle), 1e-12);
}

}  // namespace
}  // namespace headland
