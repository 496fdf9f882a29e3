// Writing results so that they are there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace headland {

struct FileText {
  std::string name;
  std::string text;
};

// Writes the files of `folder` under temporary names, checks that they arrived, and only then
// renames them all; creates the folder if need be. On failure the temporary files (and folders
// made for them) are removed, older files stay as they were or are put back, and InputError names
// the file and the system's reason (no space left, permission denied, ...).
void write_together(const std::filesystem::path& folder, const std::vector<FileText>& files);

// Throws InputError when anything but a plain file (a folder, a device, a pipe) stands where `file`
// is to be written.
void require_replaceable(const std::filesystem::path& file);

// Throws InputError when results could not be written to `folder` (which need not exist yet): some
// part of its path is a file, or the nearest existing folder may not be written to.
void check_output_folder(const std::filesystem::path& folder);

}  // namespace headland
