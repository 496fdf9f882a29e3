// Story tests: settle, drive, brake, reverse, turn, climb, tip over, run empty, hit, leave.
#include "sim/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/free_space.h"
#include "terrains/input_error.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

Vehicle transplanter() { return load_vehicle("transplanter"); }

TEST(Simulation, DrivesAStraightLineToItsEnd) {
  const RunRecord run =
      test::run(test::straight(60.0), transplanter(), test::plane(0.0, 0.0), test::textbook_soil());
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const RunSample& last = run.samples.back();
  constexpr double kStopping_m = 0.03;  // the driver sets the brakes 1 cm before the end
  EXPECT_NEAR(last.p_WB.x(), 60.0, kStopping_m);
  EXPECT_NEAR(last.p_WB.y(), 0.0, 1e-6);
  EXPECT_NEAR(run.distance_m, 60.0, kStopping_m);
  EXPECT_NEAR(last.speed_mps, 0.0, 0.02);
  EXPECT_EQ(run.peaks.boundary_overrun_m.value, 0.0);
}

TEST(Simulation, MovesOffOnEverySoilWhicheverWayTheGroundTilts) {
  for (const Soil& soil : soils()) {
    for (const double slope : {-0.005, 0.0, 0.005}) {
      const Vehicle vehicle = load_vehicle("utility_tractor");
      const RunRecord run = test::run(test::straight(5.0, true), vehicle, test::plane(slope, 0.01),
                                      uniform_soil(soil));
      EXPECT_EQ(run.outcome, Outcome::kFinished) << soil.name << ", slope " << slope;
    }
  }
}

TEST(Simulation, KeepsItsWorkSpeedWithin1Percent) {
  const Vehicle vehicle = transplanter();
  const RunRecord run =
      test::run(test::straight(60.0, true), vehicle, test::plane(0.05, 0.0), test::textbook_soil());
  const RunSample& middle = run.samples[run.samples.size() / 2];
  EXPECT_NEAR(middle.speed_mps, vehicle.driver.work_speed_mps,
              0.01 * vehicle.driver.work_speed_mps);
}

TEST(Simulation, ReversesAlongAnArcAndEndsWhereItShould) {
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 5.0, 0.0);
  test::extend(path, PathKind::kTurn, Gear::kReverse, false, 4.0, 0.3);
  const PathPoint end = path.segments.back().points.back();
  const RunRecord run =
      test::run(path, transplanter(), test::plane(0.0, 0.0), test::textbook_soil());
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const RunSample& last = run.samples.back();
  EXPECT_LT((last.p_WB.head<2>() - end.p_W).norm(), 0.15);  // the target for turns
  EXPECT_NEAR(last.yaw_rad, end.heading_rad, 0.1);
  const auto backwards = std::count_if(run.samples.begin(), run.samples.end(),
                                       [](const RunSample& s) { return s.speed_mps < -0.2; });
  EXPECT_GT(backwards, 30);
}

TEST(Simulation, FootprintCoversTheSwathAndNothingElse) {
  const Vehicle vehicle = transplanter();
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 8.0, 0.0);
  test::extend(path, PathKind::kSwath, Gear::kForward, true, 20.0, 0.0);
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 8.0, 0.0);
  const RunRecord run = test::run(path, vehicle, test::plane(0.0, 0.0), test::textbook_soil());
  ASSERT_FALSE(run.footprints.empty());
  const double x_m = vehicle.implement.x_B_m;
  constexpr double kStep_m = 0.01;  // metres driven in a step, at both ends
  EXPECT_NEAR(run.footprints.front().left_W.x(), 8.0 + x_m, kStep_m);
  EXPECT_NEAR(run.footprints.back().left_W.x(), 28.0 + x_m, kStep_m);
  EXPECT_TRUE(run.footprints.front().starts_strip);
  for (const FootprintSample& footprint : run.footprints) {
    EXPECT_NEAR((footprint.left_W - footprint.right_W).norm(), 2.0, 1e-9);
    EXPECT_GT(footprint.left_W.y(), footprint.right_W.y());
  }
}

