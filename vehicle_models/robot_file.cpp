#include "vehicle_models/robot_file.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <set>

#include "terrains/input_error.h"
#include "vehicle_models/urdf_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

Eigen::Vector3d vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d pose_of(const urdf::Pose& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
  pose.rotation.getQuaternion(x, y, z, w);
  X.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  X.translation() = vector_of(pose.position);
  return X;
}

fs::path mesh_path(const std::string& name, const fs::path& folder) {
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (name.starts_with(scheme)) {
      const std::size_t slash = name.find('/', scheme.size());
      return folder / name.substr(slash == std::string::npos ? scheme.size() : slash + 1);
    }
  }
  constexpr std::string_view kFile = "file://";
  return folder / (name.starts_with(kFile) ? name.substr(kFile.size()) : name);
}

Shape shape_of(const urdf::Geometry& geometry, const urdf::Pose& pose,
               const Eigen::Isometry3d& X_RL, const fs::path& folder) {
  Shape shape;
  shape.X = X_RL * pose_of(pose);
  switch (geometry.type) {
    case urdf::Geometry::BOX:
      shape.kind = ShapeKind::kBox;
      shape.size = vector_of(dynamic_cast<const urdf::Box&>(geometry).dim);
      break;
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
      shape.kind = ShapeKind::kCylinder;
      shape.size = {cylinder.radius, cylinder.radius, cylinder.length};
      break;
    }
    case urdf::Geometry::SPHERE:
      shape.kind = ShapeKind::kSphere;
      shape.size.setConstant(dynamic_cast<const urdf::Sphere&>(geometry).radius);
      break;
    case urdf::Geometry::MESH: {
      const auto& mesh = dynamic_cast<const urdf::Mesh&>(geometry);
      shape.kind = ShapeKind::kMesh;
      shape.size = vector_of(mesh.scale);
      shape.mesh_file = mesh_path(mesh.filename, folder);
      break;
    }
  }
  return shape;
}

struct Reader {
  const urdf::ModelInterface& model;
  const UrdfLines& lines;
  Robot robot;

  [[noreturn]] void refuse(const std::string& kind, const std::string& name,
                           const std::string& value, std::string allowed) const {
    throw InputError(robot.file.string(), lines.place(kind, name), value, std::move(allowed));
  }

  void check_shape(const Shape& shape, const std::string& link) const {
    if (!shape.X.matrix().allFinite() || !shape.size.allFinite()) {
      refuse("link", link, "", "a shape's place or size is no finite number");
    }
    if (shape.kind != ShapeKind::kMesh && shape.size.minCoeff() <= 0.0) {
      refuse("link", link, fmt::format("{:g}", shape.size.minCoeff()),
             "a shape's lengths must be above 0 m");
    }
  }

  void add_shapes(const urdf::Link& link, const Eigen::Isometry3d& X, RobotLink& out) const {
    const fs::path folder = robot.file.parent_path();
    for (const auto& collision : link.collision_array) {
      out.collisions.push_back(shape_of(*collision->geometry, collision->origin, X, folder));
      check_shape(out.collisions.back(), link.name);
    }
    for (const auto& visual : link.visual_array) {
      Shape shape = shape_of(*visual->geometry, visual->origin, X, folder);
      // An unnamed or textured material has no colour of its own.
      if (visual->material != nullptr && visual->material->texture_filename.empty()) {
        const urdf::Color& colour = visual->material->color;
        shape.rgb = {{colour.r, colour.g, colour.b}};
      }
      check_shape(shape, link.name);
      out.visuals.push_back(std::move(shape));
    }
  }

