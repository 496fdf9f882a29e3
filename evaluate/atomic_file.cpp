#include "evaluate/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

// The error number of the first step that failed, 0 when all of `content` is on its way to disk.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

void write_atomically(const fs::path& file, std::string_view content) {
  const fs::path partial =
      file.parent_path() / fmt::format(".{}.partial", file.filename().string());
  const int descriptor = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw InputError(file.string(), "", "", "cannot be written: " + reason(errno));
  }
  int error = write_all(descriptor, content);
  // Some file systems tell of a full disk only on closing.
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(partial.c_str(), file.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(partial.c_str());
  throw InputError(file.string(), "", "", "cannot be written: " + reason(error));
}

void check_output_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::path existing = fs::absolute(folder, ignored).lexically_normal();
  while (!fs::exists(existing, ignored) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, ignored)) {
    throw InputError(folder.string(), "", "",
                     "cannot hold the results: " + existing.string() + " is not a folder");
  }
  if (::access(existing.c_str(), W_OK | X_OK) != 0) {
    throw InputError(folder.string(), "", "",
                     "cannot hold the results: " + existing.string() + ": " + reason(errno));
  }
}

void create_output_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "", "", "cannot be created: " + error.message());
}

std::string read_text(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw InputError(file.string(), "", "", "is a folder, not a file");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "", "", "cannot be read: " + reason(errno));
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw InputError(file.string(), "", "", "cannot be read: " + reason(errno));
  return text;
}

}  // namespace headland
