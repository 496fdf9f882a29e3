// Triangles of solid bodies and terrain.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/gl_objects.h"
#include "render/palette.h"

namespace headland {

struct MeshVertex {
  Eigen::Vector3f p = Eigen::Vector3f::Zero();       // m
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit
  Rgba colour;
};

// Three indices a triangle, counter-clockwise seen from outside.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
};

// Adds `part`, moved by X.
void append(Mesh& mesh, const Mesh& part, const Eigen::Isometry3d& X);

// Solids with the colour given. A box between two corners; a solid of revolution about the z axis
// from (radius, z) points, its surface on the outside when z rises with the profile.
Mesh box_mesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Rgba colour);
// The solid between two quadrilaterals whose corners correspond, counter-clockwise from above.
Mesh prism_mesh(const std::array<Eigen::Vector3d, 4>& bottom,
                const std::array<Eigen::Vector3d, 4>& top, Rgba colour);
Mesh revolved_mesh(std::span<const Eigen::Vector2d> radius_z, int sides, Rgba colour);

// A round bar between two points.
Mesh bar_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Rgba colour);

// On the graphics side.
GlTriangles upload(const Mesh& mesh);

}  // namespace headland
