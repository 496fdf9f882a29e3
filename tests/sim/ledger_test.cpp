// The energy ledger against closed forms, and its closure on every scene.
#include "sim/ledger.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

using test::cause_j;

constexpr double kClosure = 1e-4;  // of battery energy: 0.01 %

// A machine without losses of its own but the gear's: what is left are the textbook's terms.
Vehicle lossless(const char* name) {
  Vehicle vehicle = load_vehicle(name);
  vehicle.motor.copper_loss_kc = vehicle.motor.iron_loss_ki = 0.0;
  vehicle.motor.windage_loss_kw = vehicle.motor.constant_loss_w = 0.0;
  vehicle.battery.auxiliary_power_w = 0.0;
  vehicle.battery.resistance_ohm = 1e-9;
  vehicle.battery.polarisation_resistance_ohm = 0.0;
  vehicle.implement.draft_n_per_m = vehicle.implement.shaft_power_w = 0.0;
  vehicle.drivetrain.efficiency = 0.8;
  // Four equal wheels, equally loaded and driven: no wheel pulls another.
  vehicle.front.driven = true;
  vehicle.implement.mass_kg = 0.0;
  vehicle.body.com_B.x() = 0.5 * wheelbase_m(vehicle);
  const double wheelbase = vehicle.front.x_B_m;
  vehicle.front = vehicle.rear;
  vehicle.front.x_B_m = wheelbase;
  return vehicle;
}

// Energy between two samples in the middle of a run, where speed is steady.
struct Stretch {
  double power_w = 0.0;
  double speed_mps = 0.0;
};
Stretch middle_of(const RunRecord& run) {
  Stretch stretch;
  int count = 0;
  for (std::size_t i = run.samples.size() / 2; i < run.samples.size() * 3 / 4; ++i, ++count) {
    stretch.power_w += run.samples[i].battery_power_w;
    stretch.speed_mps += run.samples[i].speed_mps;
  }
  stretch.power_w /= count;
  stretch.speed_mps /= count;
  return stretch;
}

TEST(Ledger, FlatEnergyPerMetreIsCrrMgOverEfficiency) {
  const Vehicle vehicle = lossless("transplanter");
  const RunRecord run =
      test::run(test::straight(150.0), vehicle, test::plane(0.0, 0.0), test::textbook_soil());
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const Stretch stretch = middle_of(run);
  const double by_formula = 0.05 * total_mass_kg(vehicle) * kGravity_mps2 / 0.8;
  // 0.1 % is the target; every wheel is driven, so that hardly any slip is left to explain.
  EXPECT_NEAR(stretch.power_w / stretch.speed_mps, by_formula, 0.001 * by_formula);
}

TEST(Ledger, ClimbCostsWeightTimesSlopeAndTheRestIsSlip) {
  const Vehicle vehicle = lossless("transplanter");
  const RunRecord run =
      test::run(test::straight(120.0), vehicle, test::plane(0.1, 0.0), test::textbook_soil());
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  const Stretch stretch = middle_of(run);
  const double slope_rad = std::atan(0.1);
  const double by_formula = total_mass_kg(vehicle) * kGravity_mps2 *
                            (0.05 * std::cos(slope_rad) + std::sin(slope_rad)) / 0.8;
  const double excess = stretch.power_w / stretch.speed_mps / by_formula - 1.0;
  EXPECT_GT(excess, 0.0);
  EXPECT_LT(excess, 0.02);  // the target: within 2 %
  // The wheels turn 1 / (1 - s) times as fast as the ground passes; s is the share of the tractive
  // power that is lost to slip. 5 %: starting and stopping are in the run's totals.
  const double tractive_j = 0.8 * run.energy.battery_j - cause_j(run.energy, EnergyCause::kRolling);
  const double slip = cause_j(run.energy, EnergyCause::kSlip) / tractive_j;
  EXPECT_NEAR(excess, slip / (1.0 - slip), 0.05 * excess);
}

