#include "vehicle_models/running_gear.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrains/input_error.h"

namespace headland {
namespace {

// How far an axis may lean and still count as its nominal direction: kingpins and axles do lean.
constexpr double kAlong = 0.966;  // cos 15 deg
// Wheels of one axle, and both axles on the ground, as a share of the wheel's radius.
constexpr double kMisplaced = 0.05;
// Tyres seen from the front are about half as wide as a sphere's radius.
constexpr double kSphereWidth = 0.5;

[[noreturn]] void refuse(const Robot& robot, const RobotJoint& joint, const std::string& value,
                         std::string allowed) {
  throw InputError(robot.file.string(), place_of(joint), value, std::move(allowed));
}

std::string axis_text(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d shown = axis.array() + 0.0;
  return fmt::format("{:.3g} {:.3g} {:.3g}", shown.x(), shown.y(), shown.z());
}

// The solid that tells a wheel's size: its collision before its looks.
const Shape* round_shape(const RobotLink& link) {
  for (const auto* shapes : {&link.collisions, &link.visuals}) {
    for (const Shape& shape : *shapes) {
      if (shape.kind == ShapeKind::kCylinder || shape.kind == ShapeKind::kSphere) return &shape;
    }
  }
  return nullptr;
}

void read_limits(const Robot& robot, const RobotJoint& joint, Wheel& wheel) {
  if (!(joint.lower_rad < 0.0 && joint.upper_rad > 0.0)) {
    refuse(robot, joint, fmt::format("{:g} to {:g}", joint.lower_rad, joint.upper_rad),
           "its limits must lie on both sides of 0 rad");
  }
  if (std::abs(joint.axis_R.z()) > kAlong) {
    constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
    if (wheel.left_rad) refuse(robot, joint, "", "a second steering joint for one wheel");
    if (std::max(-joint.lower_rad, joint.upper_rad) >= kQuarterTurn) {
      refuse(robot, joint, fmt::format("{:g} to {:g}", joint.lower_rad, joint.upper_rad),
             "a wheel steers by less than 1.57 rad");
    }
    const bool upwards = joint.axis_R.z() > 0.0;
    wheel.left_rad = upwards ? joint.upper_rad : -joint.lower_rad;
    wheel.right_rad = upwards ? -joint.lower_rad : joint.upper_rad;
  } else {
    wheel.pivot_rad = std::min(joint.upper_rad, -joint.lower_rad);
  }
}

// What the joints between the root and the wheel do.
void follow_chain(const Robot& robot, Wheel& wheel, std::vector<std::string>& notes) {
  int link =
      robot
          .joints[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(wheel.link)].joint)]
          .parent;
  while (robot.links[static_cast<std::size_t>(link)].joint >= 0) {
    const auto& joint =
        robot.joints[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(link)].joint)];
    link = joint.parent;
    if (joint.kind == JointKind::kContinuous) {
      refuse(robot, joint, "",
             "a joint that carries a wheel's joint must be revolute, with limits");
    }
    if (joint.kind == JointKind::kFixed) continue;
    const Eigen::Vector3d lean = joint.axis_R.cwiseAbs();
    const bool turns = joint.kind == JointKind::kRevolute;
    if (turns && (lean.z() > kAlong || lean.x() > kAlong)) {
      read_limits(robot, joint, wheel);
    } else if (turns && lean.y() <= kAlong) {
      refuse(
          robot, joint, axis_text(joint.axis_R),
          "its axis must be upright (z) to steer, lengthwise (x) for a pivoted axle or crosswise "
          "(y) for a suspension arm");
    } else {
      const std::string note = fmt::format("joint '{}' is held still", joint.name);
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    }
  }
}

