// What the ground lets a vehicle do: soils that change under way, grades, brakes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/test_drives.h"
#include "vehicle_models/gradeability.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

// One soil west of x = border_m, another east of it.
SoilMap border_at(double border_m, const Soil& west, const Soil& east) {
  SoilMap map;
  map.soils = {west, east};
  map.cell_m = 400.0;
  map.origin_W = {border_m - map.cell_m, -0.5 * map.cell_m};
  map.columns = 2;
  map.rows = 1;
  map.index = {0, 1};
  return map;
}

// What rolling costs a metre by Brixius [N], from the wheels' static loads and the driven ones'
// slip: the tyre's resistance is a torque, turned 1 / (1 - slip) times as far as the ground passes.
double rolling_n(const Vehicle& vehicle, const Soil& soil, double driven_slip) {
  const Heightfield flat = test::plane(0.0, 0.0);
  const SoilMap map = uniform_soil(soil);
  const Machine machine = make_machine(vehicle, flat, map);
  const double weight_n = machine.mass.mass_kg * kGravity_mps2;
  const double front = front_load_share(vehicle);
  double sum_n = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const WheelDefinition& wheel = machine.wheels[i];
    const double load_n = 0.5 * weight_n * (i < 2 ? 1.0 - front : front);
    const double slip = wheel.driven ? driven_slip : 0.0;
    const Traction traction =
        traction_on(soil, wheel.tyre, load_n, load_n / wheel.stiffness_n_per_m);
    sum_n += load_n * (traction.tyre_resistance / (1.0 - slip) + traction.soil_resistance +
                       traction.soil_resistance_per_slip * slip);
  }
  return sum_n;
}

TEST(Ground, SoftSoilCostsWhatBrixiusSaysFromItsBorderOn) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const Soil& firm = *find_soil("firm");
  const Soil& soft = *find_soil("soft");
  Path path;
  for (int i = 0; i < 2; ++i) {
    test::extend(path, PathKind::kTransit, Gear::kForward, false, 60.0, 0.0);
  }
  const RunRecord run =
      test::run(path, vehicle, test::plane(0.0, 0.0), border_at(60.0, firm, soft));
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  ASSERT_EQ(run.segments.size(), 2U);
  const auto rolling_per_m = [&](std::size_t i) {
    return test::cause_j(run.segments[i].energy, EnergyCause::kRolling) /
           run.segments[i].distance_m;
  };
  const double step_n = rolling_per_m(1) - rolling_per_m(0);
  const auto slip_at = [&](double x_m) {
    return std::ranges::find_if(run.samples,
                                [&](const RunSample& sample) { return sample.p_WB.x() > x_m; })
        ->slip;
  };
  const double by_brixius_n =
      rolling_n(vehicle, soft, slip_at(90.0)) - rolling_n(vehicle, firm, slip_at(30.0));
  // The front axle is over the border a wheelbase early: 2 m of 60 m.
  EXPECT_NEAR(step_n, by_brixius_n, 0.04 * by_brixius_n);
  EXPECT_GT(run.segments[1].energy.battery_j, 1.1 * run.segments[0].energy.battery_j);
}

TEST(Ground, GetsStuckInSoilTooSoftToCarryIt) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const Soil mire = soil_of_cone_index(60.0);
  const SoilFigures figures = figures_on(vehicle, mire);
  ASSERT_LT(figures.net_pull, figures.rolling_resistance) << "the mire is to hold it fast";
  const RunRecord run = test::run(test::straight(60.0), vehicle, test::plane(0.0, 0.0),
                                  border_at(20.0, *find_soil("firm"), mire));
  EXPECT_EQ(run.outcome, Outcome::kStuck) << run.outcome_detail;
  EXPECT_NE(run.outcome_detail.find("the driven wheels spin"), std::string::npos)
      << run.outcome_detail;
  const double reach_m = std::max(vehicle.front.x_B_m, vehicle.rear.x_B_m);
  EXPECT_GT(run.samples.back().p_WB.x() + reach_m, 20.0);  // the front axle is in it ...
  EXPECT_LT(run.samples.back().p_WB.x(), 23.0);            // ... and the rear one not far
  EXPECT_EQ(test::run(test::straight(60.0), vehicle, test::plane(0.0, 0.0),
                      border_at(20.0, *find_soil("firm"), *find_soil("soft")))
                .outcome,
            Outcome::kFinished);
}

// A vehicle's own figure for what it climbs on each soil, driven: it does 90 % of that and not
// 115 %.
class GroundClimb : public testing::TestWithParam<std::string> {};

TEST_P(GroundClimb, IsWhatGradeabilitySaysOnEverySoil) {
  const Vehicle vehicle = load_vehicle(GetParam());
  for (const Soil& soil : soils()) {
    const double grade = gradeability(vehicle, soil);
    const auto outcome_on = [&](double slope) {
      return test::run(test::straight(12.0), vehicle, test::plane(slope, 0.0, 30.0),
                       uniform_soil(soil), {}, test::open_field(25.0))
          .outcome;
    };
    EXPECT_EQ(outcome_on(0.9 * grade), Outcome::kFinished) << soil.name << ", limit " << grade;
    EXPECT_NE(outcome_on(1.15 * grade), Outcome::kFinished) << soil.name << ", limit " << grade;
  }
}

INSTANTIATE_TEST_SUITE_P(EachVehicle, GroundClimb,
                         testing::Values("transplanter", "horticultural_tractor", "utility_tractor",
                                         "skid_steer_robot", "four_wheel_steer_robot"),
                         [](const auto& vehicle) { return vehicle.param; });

// All wheels braked hold up to the slope whose tangent is the friction, and not beyond.
TEST(Ground, BrakesHoldUpToTheAdhesionLimit) {
  const Vehicle vehicle = load_vehicle("transplanter");
  constexpr double kFriction = 0.4;
  const SoilMap soil = test::textbook_soil(kFriction, 0.02);
  EXPECT_LT(test::park(vehicle, 0.97 * kFriction, 240.0, soil).drift_mm_per_min, 1.0);
  EXPECT_GT(test::park(vehicle, 1.03 * kFriction, 240.0, soil).drift_mm_per_min, 1000.0);
}

}  // namespace
}  // namespace headland
