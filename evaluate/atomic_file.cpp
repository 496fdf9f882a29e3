#include "evaluate/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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

// A second name of the file that is about to be replaced, until all are.
fs::path previous_name(const fs::path& folder, const FileText& file) {
  return folder / fmt::format(".{}.previous", file.name);
}

InputError cannot_write(const fs::path& file, int error) {
  return {file.string(), "", "", "cannot be written: " + reason(error)};
}

// Creates `folder` and returns it and those of its parents that were missing too, deepest first.
std::vector<fs::path> create_folders(const fs::path& folder) {
  std::vector<fs::path> created;
  std::error_code error;
  for (fs::path missing = folder; !missing.empty() && !fs::exists(missing, error);
       missing = missing.parent_path()) {
    created.push_back(missing);
  }
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "", "", "cannot be created: " + error.message());
  return created;
}

void write_partial(const fs::path& folder, const FileText& file) {
  const fs::path partial = partial_name(folder, file);
  // Not to wait for a reader where a pipe of that name stands.
  const int descriptor =
      ::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor < 0) throw cannot_write(folder / file.name, errno);
  int error = write_all(descriptor, file.text);
  // Some file systems tell of a full disk only on closing.
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) throw cannot_write(folder / file.name, error);
}

enum class Old { kNone, kKept, kLost };  // what was there before, and whether it can come back

Old replace(const fs::path& folder, const FileText& file) {
  const fs::path target = folder / file.name;
  const fs::path previous = previous_name(folder, file);
  ::unlink(previous.c_str());
  Old old = Old::kKept;
  if (::link(target.c_str(), previous.c_str()) != 0) {
    // Not every file system has second names.
    old = errno == ENOENT ? Old::kNone : Old::kLost;
  }
  if (::rename(partial_name(folder, file).c_str(), target.c_str()) != 0) {
    throw cannot_write(target, errno);
  }
  return old;
}

void put_back(const fs::path& folder, const FileText& file, Old old) {
  const fs::path target = folder / file.name;
  if (old == Old::kKept) ::rename(previous_name(folder, file).c_str(), target.c_str());
  if (old == Old::kNone) ::unlink(target.c_str());
}

}  // namespace

void write_together(const fs::path& folder, const std::vector<FileText>& files) {
  const std::vector<fs::path> created = create_folders(folder);
  std::vector<Old> replaced;
  const auto remove_left_overs = [&] {
    for (const FileText& file : files) {
      ::unlink(partial_name(folder, file).c_str());
      ::unlink(previous_name(folder, file).c_str());
    }
  };
  try {
    for (const FileText& file : files) require_replaceable(folder / file.name);
    for (const FileText& file : files) write_partial(folder, file);
    for (const FileText& file : files) replaced.push_back(replace(folder, file));
  } catch (const InputError&) {
    for (std::size_t i = 0; i < replaced.size(); ++i) put_back(folder, files[i], replaced[i]);
    remove_left_overs();
    for (const fs::path& made : created) ::rmdir(made.c_str());
    throw;
  }
  remove_left_overs();
}

void require_replaceable(const fs::path& file) {
  std::error_code ignored;
  const fs::file_type there = fs::status(file, ignored).type();
  if (there == fs::file_type::not_found || there == fs::file_type::regular) return;
  const bool folder = there == fs::file_type::directory;
  throw InputError(file.string(), "", "",
                   fmt::format("cannot be written: {} of that name is in the way",
                               folder ? "a folder" : "something that is no plain file"));
}

void check_output_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError("-o", "", "", "a folder for the results is needed");
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

}  // namespace headland
