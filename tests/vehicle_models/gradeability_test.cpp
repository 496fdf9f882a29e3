#include "vehicle_models/gradeability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "terrains/soil.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kClimbExact = 1e-9;  // of the slope: bisection to the last digits
constexpr double kRolling = 0.05;
constexpr double kSlipConstant = 10.0;

// The law of the papers: mu N (1 - exp(-c s)) whatever the load, and Crr N in the tyre, which a
// driven wheel's torque overcomes beside its pull.
Soil papers_ground(double friction) {
  return {"papers", ConstantGround{friction, kRolling, kSlipConstant}, 0.09, ""};
}
double best_of(double friction) { return friction * (1.0 - std::exp(-kSlipConstant)); }

TEST(Gradeability, IsGripsAloneForAStrongMotor) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.motor.max_torque_nm *= 100.0;
  EXPECT_NEAR(gradeability(vehicle, papers_ground(0.4)),
              max_grade_by_grip(vehicle, best_of(0.4), kRolling), kClimbExact);
}

TEST(Gradeability, IsTheMotorsAloneOnGroundThatHolds) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.motor.max_torque_nm *= 0.3;
  EXPECT_NEAR(gradeability(vehicle, papers_ground(5.0)), max_grade(vehicle, kRolling), 1e-6);
}

struct Standing {
  double weight_n = 0.0;
  double slope_rad = 0.0;
  double front_n = 0.0;
  double rear_n = 0.0;
};

// The lever rule about the rear wheels' contact.
Standing standing_on(const Vehicle& vehicle, double grade) {
  Standing on{kGravity_mps2 * total_mass_kg(vehicle), std::atan(grade)};
  const Eigen::Vector3d com_B = total_com_B(vehicle);
  on.front_n = on.weight_n *
               ((com_B.x() - vehicle.rear.x_B_m) * std::cos(on.slope_rad) -
                com_B.z() * std::sin(on.slope_rad)) /
               wheelbase_m(vehicle);
  on.rear_n = on.weight_n * std::cos(on.slope_rad) - on.front_n;
  return on;
}

// Motors at the wheels: the rear ones at their torque, the front ones at the grip that the slope
// leaves them, together less than either limit alone.
TEST(Gradeability, AddsWhatEachAxleCan) {
  const Vehicle vehicle = load_vehicle("four_wheel_steer_robot");
  constexpr double kFriction = 0.6;
  const double grade = gradeability(vehicle, papers_ground(kFriction));
  const Standing on = standing_on(vehicle, grade);
  const double rear_n = 0.5 * drive_force_n(vehicle, 0.0) - kRolling * on.rear_n;
  EXPECT_NEAR((rear_n + best_of(kFriction) * on.front_n) / on.weight_n, std::sin(on.slope_rad),
              kClimbExact);
  EXPECT_LT(grade, 0.95 * max_grade(vehicle, kRolling));
  EXPECT_LT(grade, 0.95 * max_grade_by_grip(vehicle, best_of(kFriction), kRolling));
}

// With open differentials the front wheels set what the rear ones get.
TEST(Gradeability, OneMotorPullsAsTheLightestWheelLets) {
  constexpr double kFriction = 0.6;
  Vehicle vehicle = load_vehicle("four_wheel_steer_robot");
  const double apart = gradeability(vehicle, papers_ground(kFriction));
  vehicle.motor.max_torque_nm *= 4.0;
  vehicle.drivetrain.motor_per_wheel = false;
  const double grade = gradeability(vehicle, papers_ground(kFriction));
  const Standing on = standing_on(vehicle, grade);
  const double each_n = (best_of(kFriction) + kRolling) * on.front_n;
  EXPECT_NEAR((2.0 * each_n - kRolling * (on.front_n + on.rear_n)) / on.weight_n,
              std::sin(on.slope_rad), kClimbExact);
  EXPECT_LT(grade, apart);
}

TEST(Gradeability, EndsWhereTheFrontWheelsLiftAndIsNoneWithoutPull) {
  // Its front wheels roll, at 0.05 of their load, and its rear ones grip 0.01 of theirs.
  EXPECT_EQ(gradeability(load_vehicle("transplanter"), papers_ground(0.01)), 0.0);
  Vehicle vehicle = load_vehicle("skid_steer_robot");
  vehicle.motor.max_torque_nm *= 100.0;
  EXPECT_NEAR(gradeability(vehicle, papers_ground(3.0)),
              std::tan(nose_up_stability_angle_rad(vehicle)), 1e-6);
}

// On the papers' ground soil and implement may name the same resistance.
TEST(Gradeability, RollsATrailedImplementByItsOwnResistance) {
  const auto climbs = [](double own) {
    Vehicle vehicle = load_vehicle("utility_tractor_trailed");
    vehicle.implement.trailing->rolling_resistance = own;
    return gradeability(vehicle, papers_ground(0.6));
  };
  EXPECT_NEAR(climbs(kRolling), climbs(0.0), kClimbExact);
  EXPECT_LT(climbs(2.0 * kRolling), climbs(kRolling) - 1e-3);
}

}  // namespace
}  // namespace headland
