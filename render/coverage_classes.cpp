#include "render/coverage_classes.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace headland {
namespace {

// 0, 1, 2: worked once, twice, more often; 3: missed; none: ground that is not to be worked.
std::optional<std::size_t> class_of(std::uint8_t times, bool in_field) {
  if (times == 0) return in_field ? std::optional<std::size_t>(3) : std::nullopt;
  return std::min<std::size_t>(times, 3) - 1;
}

}  // namespace

CoverageClasses coverage_classes(const CoverageRaster& coverage, bool mark_missed) {
  const int largest = std::max(coverage.columns, coverage.rows);
  const int step = std::max(1, (largest + kMaxTexels - 1) / kMaxTexels);
  CoverageClasses classes;
  classes.columns = (coverage.columns + step - 1) / step;
  classes.rows = (coverage.rows + step - 1) / step;
  classes.origin_W = coverage.origin_W;
  classes.size_m = coverage.cell_m * step * Eigen::Vector2d(classes.columns, classes.rows);
  const std::size_t texels =
      static_cast<std::size_t>(classes.columns) * static_cast<std::size_t>(classes.rows);
  std::vector<std::uint32_t> counts(4 * texels, 0);
  for (int row = 0; row < coverage.rows; ++row) {
    for (int column = 0; column < coverage.columns; ++column) {
      const std::size_t cell =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(coverage.columns) +
          static_cast<std::size_t>(column);
      const auto kind = class_of(coverage.times[cell], coverage.in_field[cell] != 0);
      if (!kind || (*kind == 3 && !mark_missed)) continue;
      const std::size_t texel =
          static_cast<std::size_t>(row / step) * static_cast<std::size_t>(classes.columns) +
          static_cast<std::size_t>(column / step);
      ++counts[4 * texel + *kind];
    }
  }
  classes.shares.resize(counts.size());
  const auto cells = static_cast<std::uint32_t>(step * step);
  std::transform(
      counts.begin(), counts.end(), classes.shares.begin(),
      [cells](std::uint32_t count) { return static_cast<std::uint8_t>(255 * count / cells); });
  return classes;
}

CoverageAreas coverage_areas(const CoverageRaster& coverage) {
  CoverageAreas areas;
  const double cell_m2 = coverage.cell_m * coverage.cell_m;
  for (std::size_t cell = 0; cell < coverage.times.size(); ++cell) {
    const bool in_field = coverage.in_field[cell] != 0;
    const auto kind = class_of(coverage.times[cell], in_field);
    if (!kind) continue;
    (in_field ? areas.inside_m2[*kind] : areas.outside_m2) += cell_m2;
  }
  return areas;
}

}  // namespace headland
