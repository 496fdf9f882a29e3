#include "sim/belly.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kBellyStep_s = 1.0 / 240.0;

// A vehicle whose belly hangs so far below its wheels that these never reach the ground.
Vehicle sledge() {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.body.ground_clearance_m = -0.5;
  return vehicle;
}

// Lies on its belly on a plane that rises along x, unmoved but for what `moving` sets.
struct Lying {
  Lying(const Vehicle& vehicle, const Heightfield& terrain, const SoilMap& soil,
        const Eigen::Vector3d& v_W = Eigen::Vector3d::Zero())
      : machine(make_machine(vehicle, terrain, soil)), world(test::open_field(), terrain, vehicle) {
    ChassisState chassis = place_on_ground(machine, {0.0, 0.0}, 0.0);
    chassis.p_WC -= vehicle.body.ground_clearance_m * chassis.R_WB.col(2);
    chassis.v_W = v_W;
    world.set_state(chassis);
  }
  StepReport rest(double seconds, double step_s = kBellyStep_s) {
    DriverCommand braked;
    braked.hold = true;
    StepReport report;
    for (int i = 0; i < std::lround(seconds / step_s); ++i) {
      report = step_machine(machine, braked, {}, 0.0, step_s, world, state);
      loss_j += test::cause_j(report.energy, EnergyCause::kBelly);
    }
    return report;
  }
  Machine machine;
  BulletWorld world;
  MachineState state;
  double loss_j = 0.0;
};

double belly_load_n(const StepReport& report) {
  double sum_n = 0.0;
  for (const BellyContact& contact : report.belly) sum_n += contact.load_n;
  return sum_n;
}

TEST(Belly, CarriesTheWholeWeightWithoutWheels) {
  const Vehicle vehicle = sledge();
  const Heightfield flat = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  for (const double rate_hz : {60.0, 240.0, 1000.0}) {
    Lying lying(vehicle, flat, soil);
    const StepReport report = lying.rest(5.0, 1.0 / rate_hz);
    const double weight_n = lying.machine.mass.mass_kg * kGravity_mps2;
    EXPECT_NEAR(belly_load_n(report), weight_n, 1e-4 * weight_n) << rate_hz;  // settled by then
    // The load's middle is under the centre of mass.
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const BellyContact& contact : report.belly) {
      moment += contact.arm.cross(contact.load_n * contact.normal);
    }
    EXPECT_LT(moment.norm(), 1e-3 * weight_n) << rate_hz;
  }
}

// With the belly a little above the wheels' rest both carry, each by its own stiffness.
TEST(Belly, SharesTheWeightWithTheWheels) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.body.ground_clearance_m = -0.002;
  const Heightfield flat = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  Lying lying(vehicle, flat, soil);
  const StepReport report = lying.rest(5.0);
  const double weight_n = lying.machine.mass.mass_kg * kGravity_mps2;
  double wheels_n = 0.0;
  for (const WheelContact& contact : report.contacts) wheels_n += contact.load_n;
  EXPECT_NEAR(belly_load_n(report) + wheels_n, weight_n, 1e-4 * weight_n);
  EXPECT_GT(belly_load_n(report), 0.02 * weight_n);
  EXPECT_GT(wheels_n, 0.02 * weight_n);
}

// Sliding to rest takes v^2 / (2 mu g), and the friction's loss is the energy of the motion.
TEST(Belly, SlidesToRestByCoulombFriction) {
  const Vehicle vehicle = sledge();
  const Heightfield flat = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  Lying settled(vehicle, flat, soil);
  settled.rest(5.0);
  ChassisState moving = settled.world.state();
  const double start_m = moving.p_WC.x();
  moving.v_W = {2.0, 0.0, 0.0};
  settled.world.set_state(moving);
  settled.loss_j = 0.0;
  settled.rest(3.0);
  const double way_m = 2.0 * 2.0 / (2.0 * kBellyFriction * kGravity_mps2);
  // Braking at its underside pitches the body and rocks it on its springs for a while: 3 %.
  EXPECT_NEAR(settled.world.state().p_WC.x() - start_m, way_m, 0.03 * way_m);
  const double energy_j = 0.5 * settled.machine.mass.mass_kg * 2.0 * 2.0;
  EXPECT_NEAR(settled.loss_j, energy_j, 0.01 * energy_j);
}

TEST(Belly, DoesNotCreepOnASlopeItsFrictionHolds) {
  const Vehicle vehicle = sledge();
  const Heightfield slope = test::plane(0.2, 0.0);
  const SoilMap soil = test::textbook_soil();
  Lying lying(vehicle, slope, soil);
  lying.rest(10.0);
  const Eigen::Vector3d before = lying.world.state().p_WC;
  lying.rest(20.0);
  EXPECT_LT((lying.world.state().p_WC - before).norm(), 3e-4);  // 1 mm a minute
}

