#include "evaluate/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "terrains/input_error.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

const Soil kTextbookGround{"textbook", ConstantGround{0.8, 0.05, 10.0}, 0.09, ""};

// Few and quick: the work speed on three slopes, one row spacing a kind of turn.
MeasureOptions quick(int repeats = 1) {
  MeasureOptions options;
  options.ranges.speed_shares = {1.0};
  options.ranges.slopes = {-0.1, 0.0, 0.1};
  options.ranges.side_slopes = {};
  options.ranges.spacings_m = {2.0, 6.0};
  options.micro_relief.rms_m = 0.0;
  options.repeats = repeats;
  return options;
}

const MeasuredCost& cost_with(const CostTable& table, ManoeuvreKind kind, bool down,
                              double slope = 0.0, double spacing_m = 0.0) {
  for (const MeasuredCost& cost : table.costs) {
    const Manoeuvre& m = cost.manoeuvre;
    if (m.kind == kind && m.implement_down == down && m.slope_along == slope &&
        m.row_spacing_m == spacing_m) {
      return cost;
    }
  }
  throw std::runtime_error("no such manoeuvre was measured");
}

double sum_of_causes_j(const MeasuredCost& cost) {
  double sum_j = 0.0;
  for (const double cause_j : cost.cause_j) sum_j += cause_j;
  return sum_j;
}

class Measure : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    table_ = new CostTable(measure_costs(load_vehicle("transplanter"), kTextbookGround, quick()));
  }
  static void TearDownTestSuite() { delete table_; }
  static const CostTable* table_;
};
const CostTable* Measure::table_ = nullptr;

TEST_F(Measure, EveryManoeuvreIsDrivenAndItsCausesAddUp) {
  EXPECT_EQ(table_->costs.size(), 14U);
  for (const MeasuredCost& cost : table_->costs) {
    SCOPED_TRACE(manoeuvre_name(cost.manoeuvre.kind));
    EXPECT_EQ(cost.outcome, Outcome::kFinished) << cost.outcome_detail;
    // Ledger closes to 0.01 % of what the window took, of which this may be a small part.
    EXPECT_NEAR(sum_of_causes_j(cost), cost.energy_j.mean, 1.0);
  }
}

// On textbook ground the climb's force is m g sin, its rolling resistance m g Crr cos.
TEST_F(Measure, SlopesCostTheirHeight) {
  const MeasuredCost& up = cost_with(*table_, ManoeuvreKind::kStraight, false, 0.1);
  const double grade_j = up.cause_j[static_cast<std::size_t>(EnergyCause::kGrade)];
  const double rise_m = up.distance_m.mean * 0.1;
  EXPECT_NEAR(grade_j, table_->mass_kg * kGravity_mps2 * rise_m, 0.005 * grade_j);
  // Rolling resistance acts along the slope, the distance is in the plane.
  const double rolling_j = up.cause_j[static_cast<std::size_t>(EnergyCause::kRolling)];
  EXPECT_NEAR(rolling_j, 0.05 * table_->mass_kg * kGravity_mps2 * up.distance_m.mean,
              0.02 * rolling_j);
  EXPECT_GT(up.marginal_energy_j.mean, grade_j);
  const MeasuredCost& down = cost_with(*table_, ManoeuvreKind::kStraight, false, -0.1);
  EXPECT_NEAR(down.cause_j[static_cast<std::size_t>(EnergyCause::kGrade)], -grade_j,
              0.005 * grade_j);
  EXPECT_LT(down.energy_j.mean,
            cost_with(*table_, ManoeuvreKind::kStraight, false, 0.0).energy_j.mean);
}

TEST_F(Measure, SteadyDrivingOnTheFlatIsTheZeroOfMargins) {
  for (const bool down : {true, false}) {
    const MeasuredCost& flat = cost_with(*table_, ManoeuvreKind::kStraight, down);
    EXPECT_NEAR(flat.marginal_energy_j.mean, 0.0, 1e-9);
    EXPECT_NEAR(flat.marginal_time_s.mean, 0.0, 1e-9);
    EXPECT_NEAR(flat.distance_m.mean / flat.time_s.mean, table_->work_speed_mps,
                0.01 * table_->work_speed_mps);
  }
}

