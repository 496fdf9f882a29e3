// Meshes and lines put together in a tree of nodes, written as binary glTF by assimp.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "render/mesh.h"

namespace headland {

struct GltfLine {
  std::vector<Eigen::Vector3d> points;
  bool closed = false;
};

// A node with a mesh or lines or neither, and its children.
struct GltfNode {
  std::string name;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();  // in its parent
  const Mesh* mesh = nullptr;                           // not owned; several nodes may share one
  bool bare = false;                                    // the mesh without its normals and colours
  std::vector<GltfLine> lines{};
  Rgba line_colour{};
  std::vector<GltfNode> children{};
};

// GLB bytes of the tree, whose z is up: the root of the file turns it to the y of glTF. Meshes keep
// the colours of their vertices. Throws std::runtime_error when assimp cannot write it.
std::string glb_of(const GltfNode& root);

}  // namespace headland
