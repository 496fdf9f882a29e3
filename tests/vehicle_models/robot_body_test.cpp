// Geometry, mass and running gear out of a robot description, against sums done by hand.
#include "vehicle_models/robot_body.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/vehicle_models/changed_vehicle.h"
#include "vehicle_models/running_gear.h"

namespace headland {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Numbers in the plain vehicle's file have six digits.
constexpr double kWritten = 1e-5;

TEST(RobotBody, ComposesTheLinksByParallelAxes) {
  // The plain file's links are 464 kg of body and four wheels, chosen to make 520 kg spread evenly
  // over 2.6 x 1.6 x 1.2 m about (0.6, 0, 0.62), rounded.
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_NEAR(vehicle.body.mass_kg, 520.0, 1e-9);
  EXPECT_NEAR(vehicle.body.com_B.x(), 0.6, kWritten);
  EXPECT_NEAR(vehicle.body.com_B.y(), 0.0, kWritten);
  EXPECT_NEAR(vehicle.body.com_B.z(), 0.62, kWritten);
  EXPECT_NEAR(vehicle.body.inertia_kg_m2.x(), 175.0, 1e3 * kWritten);
  EXPECT_NEAR(vehicle.body.inertia_kg_m2.y(), 355.0, 1e3 * kWritten);
  EXPECT_NEAR(vehicle.body.inertia_kg_m2.z(), 405.0, 1e3 * kWritten);
}

TEST(RobotBody, ComposesTwoPointLikeMassesToADumbbell) {
  // Two masses of 10 kg, 2 m apart across a cart of four 1 kg wheels: by hand, about the middle.
  Robot robot;
  const auto add = [&](double mass_kg, const Eigen::Vector3d& place) {
    RobotLink link;
    link.mass_kg = mass_kg;
    link.com_R = place;
    link.inertia_R_kg_m2 = 1e-3 * Eigen::Matrix3d::Identity();
    robot.links.push_back(link);
  };
  add(10.0, {0.5, 1.0, 0.5});
  add(10.0, {0.5, -1.0, 0.5});
  Shape hull;
  robot.links[0].collisions = {hull};
  RunningGear gear;
  for (Wheel& wheel : gear.wheels) wheel.link = 7;  // none of the two
  gear.origin_R = {-1.0, 0.0, -2.0};
  const Body body = body_of(robot, gear);
  EXPECT_NEAR((body.com_B - Eigen::Vector3d(1.5, 0.0, 2.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(body.inertia_kg_m2.x(), 2 * 10.0 + 2e-3, 1e-12);
  EXPECT_NEAR(body.inertia_kg_m2.y(), 2e-3, 1e-12);
  EXPECT_NEAR(body.inertia_kg_m2.z(), 2 * 10.0 + 2e-3, 1e-12);
}

TEST(RobotBody, FindsAxlesWheelsAndHull) {
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_EQ(vehicle.rear.x_B_m, 0.0);
  EXPECT_NEAR(vehicle.front.x_B_m, 1.4, 1e-12);
  EXPECT_NEAR(vehicle.rear.track_m, 1.5, 1e-12);
  EXPECT_NEAR(vehicle.rear.radius_m, 0.34, 1e-12);
  EXPECT_NEAR(vehicle.front.radius_m, 0.30, 1e-12);
  EXPECT_NEAR(vehicle.rear.width_m, 0.16, 1e-12);
  EXPECT_NEAR(vehicle.rear.wheel_inertia_kg_m2, 1.0, 1e-12);
  EXPECT_NEAR(vehicle.body.length_m, 3.05, 1e-9);
  EXPECT_NEAR(vehicle.body.width_m, 2.0, 1e-9);
  EXPECT_NEAR(vehicle.body.height_m, 1.75, 1e-9);
  EXPECT_NEAR(vehicle.body.rear_overhang_m, 0.95, 1e-9);
  EXPECT_NEAR(vehicle.body.ground_clearance_m, 0.28, 1e-9);
}

TEST(RobotBody, DoesNotCareWhereTheRootLinkIs) {
  // The same machine with its root 2 m ahead, 1 m to the left and 3 m above frame B.
  const ChangedVehicle changed("vehicle.urdf", "<link name=\"base_link\">",
                               "<link name=\"root\"/><joint name=\"down\" type=\"fixed\">"
                               "<parent link=\"root\"/><child link=\"base_link\"/>"
                               "<origin xyz=\"-2 -1 -3\"/></joint><link name=\"base_link\">");
  const Vehicle here = load_vehicle(kPlain.string());
  const Vehicle there = load_vehicle(changed.folder());
  EXPECT_NEAR((here.body.com_B - there.body.com_B).norm(), 0.0, 1e-9);
  EXPECT_NEAR((here.body.inertia_kg_m2 - there.body.inertia_kg_m2).norm(), 0.0, 1e-7);
  EXPECT_NEAR(here.front.x_B_m, there.front.x_B_m, 1e-12);
  EXPECT_NEAR(here.body.rear_overhang_m, there.body.rear_overhang_m, 1e-12);
  EXPECT_NEAR(here.body.ground_clearance_m, there.body.ground_clearance_m, 1e-12);
  EXPECT_TRUE(here.shapes[0].X.isApprox(there.shapes[0].X, 1e-12));
}

TEST(RunningGear, FindsTheVirtualWheelsAngleByAckermann) {
  // Inner wheel at its limit, half a track of 0.75 m from the centre line, wheelbase 1.4 m.
  const double radius_m = 1.4 / std::tan(0.842177) + 0.75;
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_EQ(vehicle.steering.kind, SteeringKind::kFront);
  EXPECT_NEAR(min_turning_radius_m(vehicle), radius_m, 1e-9);
  EXPECT_NEAR(vehicle.steering.max_angle_rad, std::atan(1.4 / radius_m), 1e-9);
}

TEST(RunningGear, StopsAtTheFirstWheelThatReachesItsLimit) {
  // Both wheels turn by at most 0.3 rad to the right: the right one, inside the turn, is the first
  // to reach it.
  const ChangedVehicle changed("vehicle.urdf", "-0.842177", "-0.3");
  const Vehicle vehicle = load_vehicle(changed.folder());
  EXPECT_LT(vehicle.steering.max_angle_rad, 0.3);
  EXPECT_NEAR(min_turning_radius_m(vehicle), 1.4 / std::tan(0.3) + 0.75, 1e-9);
}

TEST(RunningGear, ReadsKingpinsThatPointDownTheSameWay) {
  const ChangedVehicle changed("vehicle.urdf", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 -1\"/>");
  EXPECT_DOUBLE_EQ(load_vehicle(changed.folder()).steering.max_angle_rad,
                   load_vehicle(kPlain.string()).steering.max_angle_rad);
}

TEST(RunningGear, ReadsAPivotedAxleAndFourWheelAndSkidSteering) {
  const Vehicle pivoted = load_vehicle("horticultural_tractor");
  EXPECT_NEAR(pivoted.front.oscillation_max_rad, 0.175, 1e-12);
  EXPECT_EQ(pivoted.rear.oscillation_max_rad, 0.0);
  const Vehicle crawling = load_vehicle("four_wheel_steer_robot");
  EXPECT_EQ(crawling.steering.kind, SteeringKind::kFourWheel);
  // What the file's limit was computed for, with four digits.
  EXPECT_NEAR(min_turning_radius_m(crawling), 2.877, 1e-3);
  const Vehicle skidding = load_vehicle("skid_steer_robot");
  EXPECT_EQ(skidding.steering.kind, SteeringKind::kSkid);
  // Frame B's origin is the middle between the axles, and the virtual wheel's limit its radius.
  EXPECT_EQ(skidding.rear.x_B_m, -skidding.front.x_B_m);
  EXPECT_DOUBLE_EQ(curvature_of(skidding, skidding.steering.max_angle_rad),
                   1.0 / skidding.steering.turning_radius_m);
  EXPECT_EQ(min_turning_radius_m(skidding), skidding.steering.turning_radius_m);
}

TEST(RunningGear, HoldsASuspensionArmStillAndSaysSo) {
  const ChangedVehicle changed(
      "vehicle.urdf",
      "<joint name=\"rear_left_wheel\" type=\"continuous\">\n    <parent link=\"base_link\"/>",
      "<link name=\"arm\"/><joint name=\"rocker\" type=\"revolute\"><parent link=\"base_link\"/>"
      "<child link=\"arm\"/><axis xyz=\"0 1 0\"/>"
      "<limit lower=\"-0.1\" upper=\"0.1\" effort=\"1\" velocity=\"1\"/></joint>"
      "<joint name=\"rear_left_wheel\" type=\"continuous\"><parent link=\"arm\"/>");
  EXPECT_THAT(load_vehicle(changed.folder()).notes, ElementsAre("joint 'rocker' is held still"));
}

TEST(Shape, BoundsAreThoseOfTheSolid) {
  Shape cylinder{.kind = ShapeKind::kCylinder, .size = {0.5, 0.5, 2.0}};
  cylinder.X.translation() = Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_TRUE(bounds_of(cylinder).isApprox(
      Eigen::AlignedBox3d(Eigen::Vector3d(0.5, -0.5, -1.0), Eigen::Vector3d(1.5, 0.5, 1.0))));
  cylinder.X.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 4.0, Eigen::Vector3d::UnitX()));
  // Leaning by 45 degrees: half the length and the radius, both times cos 45.
  EXPECT_NEAR(bounds_of(cylinder).max().z(), (1.0 + 0.5) * std::sqrt(0.5), 1e-12);
  Shape box{.kind = ShapeKind::kBox, .size = {2.0, 4.0, 6.0}};
  box.X.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 2.0, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(bounds_of(box).sizes().isApprox(Eigen::Vector3d(4.0, 2.0, 6.0)));
  EXPECT_TRUE(bounds_of(Shape{.kind = ShapeKind::kMesh}).isEmpty());
}

}  // namespace
}  // namespace headland
