#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

struct Case {
  const char* vehicle;
  double rows_rms_m;  // bound
};

// 3 cm is the target with ideal positioning. A skid-steered vehicle leaves its tight turns sliding
// sideways, which the first metres of these short rows still show.
constexpr Case kCases[] = {
    {"four_wheel_steer_robot", 0.03}, {"horticultural_tractor", 0.03}, {"skid_steer_robot", 0.05}};

class SteeringKinds : public testing::TestWithParam<Case> {};

TEST_P(SteeringKinds, DrivesRowsAndTurnsOnTheirPath) {
  const Vehicle vehicle = load_vehicle(GetParam().vehicle);
  const Path path = test::rows_for(vehicle, 4, 20.0);
  const RunRecord run = test::run(path, vehicle, test::hills(0.3, 25.0), test::soil_named("firm"));
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const test::TrackingError tracking = test::tracking_error(path, run);
  EXPECT_LE(tracking.rows_m, GetParam().rows_rms_m);
  EXPECT_LE(tracking.turns_m, 0.15);
  EXPECT_LE(std::abs(test::cause_j(run.energy, EnergyCause::kResidual)),
            1e-4 * run.energy.battery_j);
  for (const EnergyCause cause :
       {EnergyCause::kSlip, EnergyCause::kScrub, EnergyCause::kRolling, EnergyCause::kMotor}) {
    EXPECT_GT(test::cause_j(run.energy, cause), 0.0) << energy_cause_name(cause);
  }
  EXPECT_EQ(test::cause_j(run.energy, EnergyCause::kInverter) > 0.0,
            vehicle.motor.inverter_efficiency < 1.0);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, SteeringKinds, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.vehicle); });

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
  double lowest_m = 5.0;
  for (const RunSample& sample : run.samples) {
    if (sample.segment == 1) lowest_m = std::min(lowest_m, sample.p_WB.x());
  }
  // Tyres that slide sideways as it turns hold the grade with what grip is left: it gives way by
  // decimetres, where without a hold it would run down the slope.
  constexpr double kDrift_m = 0.6;
  EXPECT_GT(lowest_m, 5.0 - kDrift_m);
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
