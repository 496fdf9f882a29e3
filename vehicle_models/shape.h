// Simple solids and meshes, as robot descriptions have them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>

namespace headland {

enum class ShapeKind { kBox, kCylinder, kSphere, kMesh };

// A solid in the frame of its holder. Lengths in metres.
struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  // Box: edges. Cylinder: radius, radius, length along its z. Sphere: radius three times.
  // Mesh: factors on the file's own coordinates.
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  std::filesystem::path mesh_file = {};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();  // of its middle (a mesh: its origin)
  std::optional<std::array<double, 3>> rgb = {};        // 0..1
};

// Smallest box along the holder's axes around the solid; empty for a mesh, which is not read here.
Eigen::AlignedBox3d bounds_of(const Shape& shape);

}  // namespace headland
