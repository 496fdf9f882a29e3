// A trailed implement against closed forms: where it runs, what it pulls, that nothing is lost.
#include "sim/trailer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"
#include "vehicle_models/draft.h"

namespace headland {
namespace {

using test::cause_j;

const Vehicle& trailed_tractor() {
  static const Vehicle vehicle = load_vehicle("utility_tractor_trailed");
  return vehicle;
}

// Holds 1 m/s on a circle of B's origin until nothing changes.
struct Circling {
  ChassisState vehicle;
  ChassisState trailer;
  Trailer figures;
};
Circling circle(const Vehicle& vehicle, double curvature_per_m, double seconds = 60.0) {
  const Heightfield terrain = test::plane(0.0, 0.0);
  // Stiff grip without resistance: tyres roll almost without slip, as the closed form has them.
  SoilMap soil = test::textbook_soil(2.0, 0.0);
  soil.soils[0].lateral_gamma_rad = 0.002;
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(), terrain, vehicle);
  stand(machine, {0.0, 0.0}, 0.0, world);
  MachineState state;
  DriverCommand command;
  const Steer steer{steer_for(vehicle, curvature_per_m), 0.0};
  for (long i = 0; i < std::lround(seconds * 240.0); ++i) {
    const ChassisState chassis = world.state();
    const double speed_mps = chassis.v_W.dot(chassis.R_WB.col(0));
    command.wheel_torque_nm = 20000.0 * (1.0 - speed_mps);
    step_machine(machine, command, steer, 0.0, 1.0 / 240.0, world, state);
  }
  return {world.state(), world.trailer_state(), *machine.trailer};
}

// The pin runs on hypot(R, hitch), the implement's axle on sqrt(R^2 + hitch^2 - drawbar^2).
TEST(Trailer, CutsCornersBySteadyOffTracking) {
  const Vehicle& vehicle = trailed_tractor();
  const Trailing& trailing = *vehicle.implement.trailing;
  for (const double radius_m : {6.0, 10.0, 20.0}) {
    const Circling run = circle(vehicle, 1.0 / radius_m);
    // Distance of each axle's middle from the common centre of rotation: |v| / |omega|.
    const auto radius_of = [](const ChassisState& body, const Eigen::Vector3d& middle_C) {
      return point_velocity(body.v_W, body.omega_W, body.R_WB * middle_C).head<2>().norm() /
             std::abs(body.omega_W.z());
    };
    const double axle_m = radius_of(run.trailer, -run.figures.mass.com_B);
    const double rear_m = radius_of(run.vehicle, -chassis_mass(vehicle).com_B);
    const double by_formula_m =
        std::sqrt(rear_m * rear_m + trailing.hitch_x_B_m * trailing.hitch_x_B_m -
                  trailing.drawbar_length_m * trailing.drawbar_length_m);
    // 1 %: what is left of the tyres' slip angles.
    EXPECT_NEAR(axle_m, by_formula_m, 0.01 * by_formula_m) << radius_m;
    EXPECT_NEAR(hitch_angle_rad(run.vehicle, run.trailer),
                steady_hitch_angle_rad(trailing, 1.0 / rear_m), 0.01)
        << radius_m;
  }
}

TEST(Trailer, LeftMirrorsRight) {
  const Circling left = circle(trailed_tractor(), 0.1, 15.0);
  const Circling right = circle(trailed_tractor(), -0.1, 15.0);
  // The solver visits left wheels first, which is all that differs.
  constexpr double kSweepOrder = 1e-3;
  EXPECT_NEAR(hitch_angle_rad(left.vehicle, left.trailer),
              -hitch_angle_rad(right.vehicle, right.trailer), kSweepOrder);
  EXPECT_NEAR(left.trailer.p_WC.y(), -right.trailer.p_WC.y(), 0.01);
}

TEST(Trailer, StraightPullIsRollingAndDraft) {
  Vehicle vehicle = trailed_tractor();
  vehicle.implement.trailing->rolling_resistance = 0.08;
  const Heightfield terrain = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(), terrain, vehicle);
  stand(machine, {-100.0, 0.0}, 0.0, world);
  MachineState state;
  DriverCommand command;
  double pull_n = 0.0;
  double speed_mps = 0.0;
  double expected_n = 0.0;
  constexpr int kSteps = 30 * 240;
  constexpr int kMeasured = 5 * 240;
  for (int i = 0; i < kSteps; ++i) {
    const ChassisState chassis = world.state();
    command.wheel_torque_nm = 6500.0 + 20000.0 * (2.0 - chassis.v_W.x());
    if (kSteps - i <= kMeasured) {
      const PinForce pin = pin_force(*machine.trailer, chassis, world.trailer_state(), 1.0 / 240.0);
      pull_n -= pin.force_W.x() / kMeasured;
      speed_mps = chassis.v_W.x();
      const auto contacts =
          touch_ground(terrain, world.trailer_state(), machine.trailer->own_wheels(), 0.0);
      expected_n += (0.08 * (contacts[0].load_n + contacts[1].load_n) +
                     draft_n(vehicle.implement, SoilTexture::kMedium, speed_mps)) /
                    kMeasured;
    }
    step_machine(machine, command, {}, 1.0, 1.0 / 240.0, world, state);
  }
  // 0.1 %: the last of the approach to a steady speed.
  EXPECT_NEAR(pull_n, expected_n, 0.001 * expected_n);
}

