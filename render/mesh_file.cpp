#include "render/mesh_file.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

Rgba diffuse_colour(const aiMaterial& material) {
  aiColor3D colour(0.6F, 0.6F, 0.6F);
  material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  const auto byte = [](float share) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
  };
  return {byte(colour.r), byte(colour.g), byte(colour.b)};
}

bool defines_materials(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return text.find("newmtl") != std::string::npos;
}

// Notes which of the files that a mesh file names cannot be opened, and which of materials have
// none.
class NotingFiles : public Assimp::DefaultIOSystem {
 public:
  // `own`: the name of the materials' file that goes without saying.
  NotingFiles(std::vector<std::string>& missing, std::vector<std::string>& empty, std::string own)
      : missing_(missing), empty_(empty), own_(std::move(own)) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    Assimp::IOStream* const stream = DefaultIOSystem::Open(file, mode);
    const std::string name = std::filesystem::path(file).filename().string();
    if (stream == nullptr) {
      // assimp looks for a file in several places, and for materials at last by the mesh's own
      // name.
      const bool known = std::find(missing_.begin(), missing_.end(), name) != missing_.end();
      if (!known && (name != own_ || missing_.empty())) missing_.push_back(name);
    } else if (name == own_) {
      missing_.clear();
    }
    const bool of_materials = std::filesystem::path(file).extension() == ".mtl";
    if (stream != nullptr && of_materials && !defines_materials(file)) empty_.push_back(name);
    return stream;
  }

 private:
  std::vector<std::string>& missing_;
  std::vector<std::string>& empty_;
  std::string own_;
};

// Textures of all materials by name, each once.
std::vector<std::string> textures_of(const aiScene& scene) {
  std::vector<std::string> names;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
      aiString name;
      if (scene.mMaterials[i]->GetTexture(type, 0, &name) != AI_SUCCESS) continue;
      if (std::find(names.begin(), names.end(), name.C_Str()) == names.end()) {
        names.emplace_back(name.C_Str());
      }
    }
  }
  return names;
}

void append(Mesh& mesh, const aiMesh& part, Rgba colour) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& p = part.mVertices[i];
    const aiVector3D& n = part.mNormals[i];
    mesh.vertices.push_back({{p.x, p.y, p.z}, {n.x, n.y, n.z}, colour});
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      mesh.indices.push_back(first + face.mIndices[k]);
    }
  }
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& file) {
  require_file(file);
  Assimp::Importer importer;
  std::vector<std::string> missing;
  std::vector<std::string> empty;
  // The importer's from here on.
  importer.SetIOHandler(new NotingFiles(missing, empty, file.stem().string() + ".mtl"));
  // Points and lines have no surface to draw.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenNormals |
                         aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) {
    throw InputError(file.string(), "", "",
                     std::string("no readable mesh: ") + importer.GetErrorString());
  }
  MeshFile read;
  Mesh& mesh = read.mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& part = *scene->mMeshes[i];
    append(mesh, part, diffuse_colour(*scene->mMaterials[part.mMaterialIndex]));
  }
  for (const MeshVertex& vertex : mesh.vertices) {
    if (vertex.p.allFinite() && vertex.p.norm() <= kMaxMesh_m) continue;
    throw InputError(
        file.string(), "",
        fmt::format("{:g}, {:g}, {:g}", vertex.p.x(), vertex.p.y(), vertex.p.z()),
        fmt::format("vertices within {} m of the origin are needed, in metres", kMaxMesh_m));
  }
  if (mesh.indices.empty()) throw InputError(file.string(), "", "", "the mesh has no triangles");
  const std::string name = file.filename().string();
  for (const std::string& material : missing) {
    read.lacks.push_back(
        fmt::format("{} names the materials {}, which cannot be read: drawn grey", name, material));
  }
  for (const std::string& material : empty) {
    read.lacks.push_back(
        fmt::format("{} names the materials {}, which defines none: drawn grey", name, material));
  }
  for (const std::string& texture : textures_of(*scene)) {
    const bool embedded = scene->GetEmbeddedTexture(texture.c_str()) != nullptr;
    std::error_code ignored;
    const bool there = embedded || std::filesystem::exists(file.parent_path() / texture, ignored);
    read.lacks.push_back(fmt::format("{} has the texture {}, which {}: drawn in plain colour", name,
                                     embedded ? "inside it" : texture,
                                     there ? "is not shown" : "is missing"));
  }
  return read;
}

}  // namespace headland
