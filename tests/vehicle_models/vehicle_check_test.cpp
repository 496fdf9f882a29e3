#include "vehicle_models/vehicle_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// What the check says about the plain test vehicle after one change; empty when it takes it.
std::string refusal(const std::function<void(Vehicle&)>& change) {
  Vehicle vehicle =
      load_vehicle((std::filesystem::path(HEADLAND_TEST_DATA) / "vehicles/plain").string());
  change(vehicle);
  try {
    check_vehicle(vehicle, "test");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(VehicleCheck, TakesThePlainVehicle) {
  EXPECT_EQ(refusal([](Vehicle&) {}), "");
}

TEST(VehicleCheck, RefusesInertiaThatNoBodyHas) {
  const auto zero = [](Vehicle& v) { v.body.inertia_kg_m2.setZero(); };
  EXPECT_THAT(refusal(zero), AllOf(HasSubstr("inertia [kg m2]: '0'"), HasSubstr("above 0")));
  const auto impossible = [](Vehicle& v) { v.body.inertia_kg_m2 = {100.0, 100.0, 201.0}; };
  EXPECT_THAT(refusal(impossible),
              AllOf(HasSubstr("inertia [kg m2]: '201'"), HasSubstr("sum of the other two")));
}

TEST(VehicleCheck, RefusesACentreOfMassOutsideTheWheelbaseOrTheHull) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.com_B.x() = -0.1; }),
              AllOf(HasSubstr("centre of mass [m]: '-0.1'"), HasSubstr("x in (0, 1.4) m")));
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.com_B.x() = 1.5; }), HasSubstr("between the axles"));
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.com_B.z() = 1.8; }), HasSubstr("z below 1.75 m"));
}

// Measuring and planning lay circles of this radius.
TEST(VehicleCheck, RefusesSteeringThatHardlyTurns) {
  for (const double angle_rad : {1e-12, 0.01}) {
    EXPECT_THAT(refusal([&](Vehicle& v) { v.steering.max_angle_rad = angle_rad; }),
                AllOf(HasSubstr("steering limits [deg]"), HasSubstr("at most 100 m")));
  }
  EXPECT_EQ(refusal([](Vehicle& v) { v.steering.max_angle_rad = 0.02; }), "");
}

TEST(VehicleCheck, RefusesAHullThatDoesNotFitTogether) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.ground_clearance_m = 1.8; }),
              AllOf(HasSubstr("ground clearance [m]: '1.8'"), HasSubstr("1.75 m")));
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.rear_overhang_m = 3.1; }),
              AllOf(HasSubstr("hull behind frame B [m]: '3.1'"), HasSubstr("3.05 m")));
}

TEST(VehicleCheck, RefusesWheelsThatHangBelowTheHull) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.front.radius_m = 0.2; }),
              AllOf(HasSubstr("front wheel radius [m]: '0.2'"), HasSubstr("0.28 m")));
}

TEST(VehicleCheck, RefusesTyresThatSagTooFar) {
  EXPECT_THAT(
      refusal([](Vehicle& v) { v.rear.vertical_stiffness_n_per_m = 20000.0; }),
      AllOf(HasSubstr("rear_tyres.vertical_stiffness_n_per_m: '20000'"), HasSubstr("0.10 m")));
}

TEST(VehicleCheck, RefusesAnImplementThatLiftsTheFrontAxle) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.implement.mass_kg = 400.0; }),
              AllOf(HasSubstr("implement.mass_kg: '400'"), HasSubstr("at least 10 %")));
}

TEST(VehicleCheck, RefusesAVehicleWithoutDriveOrWithTwoRadiiOnOneGear) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.rear.driven = false; }),
              HasSubstr("at least one axle must be driven"));
  EXPECT_THAT(refusal([](Vehicle& v) { v.front.driven = true; }),
              AllOf(HasSubstr("front wheel radius [m]: '0.3'"), HasSubstr("0.34 m")));
  const auto equal = [](Vehicle& v) {
    v.front.driven = true;
    v.front.radius_m = v.rear.radius_m;
  };
  EXPECT_EQ(refusal(equal), "");
}

