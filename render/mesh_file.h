// Meshes from files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/mesh.h"

namespace headland {

struct MeshFile {
  Mesh mesh;
  std::vector<std::string> lacks;  // what the file names and is drawn without, a sentence each
};

// All triangles of a mesh file that assimp reads (OBJ, glTF, COLLADA, STL...), placed by the
// file's own node transforms, in the diffuse colours of its materials (grey without one); textures
// are not drawn. Throws InputError for a missing or broken file, one without triangles, and one
// with a vertex that is not finite or further than kMaxMesh_m from the origin: no vehicle in
// metres.
MeshFile read_mesh(const std::filesystem::path& file);

inline constexpr float kMaxMesh_m = 100.0F;

}  // namespace headland