Wheel wheel_of(const Robot& robot, const RobotJoint& joint, std::vector<std::string>& notes) {
  if (std::abs(joint.axis_R.y()) < kAlong) {
    refuse(robot, joint, axis_text(joint.axis_R),
           "a continuous joint is a wheel's and must turn about y; make it fixed if it carries no "
           "wheel");
  }
  const RobotLink& link = robot.links[static_cast<std::size_t>(joint.child)];
  const Shape* shape = round_shape(link);
  if (shape == nullptr) {
    refuse(robot, joint, link.name,
           "the wheel's link needs a cylinder or a sphere as its <collision>: it tells the radius");
  }
  const bool cylinder = shape->kind == ShapeKind::kCylinder;
  if (cylinder && std::abs(shape->X.linear().col(2).dot(joint.axis_R)) < kAlong) {
    refuse(robot, joint, link.name, "the wheel's cylinder does not lie along its axle");
  }
  Wheel wheel;
  wheel.link = joint.child;
  wheel.joint = joint.name;
  wheel.centre_R = shape->X.translation();
  wheel.radius_m = shape->size.x();
  wheel.width_m = cylinder ? shape->size.z() : kSphereWidth * wheel.radius_m;
  const Eigen::Vector3d off = wheel.centre_R - joint.p_R;
  if ((off - off.dot(joint.axis_R) * joint.axis_R).norm() > kMisplaced * wheel.radius_m) {
    refuse(robot, joint, link.name, "the wheel's middle is not on its axle");
  }
  if (link.mass_kg <= 0.0) refuse(robot, joint, link.name, "the wheel's link has no mass");
  wheel.inertia_kg_m2 = joint.axis_R.dot(link.inertia_R_kg_m2 * joint.axis_R);
  follow_chain(robot, wheel, notes);
  return wheel;
}

std::string names_of(const std::vector<Wheel>& wheels) {
  std::vector<std::string> names;
  names.reserve(wheels.size());
  for (const Wheel& wheel : wheels) names.push_back(wheel.joint);
  return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuse_layout(const Robot& robot, const std::string& value, std::string allowed) {
  throw InputError(robot.file.string(), "wheels", value, std::move(allowed));
}

void check_axle(const Robot& robot, const Wheel& left, const Wheel& right) {
  const double tolerance_m = kMisplaced * left.radius_m;
  const std::string both = left.joint + ", " + right.joint;
  if (std::abs(left.radius_m - right.radius_m) > 0.01 * left.radius_m) {
    refuse_layout(robot, both,
                  fmt::format("one axle's wheels must be of one size, not {:g} and {:g} m",
                              left.radius_m, right.radius_m));
  }
  if (std::abs(left.centre_R.x() - right.centre_R.x()) > tolerance_m ||
      std::abs(left.centre_R.z() - right.centre_R.z()) > tolerance_m ||
      left.centre_R.y() - right.centre_R.y() < left.width_m) {
    refuse_layout(robot, both,
                  "must stand side by side, one to the left and one to the right: x is forward, y "
                  "left, z up");
  }
  if (left.left_rad.has_value() != right.left_rad.has_value()) {
    refuse_layout(robot, both, "only one of the two is steered");
  }
  if (left.pivot_rad != right.pivot_rad) {
    refuse_layout(robot, both, "must hang on one pivot");
  }
}

double ground_of(const Wheel& a, const Wheel& b) {
  return 0.5 * (a.centre_R.z() + b.centre_R.z()) - 0.5 * (a.radius_m + b.radius_m);
}

// Angle of the virtual wheel `arm_m` ahead of the turning centre's line at which a wheel at
// `side_m` from the centre line, on the inner side positive, reaches its limit.
double virtual_angle_rad(double limit_rad, double arm_m, double side_m) {
  return std::atan2(arm_m, arm_m / std::tan(limit_rad) + side_m);
}

double largest_angle_rad(const RunningGear& gear) {
  const auto& [rear_left, rear_right, front_left, front_right] = gear.wheels;
  const double wheelbase_m = front_left.centre_R.x() - rear_left.centre_R.x();
  const bool all = gear.steering == SteeringKind::kFourWheel;
  const double arm_m = all ? 0.5 * wheelbase_m : wheelbase_m;
  double angle_rad = 0.5 * std::numbers::pi;
  const auto keep = [&](const Wheel& left, const Wheel& right, bool mirrored) {
    const double side_m = 0.5 * (left.centre_R.y() - right.centre_R.y());
    // Turning left, the left wheel is the inner one; rear wheels then turn to the right.
    const double limits[] = {
        virtual_angle_rad(mirrored ? *left.right_rad : *left.left_rad, arm_m, side_m),
        virtual_angle_rad(mirrored ? *right.left_rad : *right.right_rad, arm_m, side_m),
        virtual_angle_rad(mirrored ? *right.right_rad : *right.left_rad, arm_m, -side_m),
        virtual_angle_rad(mirrored ? *left.left_rad : *left.right_rad, arm_m, -side_m)};
    for (const double limit : limits) angle_rad = std::min(angle_rad, limit);
  };
  keep(front_left, front_right, false);
  if (all) keep(rear_left, rear_right, true);
  return angle_rad;
}

}  // namespace