  void add_mass(const urdf::Link& link, const Eigen::Isometry3d& X, RobotLink& out) const {
    if (link.inertial == nullptr) return;
    const urdf::Inertial& inertial = *link.inertial;
    Eigen::Matrix3d inertia;
    inertia << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz,
        inertial.ixz, inertial.iyz, inertial.izz;
    if (!(inertial.mass >= 0.0) || !std::isfinite(inertial.mass)) {
      refuse("link", link.name, fmt::format("{:g}", inertial.mass),
             "its mass must be 0 kg or more");
    }
    if (!inertia.allFinite()) refuse("link", link.name, "", "its inertia is no finite number");
    if (inertial.mass > 0.0) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia, Eigen::EigenvaluesOnly);
      if (const double least = solver.eigenvalues().minCoeff(); !(least > 0.0)) {
        refuse("link", link.name, fmt::format("{:g}", least),
               "with a mass every principal moment of inertia must be above 0 kg m2");
      }
    }
    const Eigen::Isometry3d X_RI = X * pose_of(inertial.origin);
    out.mass_kg = inertial.mass;
    out.com_R = X_RI.translation();
    out.inertia_R_kg_m2 = X_RI.linear() * inertia * X_RI.linear().transpose();
  }

  JointKind kind_of(const urdf::Joint& joint) const {
    switch (joint.type) {
      case urdf::Joint::FIXED:
        return JointKind::kFixed;
      case urdf::Joint::REVOLUTE:
        return JointKind::kRevolute;
      case urdf::Joint::CONTINUOUS:
        return JointKind::kContinuous;
      case urdf::Joint::PRISMATIC:
        return JointKind::kPrismatic;
      default:
        refuse("joint", joint.name, "",
               "a vehicle's joints are fixed, continuous, revolute or prismatic");
    }
  }

  int add_joint(const urdf::Joint& joint, int parent, const Eigen::Isometry3d& X_RJ) {
    RobotJoint out;
    out.name = joint.name;
    out.kind = kind_of(joint);
    out.parent = parent;
    out.child = static_cast<int>(robot.links.size());
    out.p_R = X_RJ.translation();
    if (out.kind != JointKind::kFixed) {
      const Eigen::Vector3d axis = vector_of(joint.axis);
      if (!axis.allFinite() || axis.norm() < 1e-9) {
        refuse("joint", joint.name, fmt::format("{:g} {:g} {:g}", axis.x(), axis.y(), axis.z()),
               "its axis has no direction");
      }
      out.axis_R = X_RJ.linear() * axis.normalized();
    }
    if (joint.limits != nullptr) {
      out.lower_rad = joint.limits->lower;
      out.upper_rad = joint.limits->upper;
    }
    const auto line = lines.line.find({"joint", joint.name});
    out.line = line == lines.line.end() ? 0 : line->second;
    robot.joints.push_back(std::move(out));
    return static_cast<int>(robot.joints.size()) - 1;
  }

  void add_link(const urdf::Link& link, const Eigen::Isometry3d& X, int joint) {
    const int index = static_cast<int>(robot.links.size());
    RobotLink& out = robot.links.emplace_back();
    out.name = link.name;
    out.joint = joint;
    if (!X.matrix().allFinite()) refuse("link", link.name, "", "its place is no finite number");
    add_mass(link, X, out);
    add_shapes(link, X, out);
    for (const auto& child : link.child_joints) {
      const Eigen::Isometry3d X_child = X * pose_of(child->parent_to_joint_origin_transform);
      const int carried_by = add_joint(*child, index, X_child);
      add_link(*model.getLink(child->child_link_name), X_child, carried_by);
    }
  }

  // urdfdom finds a root and lets everything else pass.
  void check_tree() const {
    std::map<std::string, std::string> carrier;
    for (const auto& [name, joint] : model.joints_) {
      const auto [place, fresh] = carrier.emplace(joint->child_link_name, name);
      if (!fresh) {
        refuse("joint", name, joint->child_link_name,
               fmt::format("joint '{}' carries this link already; a tree has one joint to each "
                           "link",
                           place->second));
      }
    }
    std::set<std::string> reached;
    std::vector<std::string> waiting{model.getRoot()->name};
    while (!waiting.empty()) {
      const std::string name = waiting.back();
      waiting.pop_back();
      reached.insert(name);
      for (const auto& child : model.getLink(name)->child_links) waiting.push_back(child->name);
    }
    for (const auto& [name, link] : model.links_) {
      if (!reached.contains(name)) {
        refuse("link", name, "", "hangs in a ring of joints that does not reach the root link");
      }
    }
  }
};

}  // namespace

Robot read_robot(const fs::path& file) {
  const UrdfText text = read_urdf(file);
  Reader reader{*text.model, text.lines, {file, {}, {}}};
  reader.check_tree();
  reader.add_link(*text.model->getRoot(), Eigen::Isometry3d::Identity(), -1);
  return std::move(reader.robot);
}

std::string place_of(const RobotJoint& joint) {
  return joint.line > 0 ? fmt::format("line {}: joint '{}'", joint.line, joint.name)
                        : fmt::format("joint '{}'", joint.name);
}

}  // namespace headland
