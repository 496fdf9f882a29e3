#include "sim/driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRate_hz = 240.0;

// In a left bend of 5 m a slope down to the right adds its pull; down to the left it relieves.
TEST(Driver, SlowsInABendWhoseSideSlopePullsOutwards) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const double most_mps2 = vehicle.driver.max_lateral_acceleration_mps2;
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 30.0, 0.2);
  const Route route = make_route(path, vehicle);
  const auto reference_mps = [&](double roll_rad) {
    DriverState state = at_start(route, 0.0, kRate_hz);
    state.starting = false;
    state.reference_mps = 2.0;
    state.steer_rad = std::atan(0.2 * wheelbase_m(vehicle));
    DriverView view;
    view.speed_mps = 2.0;
    view.roll_rad = roll_rad;
    drive(route, vehicle, view, 4800.0, 1e-6, state);
    return state.reference_mps;
  };
  constexpr double kRoll_rad = 0.05;
  const double left_mps2 = most_mps2 - kGravity_mps2 * std::sin(kRoll_rad);
  EXPECT_NEAR(reference_mps(kRoll_rad), std::sqrt(left_mps2 / 0.2), 1e-4);
  EXPECT_NEAR(reference_mps(-kRoll_rad), 2.0, 1e-4);
  // However steep, the driver goes on at half the speed of a level bend.
  EXPECT_NEAR(reference_mps(0.5), 0.5 * std::sqrt(most_mps2 / 0.2), 1e-4);
}

TEST(Driver, TurnsItsWheelsBeforeItMovesOff) {
  const Vehicle vehicle = load_vehicle("transplanter");
  Path path;
  test::extend(path, PathKind::kTurn, Gear::kForward, false, 5.0, 0.4);
  const Route route = make_route(path, vehicle);
  DriverState state = at_start(route, 0.1, kRate_hz);
  const double wanted_rad = std::atan(0.4 * wheelbase_m(vehicle));
  int steps = 0;
  while (state.starting && steps < 1000) {
    const DriverCommand command = drive(route, vehicle, {}, 600.0, 1.0 / kRate_hz, state);
    EXPECT_EQ(command.hold, state.starting);
    ++steps;
  }
  EXPECT_NEAR(state.steer_rad, wanted_rad, 0.06);
  // At the steering's rate, after its latency, up to 0.05 rad short of it.
  const double expected_s = 0.1 + (wanted_rad - 0.05) / vehicle.steering.max_rate_rad_per_s;
  EXPECT_NEAR(steps / kRate_hz, expected_s, 0.02);
}

// However slowly it comes and however much it speeds up.
TEST(Driver, HasTheImplementDownWhereWorkBegins) {
  const Vehicle vehicle = load_vehicle("transplanter");
  constexpr double kStep_m = 0.01;  // a step at work, and what it is beside its path
  for (const double ahead_m : {0.5, 1.0, 2.0, 4.0}) {
    Path path;
    test::extend(path, PathKind::kTransit, Gear::kForward, false, ahead_m, 0.0);
    test::extend(path, PathKind::kSwath, Gear::kForward, true, 1.0, 0.0);
    const RunRecord run = test::run(path, vehicle, test::plane(0.0, 0.0), test::soil_named("firm"));
    ASSERT_FALSE(run.footprints.empty());
    EXPECT_NEAR(run.footprints.front().left_W.x(), ahead_m + vehicle.implement.x_B_m, kStep_m)
        << ahead_m;
  }
}

}  // namespace
}  // namespace headland
