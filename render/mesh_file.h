// Meshes from files.
#pragma once

#include <filesystem>

#include "render/mesh.h"

namespace headland {

// All triangles of a mesh file that assimp reads (OBJ, glTF, COLLADA, STL...), placed by the
// file's own node transforms, in the diffuse colours of its materials (grey without one). Throws
// InputError for a missing or broken file and for one without triangles.
Mesh read_mesh(const std::filesystem::path& file);

}  // namespace headland
