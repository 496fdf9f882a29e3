#include "evaluate/ground_patches.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace headland {
namespace {

struct RasterCell {
  int column = 0;
  int row = 0;
};

Eigen::Vector2d cell_centre_W(const CoverageRaster& raster, RasterCell cell) {
  return raster.origin_W + raster.cell_m * Eigen::Vector2d(cell.column + 0.5, cell.row + 0.5);
}

// Of workable cells whose times covered are `wanted`.
template <typename Wanted>
std::vector<GroundPatch> patches_of(const CoverageRaster& raster, double least_m2, Wanted wanted) {
  const auto index = [&](RasterCell cell) {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(raster.columns) +
           static_cast<std::size_t>(cell.column);
  };
  std::vector<bool> seen(raster.times.size(), false);
  const auto take = [&](RasterCell cell) {
    if (cell.column < 0 || cell.row < 0 || cell.column >= raster.columns ||
        cell.row >= raster.rows) {
      return false;
    }
    const std::size_t i = index(cell);
    if (seen[i] || raster.in_field[i] == 0 || !wanted(raster.times[i])) return false;
    seen[i] = true;
    return true;
  };
  std::vector<GroundPatch> patches;
  std::vector<RasterCell> patch;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      if (!take({column, row})) continue;
      patch.assign(1, {column, row});
      for (std::size_t next = 0; next < patch.size(); ++next) {
        const RasterCell cell = patch[next];
        constexpr std::array<RasterCell, 4> kBeside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
        for (const RasterCell& beside : kBeside) {
          const RasterCell there{cell.column + beside.column, cell.row + beside.row};
          if (take(there)) patch.push_back(there);
        }
      }
      const double area_m2 = static_cast<double>(patch.size()) * raster.cell_m * raster.cell_m;
      if (area_m2 < least_m2) continue;
      Eigen::Vector2d middle_W = Eigen::Vector2d::Zero();
      for (const RasterCell& cell : patch) middle_W += cell_centre_W(raster, cell);
      middle_W /= static_cast<double>(patch.size());
      const RasterCell nearest = *std::ranges::min_element(patch, {}, [&](const RasterCell& cell) {
        return (cell_centre_W(raster, cell) - middle_W).squaredNorm();
      });
      patches.push_back({cell_centre_W(raster, nearest), area_m2});
    }
  }
  std::ranges::stable_sort(
      patches, [](const GroundPatch& a, const GroundPatch& b) { return a.area_m2 > b.area_m2; });
  return patches;
}

}  // namespace

std::vector<GroundPatch> missed_patches(const CoverageRaster& raster, double least_m2) {
  return patches_of(raster, least_m2, [](std::uint8_t times) { return times == 0; });
}

std::vector<GroundPatch> overlapped_patches(const CoverageRaster& raster, double least_m2) {
  return patches_of(raster, least_m2, [](std::uint8_t times) { return times > 1; });
}

}  // namespace headland
