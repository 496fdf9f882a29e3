// A picture in memory.
#pragma once

#include <cstdint>
#include <vector>

namespace headland {

// 8-bit RGBA, rows from top to bottom, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace headland
