#include "sim/tyre.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRounding = 1e-9;

TEST(Tyres, SteadySlipFollowsTheLaw) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::plane(0.0, 0.0);
  const Soil soil = test::textbook_soil(0.6, 0.05);
  ChassisMass mass = chassis_mass(vehicle);
  const auto wheels = define_wheels(vehicle, mass);
  mass.mass_kg = 1e9;  // a rig that holds 1 m/s whatever the wheels do
  mass.inertia_kg_m2.setConstant(1e9);
  ChassisState chassis;
  chassis.v_W = {1.0, 0.0, 0.0};
  PerWheel<WheelContact> contacts;
  for (std::size_t i = 0; i < kWheels; ++i) {
    contacts[i].load_n = 1500.0;
    contacts[i].hub_arm = wheels[i].hub_C;
    contacts[i].lateral_arm = wheels[i].hub_C;
  }
  PerWheel<WheelState> states;
  PerWheel<WheelTorques> torques;
  for (std::size_t i = 0; i < kWheels; ++i) {
    states[i].spin_rad_per_s = 1.0 / wheels[i].radius_m;
    torques[i].drive_nm = 0.5 * 0.6 * 1500.0 * wheels[i].radius_m;  // half the grip
  }
  TyreResult result;
  for (int i = 0; i < 480; ++i) {
    result = solve_tyres(
        contacts, wheels, torques, soil, mass, chassis,
        chassis.v_W - Eigen::Vector3d(result.force_W.x(), 0, 0) / (240.0 * mass.mass_kg),
        chassis.omega_W, 1.0 / 240.0, states);
  }
  const double slip = 1.0 - 1.0 / (wheels[0].radius_m * states[0].spin_rad_per_s);
  const double by_law_n = 1500.0 * 0.6 * (1.0 - std::exp(-soil.slip_stiffness * slip));
  EXPECT_NEAR(result.along_n[0], by_law_n, 1e-3 * by_law_n);  // the rest of the transient
  // Drive torque less rolling resistance is what reaches the ground.
  EXPECT_NEAR(result.along_n[0], 1500.0 * (0.5 * 0.6 - 0.05), 1.0);
}

TEST(Tyres, CombinedForceStaysInTheFrictionCircle) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Soil soil = test::textbook_soil(0.5, 0.05);
  const ChassisMass mass = chassis_mass(vehicle);
  const auto wheels = define_wheels(vehicle, mass);
  ChassisState chassis;
  PerWheel<WheelContact> contacts;
  PerWheel<WheelTorques> torques;
  for (std::size_t i = 0; i < kWheels; ++i) {
    contacts[i].load_n = 1500.0;
    contacts[i].hub_arm = contacts[i].lateral_arm = wheels[i].hub_C;
    torques[i].drive_nm = 1000.0;
  }
  PerWheel<WheelState> states;
  for (int i = 0; i < 200; ++i) {
    const TyreResult result = solve_tyres(contacts, wheels, torques, soil, mass, chassis,
                                          {0.5, 2.0, 0.0}, chassis.omega_W, 1.0 / 240.0, states);
    for (std::size_t w = 0; w < kWheels; ++w) {
      EXPECT_LE(std::hypot(result.along_n[w], result.across_n[w]),
                0.5 * 1500.0 * (1.0 + kRounding));
    }
  }
}

TEST(Tyres, BrakedWheelLocksAndHoldsExactly) {
  const test::ParkedVehicle parked = test::park(load_vehicle("transplanter"), 0.2, 240.0);
  EXPECT_LT(parked.drift_mm_per_min, 0.1);  // the target for a braked vehicle on 20 %
  for (const WheelState& wheel : parked.wheels) EXPECT_NEAR(wheel.spin_rad_per_s, 0.0, 1e-5);
}

}  // namespace
}  // namespace headland