TEST(Trailer, StandsWithItsWeightOnWheelsAndPin) {
  const Vehicle& vehicle = trailed_tractor();
  const Heightfield terrain = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(), terrain, vehicle);
  stand(machine, {0.0, 0.0}, 0.4, world);
  MachineState state;
  DriverCommand braked;
  braked.hold = true;
  StepReport report;
  for (int i = 0; i < 5 * 240; ++i) {
    report = step_machine(machine, braked, {}, 0.0, 1.0 / 240.0, world, state);
  }
  const AxleLoads loads = static_axle_loads(vehicle);
  const PinForce pin = pin_force(*machine.trailer, world.state(), world.trailer_state(), 1.0 / 240);
  // 0.5 %: sagging tyres tilt the bodies a little.
  EXPECT_NEAR(-pin.force_W.z(), hitch_load_n(vehicle), 0.005 * hitch_load_n(vehicle));
  EXPECT_NEAR(report.contacts[0].load_n + report.contacts[1].load_n, loads.rear_n,
              0.005 * loads.rear_n);
  EXPECT_NEAR(report.contacts[2].load_n + report.contacts[3].load_n, loads.front_n,
              0.005 * loads.front_n);
  const auto trailed =
      touch_ground(terrain, world.trailer_state(), machine.trailer->own_wheels(), 0.0);
  const double own_n = kGravity_mps2 * vehicle.implement.mass_kg - hitch_load_n(vehicle);
  EXPECT_NEAR(trailed[0].load_n + trailed[1].load_n, own_n, 0.005 * own_n);
}

// Across a slope its weight acts at the height of its centre of mass, part of the side force is the
// pin's: (left - right) / (left + right) = 2 slope (h - share h_pin) / (track (1 - share)), with
// the pin's share of the weight. A run judges it where it is worse than the vehicle's own.
TEST(Trailer, ShiftsItsLoadDownASideSlopeAndIsJudgedByIt) {
  constexpr double kSlope = 0.15;  // up to the left
  Vehicle vehicle = trailed_tractor();
  vehicle.implement.com_height_m = 1.6;
  const Trailing& trailing = *vehicle.implement.trailing;
  const double share = trailing.com_ahead_m / trailing.drawbar_length_m;
  const double formula = -2.0 * kSlope *
                         (vehicle.implement.com_height_m - share * trailing.hitch_height_m) /
                         (trailing.track_m * (1.0 - share));
  const RunRecord run = test::run(test::straight(20.0), vehicle, test::plane(0.0, kSlope),
                                  test::textbook_soil(0.8, 0.05));
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  EXPECT_TRUE(run.peaks.load_transfer_of_trailer);
  // The body rolls on its tyres and the steering never rests: a tenth.
  EXPECT_NEAR(run.peaks.load_transfer_ratio.value, formula, 0.1 * std::abs(formula));

  const RunRecord low = test::run(test::straight(20.0), trailed_tractor(), test::plane(0.0, kSlope),
                                  test::textbook_soil(0.8, 0.05));
  EXPECT_FALSE(low.peaks.load_transfer_of_trailer);
}

TEST(Trailer, ParkedOnASlopeDoesNotCreep) {
  for (const double slope : {0.2, -0.2}) {
    EXPECT_LT(test::park(trailed_tractor(), slope, 240.0).drift_mm_per_min, 0.1) << slope;
  }
}

// A wheel that its brake locks turns to and fro by the solver's last digits.
constexpr double kLocked_j = 1e-6;

TEST(Trailer, LedgerClosesOnHillsAndNoLossIsNegative) {
  const Vehicle& vehicle = trailed_tractor();
  const Path path = test::rows_for(vehicle, 4, 40.0);
  for (const Heightfield& terrain : {test::plane(0.0, 0.08), test::hills(0.8, 40.0, 150.0)}) {
    const RunRecord run = test::run(path, vehicle, terrain, test::textbook_soil());
    ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
    EXPECT_LT(std::abs(cause_j(run.energy, EnergyCause::kResidual)), 1e-4 * run.energy.battery_j);
    for (const SegmentRecord& segment : run.segments) {
      for (std::size_t i = 0; i <= static_cast<std::size_t>(EnergyCause::kImplement); ++i) {
        EXPECT_GE(segment.energy.cause_j[i], -kLocked_j)
            << energy_cause_name(static_cast<EnergyCause>(i));
      }
    }
    EXPECT_GT(cause_j(run.energy, EnergyCause::kDraft), 0.3 * run.energy.battery_j);
  }
}

TEST(Trailer, HalvingTheStepHardlyChangesTheEnergy) {
  const Vehicle& vehicle = trailed_tractor();
  const Path path = test::rows_for(vehicle, 3, 40.0);
  const Heightfield terrain = test::hills(1.0, 40.0, 150.0);
  SimulationOptions fine;
  fine.rate_hz = 480.0;
  const double coarse_j = test::run(path, vehicle, terrain, test::textbook_soil()).energy.battery_j;
  const double fine_j =
      test::run(path, vehicle, terrain, test::textbook_soil(), fine).energy.battery_j;
  EXPECT_NEAR(coarse_j, fine_j, 0.005 * fine_j);  // the target: under 0.5 %
}

