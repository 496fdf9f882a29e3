#include "sim/bullet_world.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

TEST(BulletWorld, FallsAsGravityPullsItWithoutDamping) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.0, 0.0);
  BulletWorld world(test::open_field(), terrain, vehicle);
  ChassisState high;
  high.p_WC = {0.0, 0.0, 50.0};
  world.set_state(high);
  constexpr double kDt = 1.0 / 240.0;
  for (int i = 0; i < 240; ++i) world.step(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kDt);
  const ChassisState after = world.state();
  // Semi-implicit Euler: v = g t exactly, the fall is g t (t + dt) / 2. Rounding only.
  constexpr double kRounding = 1e-9;
  EXPECT_NEAR(after.v_W.z(), -kGravity_mps2, kRounding);
  EXPECT_NEAR(50.0 - after.p_WC.z(), 0.5 * kGravity_mps2 * (1.0 + kDt), kRounding);
}

TEST(BulletWorld, ForceAndTorqueActOnceAStep) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.0, 0.0);
  const ChassisMass mass = chassis_mass(vehicle);
  BulletWorld world(test::open_field(), terrain, vehicle);
  ChassisState high;
  high.p_WC = {0.0, 0.0, 50.0};
  world.set_state(high);
  const Eigen::Vector3d weight(0.0, 0.0, mass.mass_kg * kGravity_mps2);
  const Eigen::Vector3d yaw_torque(0.0, 0.0, 0.1 * mass.inertia_kg_m2.z());
  for (int i = 0; i < 240; ++i) {
    world.step(weight + Eigen::Vector3d(mass.mass_kg, 0.0, 0.0), yaw_torque, 1.0 / 240.0);
  }
  constexpr double kRounding = 1e-9;
  EXPECT_NEAR(world.state().v_W.x(), 1.0, kRounding);
  EXPECT_NEAR(world.state().v_W.z(), 0.0, kRounding);
  EXPECT_NEAR(world.state().omega_W.z(), 0.1, kRounding);
}

TEST(BulletWorld, CollidesWithTheOneSurface) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::hills(2.0, 9.0, 30.0, 1.5);
  const BulletWorld world(test::open_field(25.0), terrain, vehicle);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-29.0, 29.0);
  // The ray is 20 km long: its hit fraction carries about 1e-12 of that.
  constexpr double kRayResolution_m = 1e-6;
  for (int i = 0; i < 2000; ++i) {
    const double x = place(random);
    const double y = place(random);
    const auto hit = world.ray_cast_height(x, y);
    ASSERT_TRUE(hit.has_value()) << x << ", " << y;
    ASSERT_NEAR(*hit, surface_at(terrain, x, y).height_m, kRayResolution_m) << x << ", " << y;
  }
}

TEST(BulletWorld, ReportsTheObstacleThatTheHullTouches) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.0, 0.0);
  Field field = test::open_field();
  field.obstacles.push_back({ObstacleKind::kPole, {50.0, 0.0}, 0.1, 3.0});
  field.obstacles.push_back({ObstacleKind::kTree, {20.0, 10.0}, 0.3, 5.0});
  field.obstacles.push_back({ObstacleKind::kWall, {-40.0, 20.0}, 0.2, 1.0, {20.0, 20.0}});
  const ChassisMass mass = chassis_mass(vehicle);
  const auto touched_at = [&](double x, double y) {
    BulletWorld world(field, terrain, vehicle);
    ChassisState state;
    state.p_WC = Eigen::Vector3d(x, y, 0.0) + mass.com_B;
    world.set_state(state);
    world.step(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1e-4);
    return world.touched_obstacle();
  };
  EXPECT_EQ(touched_at(49.0, 0.0), std::optional<std::size_t>(0));
  EXPECT_EQ(touched_at(19.0, 9.5), std::optional<std::size_t>(1));
  EXPECT_EQ(touched_at(-30.0, 30.0), std::optional<std::size_t>(2));
  EXPECT_EQ(touched_at(-40.0, 40.0), std::nullopt) << "in the corner of the wall's box";
  EXPECT_EQ(touched_at(0.0, 0.0), std::nullopt);
}

}  // namespace
}  // namespace headland