TEST(Simulation, SlipsAndSticksWhereItCannotClimb) {
  const RunRecord run = test::run(test::straight(60.0), transplanter(), test::plane(0.30, 0.0),
                                  test::textbook_soil(0.35, 0.08));
  EXPECT_EQ(run.outcome, Outcome::kStuck) << run.outcome_detail;
  EXPECT_NE(run.outcome_detail.find("spin"), std::string::npos) << run.outcome_detail;
  EXPECT_GT(run.peaks.slip.value, 0.3);
}

// Static stability: the upper wheels unload at atan(half track / height of the centre of mass).
// One degree short of it the barrier against tipping is 0.15 mm of lift: a vehicle set down there
// bounces over it. So the angle is read from the loads of standing vehicles, extrapolated to zero,
// and the tipping itself is seen one degree past it.
TEST(Simulation, TipsOverAtThePredictedSideSlope) {
  Vehicle vehicle = transplanter();
  vehicle.front.oscillation_max_rad = 0.0;
  vehicle.front.vertical_stiffness_n_per_m = 5e6;  // rigid tyres, as the formula assumes
  vehicle.rear.vertical_stiffness_n_per_m = 5e6;
  vehicle.front.vertical_damping_n_s_per_m = vehicle.rear.vertical_damping_n_s_per_m = 2e4;
  const double tip_rad = std::atan2(0.5 * vehicle.rear.track_m, chassis_mass(vehicle).com_B.z());
  const SoilMap soil = test::textbook_soil(3.0, 0.02);
  constexpr double kStep_s = 1.0 / 2000.0;  // stiff tyres want a short step
  // Upper wheels' share of the load over cos(slope): linear in tan(slope).
  const auto upper_load = [&](double slope_rad) {
    const Heightfield terrain = test::plane(0.0, std::tan(slope_rad), 20.0);
    const Machine machine = make_machine(vehicle, terrain, soil);
    BulletWorld world(test::open_field(15.0), terrain, vehicle);
    world.set_state(place_on_ground(machine, {0.0, 0.0}, 0.0));
    MachineState state;
    DriverCommand braked;
    braked.hold = true;
    StepReport report;
    for (int i = 0; i < 6000; ++i) {
      report = step_machine(machine, braked, {}, 0.0, kStep_s, world, state);
    }
    return (report.contacts[0].load_n + report.contacts[2].load_n) / std::cos(slope_rad);
  };
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double low = tip_rad - 8.0 * kDegree;
  const double high = tip_rad - 4.0 * kDegree;
  const double low_n = upper_load(low);
  const double high_n = upper_load(high);
  const double zero_tangent =
      std::tan(high) + high_n * (std::tan(high) - std::tan(low)) / (low_n - high_n);
  EXPECT_NEAR(std::atan(zero_tangent), tip_rad, kDegree);

  SimulationOptions options;
  options.rate_hz = 1.0 / kStep_s;
  const RunRecord past = test::run(test::straight(4.0), vehicle,
                                   test::plane(0.0, std::tan(tip_rad + kDegree)), soil, options);
  EXPECT_EQ(past.outcome, Outcome::kRolledOver) << past.outcome_detail;
  const RunRecord short_of =
      test::run(test::straight(4.0), vehicle, test::plane(0.0, std::tan(tip_rad - 8.0 * kDegree)),
                soil, options);
  EXPECT_NE(short_of.outcome, Outcome::kRolledOver);
}

