#include "vehicle_models/robot_body.h"

#include <algorithm>

#include "terrains/input_error.h"

namespace headland {
namespace {

bool is_wheel(const RunningGear& gear, std::size_t link) {
  return std::any_of(gear.wheels.begin(), gear.wheels.end(), [&](const Wheel& wheel) {
    return static_cast<std::size_t>(wheel.link) == link;
  });
}

void add_mass(const Robot& robot, const RunningGear& gear, Body& body) {
  Eigen::Vector3d moment_R = Eigen::Vector3d::Zero();
  for (const RobotLink& link : robot.links) {
    body.mass_kg += link.mass_kg;
    moment_R += link.mass_kg * link.com_R;
  }
  if (!(body.mass_kg > 0.0)) throw InputError(robot.file.string(), "", "", "no link has a mass");
  const Eigen::Vector3d com_R = moment_R / body.mass_kg;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const RobotLink& link : robot.links) {
    const Eigen::Vector3d d = link.com_R - com_R;
    inertia += link.inertia_R_kg_m2 +
               link.mass_kg * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  body.com_B = com_R - gear.origin_R;
  body.inertia_kg_m2 = inertia.diagonal();
}

}  // namespace

Body body_of(const Robot& robot, const RunningGear& gear) {
  Body body;
  add_mass(robot, gear, body);
  Eigen::AlignedBox3d all;
  Eigen::AlignedBox3d without_wheels;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    for (const Shape& shape : robot.links[i].collisions) {
      const Eigen::AlignedBox3d box = bounds_of(shape);
      all.extend(box);
      if (!is_wheel(gear, i)) without_wheels.extend(box);
    }
  }
  if (without_wheels.isEmpty()) {
    throw InputError(robot.file.string(), "collision", "",
                     "the body has no hull: give a link without wheels a <collision> with a box, "
                     "cylinder or sphere (meshes do not count)");
  }
  const Eigen::Vector3d low_B = all.min() - gear.origin_R;
  const Eigen::Vector3d high_B = all.max() - gear.origin_R;
  body.length_m = high_B.x() - low_B.x();
  body.width_m = 2.0 * std::max(-low_B.y(), high_B.y());
  body.height_m = high_B.z();
  body.rear_overhang_m = -low_B.x();
  body.ground_clearance_m = without_wheels.min().z() - gear.origin_R.z();
  return body;
}

std::vector<Shape> body_shapes(const Robot& robot, const RunningGear& gear) {
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (is_wheel(gear, i)) continue;
    for (Shape shape : robot.links[i].visuals) {
      shape.X.pretranslate(-gear.origin_R);
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

}  // namespace headland