TEST(VehicleCheck, SaysTheSpeedThatAGearReachesAndTheGearThatWouldDo) {
  // 260 rad/s / 100 * 0.34 m = 0.88 m/s; the driver's fastest is 1.2 m/s in transit.
  EXPECT_THAT(refusal([](Vehicle& v) { v.drivetrain.gear_ratio = 100.0; }),
              AllOf(HasSubstr("drivetrain.gear_ratio: '100'"), HasSubstr("reaches 0.88 m/s"),
                    HasSubstr("wants 1.20 m/s"), HasSubstr("at most 73.7")));
}

TEST(VehicleCheck, RefusesAnImplementThatTheMotorCannotPull) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.implement.draft_n_per_m = 5000.0; }),
              AllOf(HasSubstr("implement.draft_n_per_m: '5000'"), HasSubstr("draws 10000 N")));
}

TEST(VehicleCheck, RefusesBrakesThatDoNotHold) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.drivetrain.brake_torque_max_nm = 300.0; }),
              AllOf(HasSubstr("drivetrain.brake_torque_max_nm: '300'"), HasSubstr("20 % slope")));
}

TEST(VehicleCheck, RefusesABatteryThatCannotFeedTheMotor) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.battery.resistance_ohm = 1.0; }),
              AllOf(HasSubstr("battery.resistance_ohm: '1'"), HasSubstr("gives at most 0.6 kW"),
                    HasSubstr("draw up to 4.5 kW")));
}

TEST(VehicleCheck, RefusesWeightBesideTheWheelsAndBeforeThem) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.body.com_B.y() = -1.0; }),
              AllOf(HasSubstr("centre of mass [m]: '-1'"), HasSubstr("y within")));
  EXPECT_THAT(refusal([](Vehicle& v) { v.implement.x_B_m = 9.0; }),
              AllOf(HasSubstr("implement.mass_kg"), HasSubstr("the rear axle carries")));
}

TEST(VehicleCheck, RefusesSteeringWithoutItsNumbers) {
  EXPECT_THAT(refusal([](Vehicle& v) { v.steering.max_rate_rad_per_s = 0.0; }),
              AllOf(HasSubstr("steering.max_rate_deg_per_s"), HasSubstr("missing key")));
  const auto skid = [](double yaw_rate, double radius_m, bool per_wheel) {
    return refusal([=](Vehicle& v) {
      v.steering = {};
      v.steering.kind = SteeringKind::kSkid;
      v.steering.max_yaw_rate_rad_per_s = yaw_rate;
      v.steering.turning_radius_m = radius_m;
      const double shift_m = 0.5 * v.front.x_B_m;  // to the middle between the axles
      v.rear.x_B_m = -shift_m;
      v.front.x_B_m = shift_m;
      v.body.com_B.x() -= shift_m;
      v.implement.x_B_m -= shift_m;
      v.front.driven = true;
      v.front.radius_m = v.rear.radius_m;
      v.drivetrain.motor_per_wheel = per_wheel;
    });
  };
  EXPECT_THAT(skid(0.0, 1.0, true), HasSubstr("steering.max_yaw_rate_deg_per_s"));
  EXPECT_THAT(skid(1.0, 0.0, true), HasSubstr("steering.turning_radius_m"));
  EXPECT_THAT(refusal([](Vehicle& v) { v.steering.turning_radius_m = 1.0; }),
              AllOf(HasSubstr("steering.turning_radius_m"), HasSubstr("only for skid steering")));
  EXPECT_THAT(skid(1.0, 1.0, false),
              AllOf(HasSubstr("drivetrain.driven"), HasSubstr("must be per_wheel")));
}

}  // namespace
}  // namespace headland