TEST(Ledger, RearDriveSlipsToPushTheFrontWheels) {
  Vehicle vehicle = lossless("transplanter");
  vehicle.front.driven = false;
  constexpr double kFriction = 0.8;
  constexpr double kSlipStiffness = 10.0;  // of textbook_soil
  const SoilMap soil = test::textbook_soil(kFriction);
  const RunRecord run = test::run(test::straight(150.0), vehicle, test::plane(0.0, 0.0), soil);
  const Stretch stretch = middle_of(run);
  const double weight_n = total_mass_kg(vehicle) * kGravity_mps2;
  const double measured = stretch.power_w / stretch.speed_mps / (0.05 * weight_n / 0.8) - 1.0;
  // The driven wheels pull the front ones: s = -ln(1 - F / (mu N)) / c, and wheel power over
  // ground power is 1 / (1 - s).
  const double front_share = chassis_mass(vehicle).com_B.x() / wheelbase_m(vehicle);
  const double pull = 0.05 * front_share / (kFriction * (1.0 - front_share));
  const double slip = -std::log(1.0 - pull) / kSlipStiffness;
  EXPECT_NEAR(measured, slip, 0.1 * slip);  // load transfer shifts the axle loads by a few percent
}

struct Scene {
  const char* name;
  const char* vehicle;
  Heightfield terrain;
};

TEST(Ledger, ClosesOnEverySceneAndNoLossIsNegative) {
  const Scene scenes[] = {{"flat", "transplanter", test::plane(0.0, 0.0)},
                          {"ramp", "transplanter", test::plane(0.08, 0.0)},
                          {"side slope", "utility_tractor", test::plane(0.0, 0.1)},
                          {"hills", "transplanter", test::hills(0.8, 25.0)},
                          {"hills", "utility_tractor", test::hills(1.5, 40.0, 150.0)}};
  for (const Scene& scene : scenes) {
    const Vehicle vehicle = load_vehicle(scene.vehicle);
    const Path path = test::rows_with_omega_turns(
        4, 30.0, vehicle.implement.working_width_m,
        std::max(planning_turning_radius_m(vehicle), vehicle.implement.working_width_m / 1.9));
    const RunRecord run = test::run(path, vehicle, scene.terrain, test::textbook_soil());
    SCOPED_TRACE(std::string(scene.name) + ", " + scene.vehicle);
    ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
    EXPECT_LT(std::abs(cause_j(run.energy, EnergyCause::kResidual)),
              kClosure * run.energy.battery_j);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(EnergyCause::kImplement); ++i) {
      EXPECT_GE(run.energy.cause_j[i], 0.0) << energy_cause_name(static_cast<EnergyCause>(i));
    }
    EnergyBalance sum;
    double duration_s = 0.0;
    for (const SegmentRecord& segment : run.segments) {
      add(sum, segment.energy);
      duration_s += segment.duration_s;
    }
    EXPECT_NEAR(sum.battery_j, run.energy.battery_j, 1e-9 * run.energy.battery_j);
    EXPECT_NEAR(duration_s, run.duration_s, 1e-6);
  }
}

TEST(Ledger, HalvingTheStepHardlyChangesTheEnergy) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Path path = test::rows_with_omega_turns(3, 30.0, 2.0, planning_turning_radius_m(vehicle));
  SimulationOptions coarse;
  SimulationOptions fine;
  fine.rate_hz = 480.0;
  const Heightfield terrain = test::hills(0.8, 25.0);
  const double coarse_j =
      test::run(path, vehicle, terrain, test::textbook_soil(), coarse).energy.battery_j;
  const double fine_j =
      test::run(path, vehicle, terrain, test::textbook_soil(), fine).energy.battery_j;
  EXPECT_NEAR(coarse_j, fine_j, 0.005 * fine_j);  // the target: under 0.5 %
}

// Negative control: the residual must show a force that no cause is charged for.
TEST(Ledger, UnaccountedShowsAMissingCause) {
  const Vehicle vehicle = load_vehicle("transplanter");
  RunRecord run =
      test::run(test::straight(40.0), vehicle, test::plane(0.0, 0.0), test::textbook_soil());
  run.energy.cause_j[static_cast<std::size_t>(EnergyCause::kRolling)] = 0.0;
  EXPECT_GT(unaccounted_j(run.energy), 0.2 * run.energy.battery_j);
}

}  // namespace
}  // namespace headland