// No look is left out that would have found a contact.
TEST(Belly, IsWatchedWithoutMissingAContact) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.body.ground_clearance_m = 0.15;
  const Heightfield terrain = test::hills(0.35, 9.0, 60.0);
  const SoilMap soil = test::textbook_soil();
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(50.0), terrain, vehicle);
  world.set_state(place_on_ground(machine, {-40.0, 3.0}, 0.3));
  MachineState state;
  DriverCommand command;
  command.wheel_torque_nm = 0.12 * machine.mass.mass_kg * kGravity_mps2 * vehicle.rear.radius_m;
  int touching = 0;
  for (int i = 0; i < 240 * 15; ++i) {
    const StepReport report = step_machine(machine, command, {}, 0.0, kBellyStep_s, world, state);
    const auto all = touch_belly(machine.belly, terrain, report.chassis).contacts;
    ASSERT_EQ(report.belly.size(), all.size()) << "step " << i;
    touching += all.empty() ? 0 : 1;
  }
  EXPECT_GT(touching, 50);  // it did touch, and not all the time
  EXPECT_LT(touching, 240 * 14);
}

// A bed of earth between the tracks that rises at x = 15 m and falls at x = 25 m.
Heightfield bed_between_the_tracks(double height_m) {
  Heightfield terrain;
  terrain.cell_m = 0.1;
  terrain.columns = 501;
  terrain.rows = 101;
  terrain.origin_W = {-5.0, -5.0};
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j);
      const double along = std::clamp(std::min(p.x() - 15.0, 25.0 - p.x()) / 2.0, 0.0, 1.0);
      const double across = std::clamp((0.4 - std::abs(p.y())) / 0.2, 0.0, 1.0);
      terrain.height_m.push_back(height_m * along * across);
    }
  }
  return terrain;
}

RunRecord over_the_bed(double above_clearance_m) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain =
      bed_between_the_tracks(vehicle.body.ground_clearance_m + above_clearance_m);
  Field field;
  field.boundary = {{-5.0, -5.0}, {45.0, -5.0}, {45.0, 5.0}, {-5.0, 5.0}};
  return test::run(test::straight(35.0), vehicle, terrain, test::textbook_soil(), {}, field);
}

TEST(Belly, DragsOverABedHigherThanItsClearance) {
  const RunRecord run = over_the_bed(0.02);
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  EXPECT_EQ(run.peaks.belly_contacts, 1);
  // It is pressed in and lifts the vehicle off its tyres: less than the bed is too high.
  EXPECT_GT(run.peaks.belly_contact_m.value, 0.002);
  EXPECT_LT(run.peaks.belly_contact_m.value, 0.02 + 0.005);
  EXPECT_GT(run.peaks.belly_contact_m.p_W.x(), 15.0);
  EXPECT_LT(run.peaks.belly_contact_m.p_W.x(), 25.0);
  EXPECT_NEAR(run.peaks.belly_contact_m.p_W.y(), 0.0, 0.1);
  EXPECT_GT(test::cause_j(run.energy, EnergyCause::kBelly), 0.0);
  const double residual_j = std::abs(test::cause_j(run.energy, EnergyCause::kResidual));
  EXPECT_LT(residual_j, 1e-4 * run.energy.battery_j);  // 0.01 %, as on any other ground
  for (std::size_t i = 0; i < static_cast<std::size_t>(EnergyCause::kGrade); ++i) {
    EXPECT_GE(run.energy.cause_j[i], 0.0) << energy_cause_name(static_cast<EnergyCause>(i));
  }
}

TEST(Belly, PassesOverABedLowerThanItsClearance) {
  const RunRecord run = over_the_bed(-0.05);
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  EXPECT_EQ(run.peaks.belly_contacts, 0);
  EXPECT_EQ(run.peaks.belly_contact_m.value, 0.0);
  EXPECT_EQ(test::cause_j(run.energy, EnergyCause::kBelly), 0.0);
}

TEST(Belly, GroundsOnABedThatTakesTheLoadOffItsWheels) {
  const RunRecord run = over_the_bed(0.25);
  EXPECT_EQ(run.outcome, Outcome::kStuck) << run.outcome_detail;
  EXPECT_GT(run.peaks.belly_contact_m.value, 0.02);
  EXPECT_LT(run.samples.back().p_WB.x(), 25.0);
}

}  // namespace
}  // namespace headland
