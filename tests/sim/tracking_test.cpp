// How well both vehicles keep to the path: the targets of the project, on several grounds.
#include <gtest/gtest.h>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kWorst_m = 0.20;
constexpr double kNoisyRows_m = 0.05;  // with 2 cm of noise

struct Ground {
  const char* name;
  Heightfield terrain;
};

class Tracking : public testing::TestWithParam<const char*> {
 protected:
  const Vehicle vehicle = load_vehicle(GetParam());
  const Path path = test::rows_for(vehicle, 4, 40.0);

  RunRecord drive(const Heightfield& terrain, const SimulationOptions& options = {}) const {
    return test::run(path, vehicle, terrain, test::textbook_soil(0.6, 0.07), options);
  }
};

TEST_P(Tracking, RowsAndTurnsStayWithinTheTargets) {
  const Ground grounds[] = {{"flat", test::plane(0.0, 0.0)},
                            {"hills", test::hills(1.0, 30.0, 120.0)},
                            {"side slope of 20 %", test::plane(0.0, 0.2)},
                            {"hills on a side slope of 12 %", test::hillside(0.12, 0.8, 40.0)}};
  for (const Ground& ground : grounds) {
    const RunRecord run = drive(ground.terrain);
    ASSERT_EQ(run.outcome, Outcome::kFinished) << ground.name << ": " << run.outcome_detail;
    const test::TrackingError error = test::tracking_error(path, run);
    EXPECT_LT(error.rows_m, test::kRows_m) << ground.name;
    EXPECT_LT(error.turns_m, test::kTurns_m) << ground.name;
    EXPECT_LT(std::abs(run.peaks.cross_track_working_m.value), kWorst_m) << ground.name;
    EXPECT_LT(std::abs(run.peaks.cross_track_turning_m.value), kWorst_m) << ground.name;
  }
}

TEST_P(Tracking, PositioningNoiseCostsAboutItself) {
  const Heightfield terrain = test::hills(1.0, 30.0, 120.0);
  const double ideal_m = test::tracking_error(path, drive(terrain)).rows_m;
  for (const double noise_time_s : {1.0, 30.0}) {
    SimulationOptions options;
    options.positioning.noise_m = 0.02;
    options.positioning.noise_time_s = noise_time_s;
    const RunRecord run = drive(terrain, options);
    ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
    const double rows_m = test::tracking_error(path, run).rows_m;
    EXPECT_LT(rows_m, kNoisyRows_m) << noise_time_s;
    EXPECT_GT(rows_m, ideal_m) << noise_time_s;
  }
}

TEST_P(Tracking, KeepsToTheRowsWithUsualLatencies) {
  SimulationOptions options;
  options.positioning.latency_s = 0.1;
  options.steering_latency_s = 0.1;
  const RunRecord run = drive(test::hills(1.0, 30.0, 120.0), options);
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  EXPECT_LT(test::tracking_error(path, run).rows_m, test::kRows_m);
  EXPECT_LT(test::tracking_error(path, run).turns_m, test::kTurns_m);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, Tracking, testing::Values("transplanter", "utility_tractor"));

}  // namespace
}  // namespace headland
