#include "render/gltf.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace headland {
namespace {

// glTF's vertex colours are linear.
float linear(std::uint8_t srgb) {
  const float share = static_cast<float>(srgb) / 255.0F;
  return share <= 0.04045F ? share / 12.92F : std::pow((share + 0.055F) / 1.055F, 2.4F);
}

aiColor4D linear(Rgba colour) {
  return {linear(colour.r), linear(colour.g), linear(colour.b),
          static_cast<float>(colour.a) / 255.0F};
}

aiVector3D vector(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

// Owned by the scene from here on, as assimp frees it.
aiMesh* mesh_of(const Mesh& mesh, bool bare, unsigned material) {
  auto* out = new aiMesh;
  out->mMaterialIndex = material;
  out->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  out->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  out->mVertices = new aiVector3D[mesh.vertices.size()];
  if (!bare) {
    out->mNormals = new aiVector3D[mesh.vertices.size()];
    out->mColors[0] = new aiColor4D[mesh.vertices.size()];
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    out->mVertices[i] = vector(mesh.vertices[i].p);
    if (bare) continue;
    out->mNormals[i] = vector(mesh.vertices[i].normal);
    out->mColors[0][i] = linear(mesh.vertices[i].colour);
  }
  out->mNumFaces = static_cast<unsigned>(mesh.indices.size() / 3);
  out->mFaces = new aiFace[out->mNumFaces];
  for (unsigned i = 0; i < out->mNumFaces; ++i) {
    out->mFaces[i].mNumIndices = 3;
    out->mFaces[i].mIndices = new unsigned[3];
    std::copy_n(mesh.indices.begin() + 3 * i, 3, out->mFaces[i].mIndices);
  }
  return out;
}

aiMesh* mesh_of(const std::vector<GltfLine>& lines, unsigned material) {
  std::vector<aiVector3D> points;
  std::vector<std::array<unsigned, 2>> legs;
  for (const GltfLine& line : lines) {
    const auto first = static_cast<unsigned>(points.size());
    for (const Eigen::Vector3d& p : line.points) points.push_back(vector(p.cast<float>()));
    for (unsigned i = first + 1; i < points.size(); ++i) legs.push_back({i - 1, i});
    if (line.closed && line.points.size() > 2) {
      legs.push_back({static_cast<unsigned>(points.size()) - 1, first});
    }
  }
  auto* out = new aiMesh;
  out->mMaterialIndex = material;
  out->mPrimitiveTypes = aiPrimitiveType_LINE;
  out->mNumVertices = static_cast<unsigned>(points.size());
  out->mVertices = new aiVector3D[points.size()];
  std::copy(points.begin(), points.end(), out->mVertices);
  out->mNumFaces = static_cast<unsigned>(legs.size());
  out->mFaces = new aiFace[legs.size()];
  for (std::size_t i = 0; i < legs.size(); ++i) {
    out->mFaces[i].mNumIndices = 2;
    out->mFaces[i].mIndices = new unsigned[2]{legs[i][0], legs[i][1]};
  }
  return out;
}

struct Parts {
  std::vector<aiMesh*> meshes;
  std::vector<aiMaterial*> materials;
  std::map<const Mesh*, unsigned> known;

  unsigned material(const std::string& name, Rgba colour) {
    auto* material = new aiMaterial;
    const aiString text(name);
    material->AddProperty(&text, AI_MATKEY_NAME);
    const aiColor4D linear_colour = linear(colour);
    material->AddProperty(&linear_colour, 1, AI_MATKEY_COLOR_DIFFUSE);
    material->AddProperty(&linear_colour, 1, AI_MATKEY_BASE_COLOR);
    materials.push_back(material);
    return static_cast<unsigned>(materials.size()) - 1;
  }

  unsigned add(aiMesh* mesh, const std::string& name) {
    mesh->mName = name;
    meshes.push_back(mesh);
    return static_cast<unsigned>(meshes.size()) - 1;
  }

  // Index of the node's mesh.
  unsigned mesh_for(const GltfNode& node) {
    if (node.mesh == nullptr) {
      return add(mesh_of(node.lines, material(node.name, node.line_colour)), node.name);
    }
    const auto found = known.find(node.mesh);
    if (found != known.end()) return found->second;
    constexpr unsigned kByVertex = 0;
    return known[node.mesh] = add(mesh_of(*node.mesh, node.bare, kByVertex), node.name);
  }
};

bool has_shape(const GltfNode& node) {
  if (node.mesh != nullptr) return !node.mesh->indices.empty();
  return std::any_of(node.lines.begin(), node.lines.end(),
                     [](const GltfLine& line) { return line.points.size() > 1; });
}

aiMatrix4x4 matrix(const Eigen::Isometry3d& X) {
  const Eigen::Matrix4f m = X.matrix().cast<float>();
  return {m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3),
          m(2, 0), m(2, 1), m(2, 2), m(2, 3), m(3, 0), m(3, 1), m(3, 2), m(3, 3)};
}

aiNode* node_of(const GltfNode& node, Parts& parts) {
  auto* out = new aiNode(node.name);
  out->mTransformation = matrix(node.X);
  if (has_shape(node)) {
    out->mNumMeshes = 1;
    out->mMeshes = new unsigned[1]{parts.mesh_for(node)};
  }
  std::vector<aiNode*> children;
  for (const GltfNode& child : node.children) children.push_back(node_of(child, parts));
  if (!children.empty()) {
    out->addChildren(static_cast<unsigned>(children.size()), children.data());
  }
  return out;
}

template <typename T>
T** array_of(const std::vector<T*>& items) {
  auto** array = new T*[items.size()];
  std::copy(items.begin(), items.end(), array);
  return array;
}

}  // namespace

std::string glb_of(const GltfNode& root) {
  GltfNode upright{.name = "y_up"};
  upright.X = Eigen::AngleAxisd(-0.5 * std::numbers::pi, Eigen::Vector3d::UnitX());
  upright.children = {root};
  Parts parts;
  parts.material("by_vertex", {255, 255, 255});
  aiScene scene;
  scene.mRootNode = node_of(upright, parts);
  scene.mNumMeshes = static_cast<unsigned>(parts.meshes.size());
  scene.mMeshes = array_of(parts.meshes);
  scene.mNumMaterials = static_cast<unsigned>(parts.materials.size());
  scene.mMaterials = array_of(parts.materials);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, "glb2", 0U);
  if (blob == nullptr) throw std::runtime_error(std::string("glTF: ") + exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

}  // namespace headland
