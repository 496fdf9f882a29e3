#include "sim/wheel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/machine.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kWheelRounding = 1e-9;

TEST(Wheels, StaticLoadsCarryTheWeightByTheLeverRule) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const Heightfield terrain = test::plane(0.0, 0.0);
  const SoilMap soil = test::textbook_soil();
  const Machine machine = make_machine(vehicle, terrain, soil);
  const ChassisState chassis = place_on_ground(machine, {0.0, 0.0}, 0.3);
  const auto contacts = touch_ground(terrain, chassis, machine.wheels, 0.0);
  double total_n = 0.0;
  for (const WheelContact& contact : contacts) total_n += contact.load_n;
  const double weight_n = machine.mass.mass_kg * kGravity_mps2;
  EXPECT_NEAR(total_n, weight_n, kWheelRounding * weight_n);
  const double front_n = contacts[2].load_n + contacts[3].load_n;
  EXPECT_NEAR(front_n, weight_n * machine.mass.com_B.x() / wheelbase_m(vehicle),
              kWheelRounding * weight_n);
}

// A contact point straight below the hub would let the normal force drive the vehicle uphill.
TEST(Wheels, NormalForceHasNoMomentAboutTheHub) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.25, -0.15);
  const SoilMap soil = test::textbook_soil();
  const Machine machine = make_machine(vehicle, terrain, soil);
  const ChassisState chassis = place_on_ground(machine, {3.0, 4.0}, 0.7);
  for (const WheelContact& contact :
       touch_ground(terrain, chassis, machine.wheels, curvature_of(vehicle, 0.1))) {
    ASSERT_GT(contact.load_n, 0.0);
    const Eigen::Vector3d force = contact.load_n * contact.normal;
    EXPECT_NEAR((contact.normal_arm - contact.hub_arm).cross(force).norm(), 0.0, kWheelRounding);
    EXPECT_NEAR(contact.normal.dot(Eigen::Vector3d(-0.25, 0.15, 1.0).normalized()), 1.0,
                kWheelRounding);
    EXPECT_NEAR(contact.along.dot(contact.normal), 0.0, kWheelRounding);
  }
}

// On ice without rolling resistance nothing but the slope's pull may act: a = -g sin(slope).
TEST(Wheels, NormalForcesGiveNoPropulsionUphill) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.1, 0.0);
  const SoilMap ice = test::textbook_soil(0.0, 0.0);
  const Machine machine = make_machine(vehicle, terrain, ice);
  BulletWorld world(test::open_field(), terrain, vehicle);
  world.set_state(place_on_ground(machine, {0.0, 0.0}, 0.0));
  MachineState state;
  DriverCommand coasting;
  constexpr int kSteps = 480;
  for (int i = 0; i < kSteps; ++i) {
    step_machine(machine, coasting, {}, 0.0, 1.0 / 240.0, world, state);
  }
  const double slope_rad = std::atan(0.1);
  const double expected_mps = -kGravity_mps2 * std::sin(slope_rad) * 2.0;
  const ChassisState after = world.state();
  // 0.2 %: the springs still swing a little after two seconds.
  EXPECT_NEAR(after.v_W.dot(after.R_WB.col(0)), expected_mps, 0.002 * std::abs(expected_mps));
}

// All axles' lines meet at one centre, 1/curvature to the left of B's origin.
TEST(Wheels, AckermannMeetsAtOneCentre) {
  constexpr double kCurvature_per_m = 0.25;
  for (const Eigen::Vector2d& p_B :
       {Eigen::Vector2d(2.0, 0.8), Eigen::Vector2d(2.0, -0.8), Eigen::Vector2d(-1.0, 0.8)}) {
    const double angle = wheel_angle_rad(kCurvature_per_m, p_B);
    const Eigen::Vector2d to_centre = Eigen::Vector2d(0.0, 1.0 / kCurvature_per_m) - p_B;
    EXPECT_NEAR(to_centre.dot(Eigen::Vector2d(std::cos(angle), std::sin(angle))), 0.0,
                kWheelRounding);
    EXPECT_EQ(wheel_angle_rad(-kCurvature_per_m, {p_B.x(), -p_B.y()}), -angle);
  }
  EXPECT_EQ(wheel_angle_rad(kCurvature_per_m, {0.0, 0.8}), 0.0) << "the axle that follows the path";
}

TEST(Wheels, PivotedAxleSharesItsLoadEquallyUpToItsStop) {
  Vehicle vehicle = load_vehicle("transplanter");
  // A ridge under the left wheels only: the body, placed by its mean, twists the axles.
  Heightfield terrain = test::plane(0.0, 0.0, 20.0);
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const double x = terrain.origin_W.x() + i * terrain.cell_m;
      const double y = terrain.origin_W.y() + j * terrain.cell_m;
      terrain.height_m[static_cast<std::size_t>(j * terrain.columns + i)] = 0.01 * x * y;
    }
  }
  const SoilMap soil = test::textbook_soil();
  const auto loads = [&](double oscillation_rad) {
    vehicle.front.oscillation_max_rad = oscillation_rad;
    const Machine machine = make_machine(vehicle, terrain, soil);
    const auto contacts =
        touch_ground(terrain, place_on_ground(machine, {0.0, 0.0}, 0.0), machine.wheels, 0.0);
    return std::pair(contacts[2].load_n, contacts[3].load_n);
  };
  // The two wheels stand on slopes of opposite sign: their normals differ, their springs do not.
  constexpr double kNormalScale = 1e-3;
  const auto [free_left, free_right] = loads(0.2);
  EXPECT_NEAR(free_left, free_right, kNormalScale * free_left);
  const auto [rigid_left, rigid_right] = loads(0.0);
  EXPECT_GT(std::abs(rigid_left - rigid_right), 0.2 * free_left);
  const auto [stopped_left, stopped_right] = loads(0.002);
  EXPECT_GT(std::abs(stopped_left - stopped_right), 0.1 * free_left);
  EXPECT_LT(std::abs(stopped_left - stopped_right), std::abs(rigid_left - rigid_right));
}

}  // namespace
}  // namespace headland
