#include "evaluate/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string_view>
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

fs::path partial_name(const fs::path& folder, const FileText& file) {
  return folder / fmt::format(".{}.partial", file.name);
}

InputError cannot_write(const fs::path& file, int error) {
  return {file.string(), "", "", "cannot be written: " + reason(error)};
}

void write_partial(const fs::path& folder, const FileText& file) {
  const fs::path partial = partial_name(folder, file);
  const int descriptor = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw cannot_write(folder / file.name, errno);
  int error = write_all(descriptor, file.text);
  // Some file systems tell of a full disk only on closing.
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) throw cannot_write(folder / file.name, error);
}

}  // namespace

void write_together(const fs::path& folder, const std::vector<FileText>& files) {
  std::error_code error;
  const bool created = fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "", "", "cannot be created: " + error.message());
  try {
    for (const FileText& file : files) write_partial(folder, file);
    for (const FileText& file : files) {
      if (::rename(partial_name(folder, file).c_str(), (folder / file.name).c_str()) != 0) {
        throw cannot_write(folder / file.name, errno);
      }
    }
  } catch (const InputError&) {
    for (const FileText& file : files) ::unlink(partial_name(folder, file).c_str());
    if (created) ::rmdir(folder.c_str());
    throw;
  }
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