TEST(Simulation, RunsTheBatteryEmpty) {
  SimulationOptions options;
  options.soc_start = transplanter().battery.empty_soc + 0.002;
  const RunRecord run = test::run(test::straight(150.0), transplanter(), test::plane(0.02, 0.0),
                                  test::textbook_soil(), options);
  EXPECT_EQ(run.outcome, Outcome::kBatteryEmpty) << run.outcome_detail;
  EXPECT_LT(run.distance_m, 149.0);
  // Empty is empty: within what one step takes, some 1e-7 of the charge.
  EXPECT_NEAR(run.soc_end, transplanter().battery.empty_soc, 1e-6);

  // A fifth more charge above empty drives further, by more than a sixth; less than all of it is
  // driving, since starting takes its share.
  options.soc_start = transplanter().battery.empty_soc + 0.0024;
  const RunRecord longer = test::run(test::straight(150.0), transplanter(), test::plane(0.02, 0.0),
                                     test::textbook_soil(), options);
  EXPECT_EQ(longer.outcome, Outcome::kBatteryEmpty) << longer.outcome_detail;
  EXPECT_GT(longer.distance_m, run.distance_m * 7.0 / 6.0);
}

TEST(Simulation, HitsATreeInItsWay) {
  Field field = test::open_field();
  field.obstacles.push_back({ObstacleKind::kTree, {30.0, 0.2}, 0.3, 6.0});
  const RunRecord run = test::run(test::straight(60.0), transplanter(), test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, field);
  EXPECT_EQ(run.outcome, Outcome::kHitObstacle);
  EXPECT_NE(run.outcome_detail.find("tree at x 30.0 m"), std::string::npos) << run.outcome_detail;
  const Vehicle vehicle = transplanter();
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  EXPECT_NEAR(run.samples.back().p_WB.x() + front_m, 29.7, 0.15);  // one sample's travel
}

// Beside the hull and ahead of the implement: what planning takes for the vehicle is what collides.
TEST(Simulation, ImplementMeetsATreeWherePlanningSays) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  Field field = test::open_field();
  field.obstacles.push_back({ObstacleKind::kTree, {15.0, 3.0}, 0.3, 6.0});
  const RunRecord run = test::run(test::straight(30.0), vehicle, test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, field);
  ASSERT_EQ(run.outcome, Outcome::kHitObstacle);
  const FreeSpace space = free_space(field, hull_of(vehicle));
  const RunSample& end = run.samples.back();
  const auto depth_m = [&](double ahead_m) {
    return overrun(space, {{end.p_WB.x() + ahead_m, end.p_WB.y()}, end.yaw_rad}).depth_m;
  };
  constexpr double kTravel_m = 0.3;  // of one sample and of the pitch
  EXPECT_EQ(depth_m(-kTravel_m), 0.0);
  EXPECT_GT(depth_m(kTravel_m), 0.0);
}

// A stone lower than the hull stops a wheel and passes between the wheels.
TEST(Simulation, WheelsMeetWhatTheHullClears) {
  const Vehicle vehicle = transplanter();
  const double height_m = 0.5 * vehicle.body.ground_clearance_m;
  const double track_m = 0.5 * vehicle.front.track_m;
  Field field = test::open_field();
  const auto run_past = [&](double y_m) {
    field.obstacles = {{ObstacleKind::kRock, {10.0, y_m}, 0.1, height_m}};
    return test::run(test::straight(20.0), vehicle, test::plane(0.0, 0.0), test::textbook_soil(),
                     {}, field);
  };
  EXPECT_EQ(run_past(0.0).outcome, Outcome::kFinished);
  for (const double y_m : {track_m, -track_m}) {
    const RunRecord run = run_past(y_m);
    EXPECT_EQ(run.outcome, Outcome::kHitObstacle);
    // The wheel's foremost edge at the stone's; 0.15 m: one sample's travel.
    EXPECT_NEAR(run.samples.back().p_WB.x() + vehicle.front.x_B_m + vehicle.front.radius_m, 9.9,
                0.15);
  }
}