TEST(Trailer, EveryStepThatCanBeChosenIsStable) {
  const Vehicle& vehicle = trailed_tractor();
  for (const double rate_hz : {60.0, 120.0, 1000.0}) {
    SimulationOptions options;
    options.rate_hz = rate_hz;
    const RunRecord run = test::run(test::rows_for(vehicle, 2, 30.0), vehicle,
                                    test::hills(1.0, 40.0), test::textbook_soil(), options);
    EXPECT_EQ(run.outcome, Outcome::kFinished) << rate_hz << ": " << run.outcome_detail;
  }
}

TEST(Trailer, JackknifeEndsTheRun) {
  Vehicle vehicle = trailed_tractor();
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 10.0, 0.0);
  test::extend(path, PathKind::kUTurn, Gear::kForward, false, 20.0, 1.0 / 5.0);
  const Heightfield flat = test::plane(0.0, 0.0);
  const RunRecord whole = test::run(path, vehicle, flat, test::textbook_soil());
  EXPECT_EQ(whole.outcome, Outcome::kFinished) << whole.outcome_detail;
  double widest_rad = 0.0;
  for (const RunSample& sample : whole.samples) {
    widest_rad = std::min(widest_rad, sample.hitch_angle_rad);
  }
  // Nearly the steady angle of that circle, to the right as seen from a left turn.
  EXPECT_NEAR(widest_rad, steady_hitch_angle_rad(*vehicle.implement.trailing, 1.0 / 5.0), 0.05);

  vehicle.implement.trailing->max_angle_rad = 0.5;
  const RunRecord caught = test::run(path, vehicle, flat, test::textbook_soil());
  EXPECT_EQ(caught.outcome, Outcome::kJackknifed);
  EXPECT_NE(caught.outcome_detail.find("drawbar"), std::string::npos) << caught.outcome_detail;
  EXPECT_NEAR(std::abs(caught.samples.back().hitch_angle_rad), 0.5, 0.02);
}

// The bar stays square to the drawbar, whose pin is where the vehicle's record says.
TEST(Trailer, FootprintsLieWhereTheToolWas) {
  const Vehicle& vehicle = trailed_tractor();
  const Trailing& trailing = *vehicle.implement.trailing;
  Path path;
  test::extend(path, PathKind::kHeadlandPass, Gear::kForward, true, 10.0, 0.0);
  test::extend(path, PathKind::kHeadlandPass, Gear::kForward, true, 25.0, 0.1);
  SimulationOptions options;
  options.record_hz = 240.0;
  const RunRecord run =
      test::run(path, vehicle, test::plane(0.0, 0.0), test::textbook_soil(), options);
  ASSERT_GT(run.footprints.size(), 100U);
  for (const FootprintSample& footprint : run.footprints) {
    const auto& sample = run.samples[static_cast<std::size_t>(std::lround(footprint.time_s * 240))];
    const auto ahead = [](double yaw) { return Eigen::Vector2d(std::cos(yaw), std::sin(yaw)); };
    const double drawbar_rad = sample.yaw_rad + sample.hitch_angle_rad;
    const Eigen::Vector2d pin_W =
        sample.p_WB.head<2>() + trailing.hitch_x_B_m * ahead(sample.yaw_rad);
    const Eigen::Vector2d middle_W =
        pin_W + (vehicle.implement.x_B_m - trailing.hitch_x_B_m) * ahead(drawbar_rad);
    const double half_m = 0.5 * vehicle.implement.working_width_m;
    // 3 cm: the pin gives by millimetres and the bodies pitch on their tyres.
    EXPECT_NEAR((0.5 * (footprint.left_W + footprint.right_W) - middle_W).norm(), 0.0, 0.03);
    EXPECT_NEAR((footprint.left_W - footprint.right_W).norm(), 2.0 * half_m, 1e-6);
    EXPECT_NEAR((footprint.left_W - footprint.right_W).dot(ahead(drawbar_rad)), 0.0, 1e-6);
  }
  // Negative control: a bar fixed to the vehicle would be elsewhere in the bend.
  const RunSample& last = run.samples.back();
  EXPECT_GT(std::abs(last.hitch_angle_rad), 0.2);
}

TEST(Trailer, ItsDrawbarAndBarHitObstacles) {
  Field field = test::open_field();
  // Beside the tractor, in the way of the 4 m bar behind it.
  field.obstacles.push_back({ObstacleKind::kPole, {20.0, 1.8}, 0.1, 3.0});
  const RunRecord run = test::run(test::straight(60.0), trailed_tractor(), test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, field);
  EXPECT_EQ(run.outcome, Outcome::kHitObstacle);
  EXPECT_NEAR(run.samples.back().p_WB.x(), 20.0 + 4.4 - 0.25 - 0.1, 0.1);
}

}  // namespace
}  // namespace headland
