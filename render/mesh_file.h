// Meshes from files.
#pragma once

#include <filesystem>

#include "render/mesh.h"

namespace headland {

// All triangles of a mesh file that assimp reads (OBJ, glTF, COLLADA, STL...), placed by the
// file's own node transforms, in the diffuse colours of its materials (grey without one). Throws
// InputError for a missing or broken file, one without triangles, and one with a vertex that is not
// finite or further than kMaxMesh_m from the origin: no vehicle in metres.
Mesh read_mesh(const std::filesystem::path& file);

inline constexpr float kMaxMesh_m = 100.0F;

}  // namespace headland
