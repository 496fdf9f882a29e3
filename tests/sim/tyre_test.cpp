#include "sim/tyre.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kTyreRounding = 1e-9;

// A rig that holds 1 m/s whatever the wheels do, each loaded and driven alike until nothing
// changes.
struct RigResult {
  double slip = 0.0;
  double tyre_n = 0.0;  // of the tyre's contact
  double pull_n = 0.0;  // on the hub, after the soil's resistance
  WheelDefinition wheel;
};
RigResult steady_pull(const SoilMap& soil, double load_n, double drive_over_load) {
  const Vehicle vehicle = load_vehicle("transplanter");
  ChassisMass mass = chassis_mass(vehicle);
  const auto wheels = define_wheels(vehicle, mass);
  mass.mass_kg = 1e9;
  mass.inertia_kg_m2.setConstant(1e9);
  ChassisState chassis;
  chassis.v_W = {1.0, 0.0, 0.0};
  PerWheel<WheelContact> contacts;
  PerWheel<WheelState> states;
  PerWheel<WheelTorques> torques;
  for (std::size_t i = 0; i < kWheels; ++i) {
    contacts[i].load_n = load_n;
    contacts[i].deflection_m = load_n / wheels[i].stiffness_n_per_m;
    contacts[i].hub_arm = wheels[i].hub_C;
    contacts[i].lateral_arm = wheels[i].hub_C;
    states[i].spin_rad_per_s = 1.0 / wheels[i].radius_m;
    torques[i].drive_nm = drive_over_load * load_n * wheels[i].radius_m;
  }
  constexpr int kSteps = 720;  // 3 s: ten relaxation lengths
  TyreResult result;
  for (int i = 0; i < kSteps; ++i) {
    result = solve_tyres(
        contacts, wheels, torques, soil, mass, chassis,
        chassis.v_W - Eigen::Vector3d(result.force_W.x(), 0, 0) / (240.0 * mass.mass_kg),
        chassis.omega_W, 1.0 / 240.0, states);
  }
  return {1.0 - 1.0 / (wheels[0].radius_m * states[0].spin_rad_per_s), result.along_n[0],
          result.along_n[0] + result.soil_n[0], wheels[0]};
}

constexpr double kTransientLeft = 1e-3;  // of the force, after ten relaxation lengths

// The tyre law's own curve comes out of the implicit solver.
TEST(Tyres, SteadySlipFollowsTheLaw) {
  const RigResult rig = steady_pull(test::textbook_soil(0.6, 0.05), 1500.0, 0.3);
  const double by_law_n = 1500.0 * 0.6 * (1.0 - std::exp(-10.0 * rig.slip));
  EXPECT_NEAR(rig.tyre_n, by_law_n, kTransientLeft * by_law_n);
  // Drive torque less rolling resistance is what reaches the ground.
  EXPECT_NEAR(rig.pull_n, 1500.0 * (0.3 - 0.05), 1.0);
}

// On agricultural soil the drive torque fixes the slip by Brixius' gross traction, and the hub is
// pulled by his net traction at that slip.
TEST(Tyres, SteadyPullIsBrixiusNetTraction) {
  for (const char* name : {"firm", "tilled", "soft"}) {
    for (const double gross : {0.1, 0.3, 0.5}) {
      const double load_n = 2500.0;
      const RigResult rig = steady_pull(test::soil_named(name), load_n, gross);
      const Traction traction = traction_on(*find_soil(name), rig.wheel.tyre, load_n,
                                            load_n / rig.wheel.stiffness_n_per_m);
      const double slip =
          -std::log1p(-(gross - 0.04) / traction.full_pull) / traction.slip_stiffness;
      EXPECT_NEAR(rig.slip, slip, kTransientLeft) << name << ' ' << gross;
      EXPECT_NEAR(rig.pull_n, load_n * net_pull(traction, slip), kTransientLeft * load_n)
          << name << ' ' << gross;
    }
  }
}

TEST(Tyres, CombinedForceStaysInTheFrictionCircle) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const SoilMap soil = test::textbook_soil(0.5, 0.05);
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
                0.5 * 1500.0 * (1.0 + kTyreRounding));
    }
  }
  // Sliding sideways at 2 m/s all grip is used, and it holds against the slide.
  const TyreResult sliding = solve_tyres(contacts, wheels, torques, soil, mass, chassis,
                                         {0.5, 2.0, 0.0}, chassis.omega_W, 1.0 / 240.0, states);
  for (std::size_t w = 0; w < kWheels; ++w) {
    EXPECT_GE(std::hypot(sliding.along_n[w], sliding.across_n[w]), 0.95 * 0.5 * 1500.0);
    EXPECT_LT(sliding.across_n[w], 0.0);
  }
}

TEST(Tyres, BrakedWheelLocksAndHoldsExactly) {
  const test::ParkedVehicle parked = test::park(load_vehicle("transplanter"), 0.2, 240.0);
  EXPECT_LT(parked.drift_mm_per_min, 0.1);  // the target for a braked vehicle on 20 %
  for (const WheelState& wheel : parked.wheels) EXPECT_NEAR(wheel.spin_rad_per_s, 0.0, 1e-5);
}

}  // namespace
}  // namespace headland
