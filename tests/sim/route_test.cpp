#include "sim/route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRounding = 1e-9;

Path line_then_arc(double curvature_per_m, Gear gear = Gear::kForward) {
  Path path;
  test::extend(path, PathKind::kTransit, gear, false, 10.0, 0.0);
  test::extend(path, PathKind::kUTurn, gear, false, 5.0, curvature_per_m);
  return path;
}

TEST(Route, SlowsForTheEndForCurvesAndChangesGearAtStandstill) {
  const Vehicle vehicle = load_vehicle("transplanter");
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 10.0, 0.0);
  test::extend(path, PathKind::kUTurn, Gear::kForward, false, 5.0, 0.4);
  test::extend(path, PathKind::kUTurn, Gear::kReverse, false, 3.0, -0.4);
  const Route route = make_route(path, vehicle);
  ASSERT_EQ(route.runs.size(), 2u);
  EXPECT_EQ(route.runs[1].gear, Gear::kReverse);
  for (const RouteRun& run : route.runs) {
    EXPECT_EQ(route.points[run.last].speed_limit_mps, 0.0);
    for (std::size_t i = run.first; i < run.last; ++i) {
      const RoutePoint& a = route.points[i];
      const RoutePoint& b = route.points[i + 1];
      EXPECT_LE(a.speed_limit_mps * a.speed_limit_mps,
                b.speed_limit_mps * b.speed_limit_mps +
                    2.0 * vehicle.driver.max_acceleration_mps2 * (b.along_m - a.along_m) + 1e-9);
      EXPECT_LE(a.speed_limit_mps, vehicle.driver.transit_speed_mps);
    }
  }
  EXPECT_NEAR(route.length_m, 18.0, 0.01);
  EXPECT_GT(route.expected_time_s, 18.0 / vehicle.driver.transit_speed_mps);
}

// On an arc the mean over the window is the arc's own curvature; between a line and an arc it is a
// ramp that turns by as much as the path does.
TEST(Route, CurvatureToSteerRampsAcrossAStepAndEndsWithThePathsHeading) {
  const Vehicle vehicle = load_vehicle("transplanter");
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    const Route route = make_route(line_then_arc(0.4, gear), vehicle);
    double turned_rad = 0.0;
    for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
      const RoutePoint& point = route.points[i];
      const RoutePoint& next = route.points[i + 1];
      const double wanted_per_m = std::clamp(0.4 * (point.along_m - 9.5), 0.0, 0.4);
      EXPECT_NEAR(point.curvature_per_m, wanted_per_m, 1e-3) << point.along_m;
      turned_rad +=
          0.5 * (point.curvature_per_m + next.curvature_per_m) * (next.along_m - point.along_m);
    }
    EXPECT_NEAR(turned_rad, 0.4 * 5.0, 1e-3);  // trapezoids of 0.1 m
  }
}

TEST(Route, LeavesTheSteeringTimeToFollowTheCurvature) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const Path path = test::rows_for(vehicle, 3, 20.0);
  const Route route = make_route(path, vehicle);
  const auto steer_rad = [&](const RoutePoint& point) {
    return std::atan(wheelbase_m(vehicle) * point.curvature_per_m);
  };
  const double rate = kSteeringRateShare * vehicle.steering.max_rate_rad_per_s;
  double fastest = 0.0;
  for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
    const RoutePoint& a = route.points[i];
    const RoutePoint& b = route.points[i + 1];
    const double per_m = std::abs(steer_rad(b) - steer_rad(a)) / (b.along_m - a.along_m);
    fastest = std::max(fastest, per_m * std::max(a.speed_limit_mps, b.speed_limit_mps));
  }
  EXPECT_LE(fastest, rate * (1.0 + kRounding));
  EXPECT_GT(fastest, 0.5 * rate);  // and uses it: the turns are not crept through
}

TEST(Route, PlacesMoveOnButNeverBackAndRunPastTheEnd) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Route route = make_route(test::straight(10.0), vehicle);
  RoutePlace place = start_of_run(route, 0);
  follow(route, {0.4, 0.3}, place);
  EXPECT_NEAR(place.along_m, 0.4, kRounding);
  EXPECT_NEAR(cross_track_m(route, place, {0.4, 0.3}), 0.3, kRounding);
  follow(route, {0.1, 0.0}, place);
  EXPECT_NEAR(place.along_m, 0.4, kRounding);
  for (int i = 4; i <= 103; ++i) follow(route, {0.1 * i, 0.0}, place);
  EXPECT_NEAR(place.along_m, 10.3, kRounding);
  EXPECT_NEAR(pose_at(route, place).p_W.x(), 10.3, kRounding);
}

}  // namespace
}  // namespace headland
