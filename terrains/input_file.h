// Files that a user names, read only when they are files: a pipe or a device would block for ever.
#pragma once

#include <filesystem>
#include <string>

namespace headland {

// Throws InputError unless `file` is a regular file that may be read.
void require_file(const std::filesystem::path& file);

// The same, but a folder of such files will do: some of GDAL's formats are folders.
void require_file_or_folder(const std::filesystem::path& file);

// The whole of `file`. Throws InputError as require_file does, and when reading fails.
std::string read_text(const std::filesystem::path& file);

}  // namespace headland