TEST_F(Measure, TurnsTakeTheirWayAndMoreThanStraightDriving) {
  const double radius_m = table_->turning_radius_m;
  const MeasuredCost& u = cost_with(*table_, ManoeuvreKind::kUTurn, true, 0.0, 6.0);
  constexpr double kPi = 3.141592653589793;
  // Steering ramps of a metre at every change of curvature lengthen the way by this share.
  constexpr double kRamps = 0.03;
  // PI turn: w + (pi - 2) R.
  EXPECT_NEAR(u.distance_m.mean, 6.0 + (kPi - 2.0) * radius_m, kRamps * u.distance_m.mean);
  const MeasuredCost& omega = cost_with(*table_, ManoeuvreKind::kOmegaTurn, true, 0.0, 2.0);
  EXPECT_NEAR(omega.distance_m.mean,
              radius_m * (3.0 * kPi - 4.0 * std::asin((2.0 * radius_m + 2.0) / (4.0 * radius_m))),
              kRamps * omega.distance_m.mean);
  const MeasuredCost& fishtail = cost_with(*table_, ManoeuvreKind::kThreePointTurn, true, 0.0, 2.0);
  EXPECT_NEAR(fishtail.distance_m.mean, kPi * radius_m + 2.0 * radius_m - 2.0, 0.3);
  for (const MeasuredCost* turn : {&u, &omega, &fishtail}) {
    EXPECT_GT(turn->marginal_energy_j.mean, 0.0);
    EXPECT_GT(turn->marginal_time_s.mean, 0.0);
    EXPECT_GT(turn->scuffed_m2.mean, 0.0);
  }
  // It stops twice, so it takes longer than its way at the turn speed.
  EXPECT_GT(fishtail.time_s.mean,
            fishtail.distance_m.mean / load_vehicle("transplanter").driver.turn_speed_mps + 2.0);
}

TEST_F(Measure, StopsAndImplementCyclesCostWhatTheyDo) {
  const double v = table_->work_speed_mps;
  const double a = load_vehicle("transplanter").driver.max_acceleration_mps2;
  for (const bool down : {true, false}) {
    const MeasuredCost& stop = cost_with(*table_, ManoeuvreKind::kStopStart, down);
    EXPECT_NEAR(stop.distance_m.mean, 0.0, 0.03);  // the brakes are set 1 cm before the end
    EXPECT_GT(stop.energy_j.mean, 0.0);
    // v / a is lost, half of it speeding up and half slowing down. The tyres' give and the creep to
    // the end take some tenths of a second more; a wait for the implement would take 1.5 s.
    EXPECT_NEAR(stop.time_s.mean, v / a, 0.7) << down;
  }
  const MeasuredCost& cycle = cost_with(*table_, ManoeuvreKind::kImplementCycle, true);
  const Implement implement = load_vehicle("transplanter").implement;
  // The implement is down this much before its segment begins.
  constexpr double kEarly_s = 0.15;
  EXPECT_NEAR(cycle.cause_j[static_cast<std::size_t>(EnergyCause::kImplement)],
              implement.lift_energy_j,
              kEarly_s * implement.shaft_power_w / implement.shaft_efficiency);
  // On its way down and up the implement pulls with what of it is in the ground.
  EXPECT_GT(cycle.marginal_energy_j.mean, implement.lift_energy_j);
}

TEST_F(Measure, FormulaIsThePapersForTheMassAndSlope) {
  const MeasuredCost& up = cost_with(*table_, ManoeuvreKind::kStraight, true, 0.1);
  const double weight_n = table_->mass_kg * kGravity_mps2;
  const double cosine = std::cos(std::atan(0.1));
  EXPECT_NEAR(up.formula_j / up.distance_m.mean, weight_n * (0.25 * cosine * cosine + 0.1), 1e-6);
  EXPECT_NEAR(up.formula_as_printed_j / up.distance_m.mean,
              weight_n * (0.25 * cosine * cosine + 0.1 * std::sin(std::atan(0.1))), 1e-6);
  // The paper's height differences have no sign.
  const MeasuredCost& downhill = cost_with(*table_, ManoeuvreKind::kStraight, true, -0.1);
  EXPECT_NEAR(downhill.formula_j / downhill.distance_m.mean, up.formula_j / up.distance_m.mean,
              1e-6);
}

TEST_F(Measure, ReadsWhatItWrites) {
  const std::filesystem::path file = testing::TempDir() + "costs_round_trip.yaml";
  std::ofstream(file) << cost_table_yaml(*table_);
  EXPECT_EQ(cost_table_yaml(*table_).find("ci95"), std::string::npos);  // of one repeat
  const CostTable read = read_cost_table(file);
  EXPECT_EQ(cost_table_yaml(read), cost_table_yaml(*table_));
  EXPECT_EQ(read.costs.size(), table_->costs.size());
}

