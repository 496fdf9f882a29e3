#include "terrains/input_file.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

InputError unreadable(const fs::path& file, const std::error_code& error) {
  return {file.string(), "", "", "cannot be read: " + error.message()};
}

std::error_code last_error() { return {errno, std::generic_category()}; }

// Its type, for what exists and may be read.
fs::file_type type_of(const fs::path& file) {
  std::error_code error;
  const fs::file_type type = fs::status(file, error).type();
  if (type == fs::file_type::not_found) throw InputError(file.string(), "", "", "no such file");
  if (error) throw unreadable(file, error);
  if (::access(file.c_str(), R_OK) != 0) throw unreadable(file, last_error());
  return type;
}

void require_no_stream(const fs::path& file, fs::file_type type) {
  if (type == fs::file_type::regular || type == fs::file_type::directory) return;
  throw InputError(file.string(), "", "", "is a pipe, a socket or a device; a file is needed");
}

}  // namespace

void require_file_or_folder(const fs::path& file) {
  const fs::file_type type = type_of(file);
  require_no_stream(file, type);
  if (type != fs::file_type::directory) return;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(file, error)) {
    require_no_stream(entry.path(), type_of(entry.path()));
  }
  if (error) throw unreadable(file, error);
}

void require_file(const fs::path& file) {
  const fs::file_type type = type_of(file);
  require_no_stream(file, type);
  if (type == fs::file_type::directory) {
    throw InputError(file.string(), "", "", "is a folder, not a file");
  }
}

std::string read_text(const fs::path& file) {
  require_file(file);
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw unreadable(file, last_error());
  return text;
}

}  // namespace headland