// A wall across its way and a fence beside it that the hull clears by 10 cm.
TEST(Simulation, HitsAWallAndPassesAFence) {
  const Vehicle vehicle = transplanter();
  const double side_m =
      0.5 * std::max(vehicle.body.width_m, vehicle.implement.working_width_m) + 0.1;
  Field field = test::open_field();
  field.obstacles.push_back({ObstacleKind::kFence, {-10.0, side_m + 0.05}, 0.05, 1.2, {60.0, 0.0}});
  const Heightfield flat = test::plane(0.0, 0.0);
  EXPECT_EQ(
      test::run(test::straight(10.0), vehicle, flat, test::textbook_soil(), {}, field).outcome,
      Outcome::kFinished);
  field.obstacles.push_back({ObstacleKind::kWall, {12.0, -20.0}, 0.15, 1.0, {0.0, 40.0}});
  const RunRecord run =
      test::run(test::straight(20.0), vehicle, flat, test::textbook_soil(), {}, field);
  EXPECT_EQ(run.outcome, Outcome::kHitObstacle);
  EXPECT_NE(run.outcome_detail.find("hit the wall at x 12.0 m, y "), std::string::npos)
      << run.outcome_detail;
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  EXPECT_NEAR(run.samples.back().p_WB.x() + front_m, 11.85, 0.15);  // one sample's travel
  field.obstacles = {{ObstacleKind::kFence, {-10.0, side_m - 0.15}, 0.05, 1.2, {60.0, 0.0}}};
  const RunRecord grazing =
      test::run(test::straight(10.0), vehicle, flat, test::textbook_soil(), {}, field);
  EXPECT_EQ(grazing.outcome, Outcome::kHitObstacle);
  EXPECT_NE(grazing.outcome_detail.find("hit the fence"), std::string::npos);
}

TEST(Simulation, LeavesTheField) {
  const RunRecord run = test::run(test::straight(60.0), transplanter(), test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, test::open_field(40.0));
  EXPECT_EQ(run.outcome, Outcome::kLeftField);
  EXPECT_EQ(run.outcome_detail.find("after"), std::string::npos) << "the time is told elsewhere";
  const Vehicle vehicle = transplanter();
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  EXPECT_NEAR(run.samples.back().p_WB.x() + front_m, 45.0, 0.3);
}

TEST(Simulation, ReportsASmallOverrunAndGoesOn) {
  const Vehicle vehicle = transplanter();
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  const RunRecord run = test::run(test::straight(40.0), vehicle, test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, test::open_field(39.0 + front_m));
  EXPECT_EQ(run.outcome, Outcome::kFinished);
  constexpr double kCheckAndStop_m = 0.12;  // checked every 0.1 m, stops 1 to 2 cm short
  EXPECT_NEAR(run.peaks.boundary_overrun_m.value, 1.0, kCheckAndStop_m);
}

// A hole that fits between the hull's corners is seen all the same.
TEST(Simulation, SeesAHoleSmallerThanTheHull) {
  Field field = test::open_field();
  field.holes = {{{19.8, -0.2}, {19.8, 0.2}, {20.2, 0.2}, {20.2, -0.2}}};
  const RunRecord run = test::run(test::straight(40.0), transplanter(), test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, field);
  EXPECT_EQ(run.outcome, Outcome::kFinished);
  // From the side of the hull to the far side of the hole: half the width and 0.2 m, at most.
  EXPECT_GT(run.peaks.boundary_overrun_m.value, 0.5);
  EXPECT_LT((run.peaks.boundary_overrun_m.p_W - Eigen::Vector2d(20.0, 0.0)).norm(), 0.3);
}

TEST(Simulation, EntersAHole) {
  Field field = test::open_field();
  field.holes = {{{15.0, -20.0}, {15.0, 20.0}, {60.0, 20.0}, {60.0, -20.0}}};
  const RunRecord run = test::run(test::straight(40.0), transplanter(), test::plane(0.0, 0.0),
                                  test::textbook_soil(), {}, field);
  EXPECT_EQ(run.outcome, Outcome::kEnteredHole);
  EXPECT_EQ(outcome_name(run.outcome), "entered a hole");
  EXPECT_NE(run.outcome_detail.find("m into a hole at x "), std::string::npos)
      << run.outcome_detail;
}