TEST_F(Measure, RefusesADamagedTableByLineAndKey) {
  std::string text = cost_table_yaml(*table_);
  text.replace(text.find("manoeuvre: straight"), 19, "manoeuvre: strait__");
  const std::filesystem::path file = testing::TempDir() + "costs_damaged.yaml";
  std::ofstream(file) << text;
  try {
    read_cost_table(file);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("manoeuvre"));
    EXPECT_THAT(error.what(), testing::HasSubstr("one of: straight, stop and start"));
  }
}

TEST(MeasureCosts, IsTheSameWithAnyNumberOfJobs) {
  MeasureOptions options = quick(2);
  options.ranges.slopes = {0.0};
  options.ranges.spacings_m = {6.0};
  options.micro_relief.rms_m = 0.02;
  const Vehicle vehicle = load_vehicle("transplanter");
  const std::string one = cost_table_yaml(measure_costs(vehicle, kTextbookGround, options));
  options.jobs = 3;
  EXPECT_EQ(cost_table_yaml(measure_costs(vehicle, kTextbookGround, options)), one);
  options.seed = 9;
  EXPECT_NE(cost_table_yaml(measure_costs(vehicle, kTextbookGround, options)), one);
}

TEST(MeasureCosts, SaysWhatCannotBeDriven) {
  MeasureOptions options = quick();
  options.ranges.slopes = {0.0, 0.6};
  const CostTable table = measure_costs(load_vehicle("transplanter"), kTextbookGround, options);
  const MeasuredCost& steep = cost_with(table, ManoeuvreKind::kStraight, true, 0.6);
  EXPECT_EQ(steep.outcome, Outcome::kStuck);
  EXPECT_FALSE(steep.outcome_detail.empty());
  const Soil ice{"ice", ConstantGround{0.02, 0.05, 10.0}, 0.09, ""};
  EXPECT_THROW(measure_costs(load_vehicle("transplanter"), ice, options), InputError);
}

TEST(MeasureCosts, DrivesOnTheFlatFirst) {
  MeasureOptions options = quick(3);
  int drives = 0;
  options.progress = [&drives](double) { return ++drives > 0; };
  const Soil ice{"ice", ConstantGround{0.02, 0.05, 10.0}, 0.09, ""};
  EXPECT_THROW(measure_costs(load_vehicle("transplanter"), ice, options), InputError);
  EXPECT_EQ(drives, 2);  // implement down and raised, of the first repeat
}

TEST(MeasureCosts, RefusesReliefBeyondMemoryByItsOption) {
  MeasureOptions options = quick();
  options.ranges.spacings_m = {100.0};
  options.micro_relief = {0.01, 0.005};
  try {
    measure_costs(load_vehicle("transplanter"), kTextbookGround, options);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--relief-length"));
  }
}

TEST(MeasureCosts, PivotsASkidSteeredVehicle) {
  const CostTable table = measure_costs(load_vehicle("skid_steer_robot"), kTextbookGround, quick());
  const MeasuredCost& pivot = cost_with(table, ManoeuvreKind::kPivotTurn, true, 0.0, 2.0);
  ASSERT_EQ(pivot.outcome, Outcome::kFinished) << pivot.outcome_detail;
  const MeasuredCost& u_turn = cost_with(table, ManoeuvreKind::kUTurn, true, 0.0, 2.0);
  // Square across instead of round: longer by (4 - pi) R, less what it drifts as it pivots, but all
  // of the turning scrubs on the spot.
  EXPECT_NEAR(pivot.distance_m.mean, 2.0, 0.3);
  EXPECT_GT(pivot.time_s.mean, u_turn.time_s.mean);
  EXPECT_GT(pivot.scuffed_m2.mean, 0.0);
}

TEST(MeasureCosts, EndsWhenAsked) {
  MeasureOptions options = quick();
  options.progress = [](double) { return false; };
  EXPECT_TRUE(measure_costs(load_vehicle("transplanter"), kTextbookGround, options).costs.empty());
}

// Three values a, b, c: mean and t_0.975(2) s / sqrt(3) with t = 4.30265.
TEST(Estimate, IsMeanAndStudentsInterval) {
  const Estimate estimate = estimate_of({1.0, 2.0, 6.0});
  EXPECT_NEAR(estimate.mean, 3.0, 1e-12);
  EXPECT_NEAR(estimate.ci95.value_or(0.0), 4.30265 * std::sqrt(7.0) / std::sqrt(3.0), 1e-4);
  EXPECT_FALSE(estimate_of({5.0}).ci95.has_value());
}

}  // namespace
}  // namespace headland
