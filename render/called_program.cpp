#include "render/called_program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "terrains/input_error.h"

namespace headland {

void require_program(const std::string& name, const std::string& does, const std::string& package) {
  // Asking a shell would lose a Ctrl-C.
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string program = (folder.empty() ? "." : folder) + "/" + name;
    if (::access(program.c_str(), X_OK) == 0) return;
  }
  throw InputError(name, "", "",
                   fmt::format("is not installed; it {} (Debian: {})", does, package));
}

}  // namespace headland
