// A robot description as urdfdom understands it, with the lines that urdfdom does not keep.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace headland {

// Line of every element directly below <robot>, by its kind and name.
struct UrdfLines {
  std::map<std::pair<std::string, std::string>, int> line;

  // "line 12: joint 'left_wheel'", without the line where it is not known.
  std::string place(const std::string& kind, const std::string& name) const;
};

struct UrdfText {
  urdf::ModelInterfaceSharedPtr model;  // never null
  UrdfLines lines;
};

// Throws InputError for a file that cannot be read, malformed XML (with its line), elements nested
// deeper than 256 levels, more than 2000 links and what urdfdom refuses (in its words).
UrdfText read_urdf(const std::filesystem::path& file);

}  // namespace headland