// 250 W crawl up a gentle slope, more slowly than the driver asks for.
TEST(Simulation, SaysThatTheMotorWasTheReasonForBeingLate) {
  Vehicle weak = transplanter();
  weak.motor.max_power_w = 250.0;
  SimulationOptions options;
  options.max_time_s = 30.0;
  const RunRecord run =
      test::run(test::straight(150.0), weak, test::plane(0.1, 0.0), test::textbook_soil(), options);
  ASSERT_EQ(run.outcome, Outcome::kTimedOut) << run.outcome_detail;
  EXPECT_NE(run.outcome_detail.find("the motor at its limit for "), std::string::npos)
      << run.outcome_detail;
  EXPECT_NE(run.outcome_detail.find(" % of the time: too steep or too soft"), std::string::npos)
      << run.outcome_detail;
  // Negative control: a strong one that has too little time.
  const RunRecord strong = test::run(test::straight(150.0), transplanter(), test::plane(0.0, 0.0),
                                     test::textbook_soil(), options);
  ASSERT_EQ(strong.outcome, Outcome::kTimedOut);
  EXPECT_EQ(strong.outcome_detail.find("limit"), std::string::npos) << strong.outcome_detail;
}

TEST(Simulation, LeavesTheTerrain) {
  const RunRecord run = test::run(test::straight(60.0), transplanter(), test::plane(0.0, 0.0, 30.0),
                                  test::textbook_soil());
  EXPECT_EQ(run.outcome, Outcome::kLeftTerrain);
}

TEST(Simulation, TimesOutAndCanBeInterrupted) {
  SimulationOptions options;
  options.max_time_s = 10.0;
  EXPECT_EQ(test::run(test::straight(60.0), transplanter(), test::plane(0.0, 0.0),
                      test::textbook_soil(), options)
                .outcome,
            Outcome::kTimedOut);
  const Vehicle vehicle = transplanter();
  const Heightfield terrain = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  const Field field = test::open_field();
  const Path path = test::straight(60.0);
  const RunRecord run =
      simulate({field, terrain, soil, vehicle, path, {}, [](const SimulationProgress& p) {
                  return p.time_s < 5.0;
                }});
  EXPECT_EQ(run.outcome, Outcome::kInterrupted);
  EXPECT_NEAR(run.duration_s, 5.0, 1.1);
  EXPECT_FALSE(run.samples.empty());
}

TEST(Simulation, CoastsDownByTheRollingResistance) {
  const Vehicle vehicle = transplanter();
  const Heightfield terrain = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil(0.8, 0.05);
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(), terrain, vehicle);
  MachineState state;
  ChassisState moving = place_on_ground(machine, {0.0, 0.0}, 0.0);
  moving.v_W = {3.0, 0.0, 0.0};
  world.set_state(moving);
  double rotating_kg = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const WheelDefinition& wheel = machine.wheels[i];
    state.wheels[i].spin_rad_per_s = 3.0 / wheel.radius_m;
    rotating_kg += wheel.inertia_kg_m2 / (wheel.radius_m * wheel.radius_m);
  }
  const DriverCommand coasting;
  for (int i = 0; i < 720; ++i) {
    step_machine(machine, coasting, {}, 0.0, 1.0 / 240.0, world, state);
  }
  const double mass_kg = machine.mass.mass_kg;
  const double deceleration = 0.05 * mass_kg * kGravity_mps2 / (mass_kg + rotating_kg);
  // 0.3 %: braked wheels slip a little, so the rims run slower than the ground.
  EXPECT_NEAR(world.state().v_W.x(), 3.0 - 3.0 * deceleration, 0.003 * 3.0);
}

TEST(Simulation, RefusesAPathWithoutMotion) {
  Path still = test::straight(10.0);
  still.segments[0].points.resize(1);
  for (const Path& path : {still, Path{}}) {
    try {
      test::run(path, transplanter(), test::plane(0.0, 0.0), test::textbook_soil());
      FAIL() << "drove a path without motion";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "path: nothing to drive: no two points of it are apart");
    }
  }
}

}  // namespace
}  // namespace headland
