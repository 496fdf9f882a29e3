// What the implement really worked, from its driven footprint.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/run_record.h"
#include "terrains/field.h"

namespace headland {

// Times covered per cell of a raster over the field's bounding box (with a margin of one working
// width): cell (i, j) has its centre at origin_W + cell_m * (i + 0.5, j + 0.5).
// A cell counts again when the implement comes back after having travelled kCoverageGap away.
struct CoverageRaster {
  int columns = 0;
  int rows = 0;
  double cell_m = 0.25;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  std::vector<std::uint8_t> times;     // row-major, saturates at 255
  std::vector<std::uint8_t> in_field;  // 1 where the cell's centre is workable ground
};

inline constexpr double kCoverageGap_m = 1.0;

struct CoverageFigures {
  double workable_m2 = 0.0;  // field minus holes and obstacles
  double covered_m2 = 0.0;   // worked at least once, inside the field
  double overlap_m2 = 0.0;   // extra passes: sum of (times - 1), inside the field
  double missed_m2 = 0.0;
  double outside_m2 = 0.0;  // worked outside the field or in a hole
};

CoverageRaster measure_coverage(const Field& field, const std::vector<FootprintSample>& footprints,
                                double working_width_m, double cell_m);
CoverageFigures coverage_figures(const CoverageRaster& raster);

}  // namespace headland
