// Driven coverage as the pictures show it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evaluate/coverage.h"

namespace headland {

// Texels of shares (0..255) of ground worked once, twice, three times or more, and missed, in this
// order; rows from south to north, as the raster. Averages of neighbouring texels are again
// shares, which is why classes and not counts go to the graphics side.
struct CoverageClasses {
  int columns = 0;
  int rows = 0;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();
  std::vector<std::uint8_t> shares;  // 4 a texel
};

// Ground of the field that was not worked is missed only if `mark_missed`; otherwise it is plain
// ground. Rasters wider than `kMaxTexels` are averaged over whole cells.
inline constexpr int kMaxTexels = 4096;
CoverageClasses coverage_classes(const CoverageRaster& coverage, bool mark_missed);

// Areas [m2] inside the field: worked once, twice, three times or more, missed; and worked outside.
struct CoverageAreas {
  std::array<double, 4> inside_m2{};
  double outside_m2 = 0.0;
};
CoverageAreas coverage_areas(const CoverageRaster& coverage);

}  // namespace headland
