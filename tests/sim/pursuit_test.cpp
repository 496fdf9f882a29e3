#include "sim/pursuit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

DriverView standing_at(const RoutePose& pose) {
  DriverView view;
  view.p_W = pose.p_W;
  view.yaw_rad = pose.heading_rad;
  return view;
}

RoutePlace place_at(const Route& route, double along_m) {
  RoutePlace place = start_of_run(route, 0);
  while (route.points[place.index + 1].along_m < along_m) ++place.index;
  place.along_m = along_m;
  return place;
}

TEST(Pursuit, SteersByThePathAloneWhereTheVehicleIsOnIt) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  Path path;
  test::extend(path, PathKind::kTransit, Gear::kForward, false, 5.0, 0.0);
  test::extend(path, PathKind::kUTurn, Gear::kForward, false, 10.0, -0.2);
  const Route route = make_route(path, vehicle);
  for (const double along_m : {1.0, 4.0, 5.0, 6.0, 10.0, 14.0}) {
    const RoutePlace place = place_at(route, along_m);
    const RoutePose pose = pose_at(route, place);
    EXPECT_NEAR(steer_along(route, place, vehicle, standing_at(pose), {}, 0.0),
                std::atan(wheelbase_m(vehicle) * pose.curvature_per_m), 1e-9)
        << along_m;
  }
}

// Small errors on a line: curvature -(2 / l^2) offset - (2 / l) angle.
TEST(Pursuit, CorrectsByTheGainsOfPurePursuit) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Route route = make_route(test::straight(20.0), vehicle);
  const RoutePlace place = place_at(route, 5.0);
  const double ahead_m = vehicle.driver.look_ahead_m;
  const auto curvature = [&](double offset_m, double angle_rad) {
    DriverView view = standing_at(pose_at(route, place));
    view.p_W.y() += offset_m;
    view.yaw_rad += angle_rad;
    return std::tan(steer_along(route, place, vehicle, view, {}, 0.0)) / wheelbase_m(vehicle);
  };
  constexpr double kSmall = 1e-4;
  constexpr double kSecondOrder = 1e-3;  // relative
  EXPECT_NEAR(curvature(kSmall, 0.0), -2.0 / (ahead_m * ahead_m) * kSmall, kSecondOrder * kSmall);
  EXPECT_NEAR(curvature(0.0, kSmall), -2.0 / ahead_m * kSmall, kSecondOrder * kSmall);
}

TEST(Pursuit, TurnsHardTowardsAPlaceBehindIt) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Route route = make_route(test::straight(20.0), vehicle);
  DriverView view;
  view.yaw_rad = 2.5;
  EXPECT_EQ(steer_along(route, start_of_run(route, 0), vehicle, view, {}, 0.0),
            -vehicle.steering.max_angle_rad);
}

// Crabbing by 0.05 rad and steering that turns 0.02 rad less than asked, in both gears.
TEST(Pursuit, LearnsSideslipAndSteeringBias) {
  const Vehicle vehicle = load_vehicle("transplanter");
  for (const double speed_mps : {1.0, -1.0}) {
    DriverView view;
    view.speed_mps = speed_mps;
    view.course_mps = {speed_mps, speed_mps * std::tan(0.05)};
    view.yaw_rate_rad_per_s = speed_mps * std::tan(0.1 - 0.02) / wheelbase_m(vehicle);
    SteeringBias bias;
    for (int i = 0; i < 2400; ++i) learn_bias(vehicle, view, 0.1, 1.0 / 240.0, bias);
    EXPECT_NEAR(bias.sideslip_rad, 0.05, 1e-6);
    EXPECT_NEAR(bias.steer_rad, 0.02, 1e-6);
    view.course_mps.setZero();  // standing: nothing to learn from
    learn_bias(vehicle, view, 0.1, 1.0, bias);
    EXPECT_NEAR(bias.sideslip_rad, 0.05, 1e-6);
  }
}

TEST(Pursuit, CarriesAnOldPositionOn) {
  DriverView view;
  view.p_W = {1.0, 2.0};
  view.yaw_rad = 0.5 * std::numbers::pi;
  view.course_mps = {2.0, 0.5};
  view.age_s = 0.1;
  EXPECT_NEAR((position_now(view) - Eigen::Vector2d(0.95, 2.2)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace headland
