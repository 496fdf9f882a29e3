// A picture in memory, and its PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace headland {

// 8-bit RGBA, rows from top to bottom, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// The bytes of a PNG file. Throws InputError when libpng cannot make one.
std::string png_of(const Image& image);

// The picture in the bytes of a PNG file; `name` is told in the InputError that is thrown when they
// are none, or only a part of one.
Image image_of_png(const std::string& bytes, const std::string& name);

}  // namespace headland
