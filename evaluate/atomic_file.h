// Writing a result so that it is there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace headland {

// Writes `content` beside `file` under a temporary name, checks that it arrived, and renames it.
// On failure the temporary file is removed, an older `file` stays as it was, and InputError names
// the file and the system's reason (no space left, permission denied, ...).
void write_atomically(const std::filesystem::path& file, std::string_view content);

// Throws InputError when results could not be written to `folder` (which need not exist yet): some
// part of its path is a file, or the nearest existing folder may not be written to.
void check_output_folder(const std::filesystem::path& folder);

// Creates `folder` with its parents. Throws InputError.
void create_output_folder(const std::filesystem::path& folder);

// The whole of `file`. Throws InputError when it is missing, a folder or unreadable.
std::string read_text(const std::filesystem::path& file);

}  // namespace headland
