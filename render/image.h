// A picture in memory, and its PNG file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace headland {

// 8-bit RGBA, rows from top to bottom, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// Writes a PNG to a temporary name and renames it. Throws InputError when it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

// Reads any PNG as RGBA. Throws InputError for a missing file or one that is not a PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace headland
