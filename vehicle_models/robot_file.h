// A robot description (URDF) as a tree of links and joints, in plain data.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "vehicle_models/shape.h"

namespace headland {

// A rigid link with every joint at zero. Vectors and poses are in the frame of the root link (R).
struct RobotLink {
  std::string name;
  double mass_kg = 0.0;
  Eigen::Vector3d com_R = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_R_kg_m2 = Eigen::Matrix3d::Zero();  // about its com, along R's axes
  std::vector<Shape> collisions;
  std::vector<Shape> visuals;
  int joint = -1;  // that carries it; -1: the root
};

enum class JointKind { kFixed, kRevolute, kContinuous, kPrismatic };

struct RobotJoint {
  std::string name;
  JointKind kind = JointKind::kFixed;
  int parent = 0;  // links
  int child = 0;
  Eigen::Vector3d p_R = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_R = Eigen::Vector3d::UnitX();
  double lower_rad = 0.0;
  double upper_rad = 0.0;
  int line = 0;  // in the file
};

struct Robot {
  std::filesystem::path file;
  std::vector<RobotLink> links;  // parents before children
  std::vector<RobotJoint> joints;
};

// Throws InputError for a file that cannot be read, malformed XML (with its line), what urdfdom
// refuses, joints that do not make one tree, masses below zero, inertia that no solid has and joint
// types that no vehicle has. A mesh's name may start with package://NAME/ or file://; it is looked
// for in the file's folder.
Robot read_robot(const std::filesystem::path& file);

// Where a joint or link stands, for an InputError: "line 12: joint 'left_wheel'".
std::string place_of(const RobotJoint& joint);

}  // namespace headland
