#include "sim/stability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/chassis.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kHuge_kg_m2 = 1e12;

// Heave alone: one mass on four equal tyres, too heavy to turn.
Vehicle heaving(double stiffness_n_per_m, double damping_n_s_per_m) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.body.inertia_kg_m2.setConstant(kHuge_kg_m2);
  for (Axle* axle : {&vehicle.rear, &vehicle.front}) {
    axle->vertical_stiffness_n_per_m = stiffness_n_per_m;
    axle->vertical_damping_n_s_per_m = damping_n_s_per_m;
  }
  return vehicle;
}

// Jury's criterion of the step v += a dt, x += v dt: k dt^2 / m + 2 c dt / m = 4.
TEST(Stability, OfOneModeEndsWhereJurySays) {
  constexpr double kRate_hz = 240.0;
  const double mass_kg = chassis_mass(heaving(1.0, 0.0)).mass_kg;
  for (const double by_stiffness : {0.0, 0.5, 1.0}) {
    const double stiffness = by_stiffness * 4.0 * mass_kg * kRate_hz * kRate_hz / 4.0;
    const double damping = (1.0 - by_stiffness) * 2.0 * mass_kg * kRate_hz / 4.0;
    EXPECT_LE(growth_per_step(heaving(0.99 * stiffness, 0.99 * damping), kRate_hz), 1.0 + 1e-6);
    EXPECT_GT(growth_per_step(heaving(1.01 * stiffness, 1.01 * damping), kRate_hz), 1.0 + 1e-3);
  }
}

TEST(Stability, TakesTheBuiltInVehiclesAtEveryRate) {
  for (const std::string& name : vehicle_names()) {
    const Vehicle vehicle = load_vehicle(name);
    for (const double rate_hz : {60.0, 61.0, 120.0, 240.0, 1000.0}) {
      EXPECT_NO_THROW(require_stable(vehicle, rate_hz)) << name << " at " << rate_hz;
    }
  }
}

std::string refusal(const Vehicle& vehicle, double rate_hz) {
  try {
    require_stable(vehicle, rate_hz);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Stability, RefusesTyresThatWouldThrowTheVehicleUpByKeyAndRate) {
  using testing::AllOf;
  using testing::HasSubstr;
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.rear.vertical_stiffness_n_per_m = 1e8;
  EXPECT_THAT(refusal(vehicle, 240.0),
              AllOf(HasSubstr("rear_tyres.vertical_stiffness_n_per_m"), HasSubstr("240 steps"),
                    HasSubstr("a rate of at least")));
  vehicle.rear.vertical_stiffness_n_per_m = 1e9;
  EXPECT_THAT(refusal(vehicle, 240.0), HasSubstr("no rate up to 1000 Hz"));
  vehicle.rear.vertical_stiffness_n_per_m = 2e6;
  EXPECT_THAT(refusal(vehicle, 60.0), HasSubstr("a rate of at least"));
  for (const double damping_n_s_per_m : {1e5, 1e6}) {
    vehicle = load_vehicle("transplanter");
    vehicle.front.vertical_damping_n_s_per_m = damping_n_s_per_m;
    EXPECT_THAT(refusal(vehicle, 240.0), HasSubstr("front_tyres.vertical_damping_n_s_per_m"));
  }
  vehicle = load_vehicle("utility_tractor_trailed");
  vehicle.implement.trailing->vertical_stiffness_n_per_m = 1e8;
  EXPECT_THAT(refusal(vehicle, 240.0), HasSubstr("trailing.vertical_stiffness_n_per_m"));
}

}  // namespace
}  // namespace headland