RunningGear find_running_gear(const Robot& robot) {
  RunningGear gear;
  std::vector<Wheel> wheels;
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == JointKind::kContinuous) wheels.push_back(wheel_of(robot, joint, gear.notes));
  }
  if (wheels.empty()) {
    refuse_layout(robot, "", "there are none: each wheel needs a joint of type continuous");
  }
  if (wheels.size() != gear.wheels.size()) {
    refuse_layout(robot, names_of(wheels),
                  fmt::format("{} continuous joints; headland drives vehicles with four wheels",
                              wheels.size()));
  }
  std::sort(wheels.begin(), wheels.end(),
            [](const Wheel& a, const Wheel& b) { return a.centre_R.x() < b.centre_R.x(); });
  for (const int first : {0, 2}) {
    const auto axle = wheels.begin() + first;
    if (axle[0].centre_R.y() < axle[1].centre_R.y()) std::swap(axle[0], axle[1]);
  }
  std::copy(wheels.begin(), wheels.end(), gear.wheels.begin());
  const auto& [rear_left, rear_right, front_left, front_right] = gear.wheels;
  check_axle(robot, rear_left, rear_right);
  check_axle(robot, front_left, front_right);
  const double ground_m = ground_of(rear_left, rear_right);
  if (const double step_m = ground_of(front_left, front_right) - ground_m;
      std::abs(step_m) > kMisplaced * rear_left.radius_m) {
    refuse_layout(robot, fmt::format("{:g}", step_m),
                  "the front wheels stand that many metres above the rear wheels' ground");
  }
  const double middle_m = 0.5 * (rear_left.centre_R.y() + rear_right.centre_R.y());
  const double skew_m = 0.5 * (front_left.centre_R.y() + front_right.centre_R.y()) - middle_m;
  if (std::abs(skew_m) > kMisplaced * rear_left.radius_m) {
    refuse_layout(robot, fmt::format("{:g}", skew_m),
                  "the front axle's middle lies that many metres beside the rear axle's");
  }
  if (rear_left.pivot_rad && front_left.pivot_rad) {
    refuse_layout(robot, "", "both axles pivot: nothing would hold the body upright");
  }
  const bool front = front_left.left_rad.has_value();
  const bool rear = rear_left.left_rad.has_value();
  if (rear && !front) {
    refuse_layout(robot, rear_left.joint,
                  "the rear wheels alone are steered; turn the robot round");
  }
  gear.steering = rear    ? SteeringKind::kFourWheel
                  : front ? SteeringKind::kFront
                          : SteeringKind::kSkid;
  if (front) gear.max_angle_rad = largest_angle_rad(gear);
  const double rear_x_m = 0.5 * (rear_left.centre_R.x() + rear_right.centre_R.x());
  const double front_x_m = 0.5 * (front_left.centre_R.x() + front_right.centre_R.x());
  const bool rear_follows = gear.steering == SteeringKind::kFront;
  gear.origin_R = {rear_follows ? rear_x_m : 0.5 * (rear_x_m + front_x_m), middle_m, ground_m};
  return gear;
}

}  // namespace headland
