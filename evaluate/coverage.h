// What the implement really worked, from its driven footprint.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "planner/scanline.h"
#include "sim/run_record.h"
#include "terrains/field.h"

namespace headland {

// Times covered per cell of a raster: cell (i, j) has its centre at
// origin_W + cell_m * (i + 0.5, j + 0.5) and belongs wholly to what its centre belongs to. The
// raster spans the field's bounding box with a margin of one working width, wider where the
// implement worked further out, up to kMaxCoverageMargin_m.
// A cell counts again when the implement comes back after having travelled kCoverageGap_m since it
// last touched the cell.
struct CoverageRaster {
  int columns = 0;
  int rows = 0;
  double cell_m = 0.25;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  std::vector<std::uint8_t> times;     // row-major, saturates at 255
  std::vector<std::uint8_t> in_field;  // 1 where the cell's centre is workable ground
};

inline constexpr double kCoverageGap_m = 1.0;
inline constexpr double kMaxCoverageMargin_m = 100.0;
inline constexpr double kMaxCoverageMemory_gb = 2.0;

struct CoverageFigures {
  double workable_m2 = 0.0;  // field minus holes and obstacles, or what of it is to be worked
  double covered_m2 = 0.0;   // worked at least once, workable ground
  double overlap_m2 = 0.0;   // extra passes: sum of (times - 1), workable ground
  double missed_m2 = 0.0;
  double outside_m2 = 0.0;  // worked elsewhere: beyond the boundary, in a hole, on an obstacle
};

// Fills the quadrangle between each footprint and the one it is joined to. The rule is half-open:
// quadrangles that share an edge share out its cells, so that a strip has neither gaps nor doubles.
// Footprints that are not finite are left out. Throws InputError (coverage.cell_m) when measuring
// would need more than kMaxCoverageMemory_gb.
CoverageRaster measure_coverage(const Field& field, const std::vector<FootprintSample>& footprints,
                                double working_width_m, double cell_m);

// The same while a run goes on.
struct GrowingCoverage {
  CoverageRaster raster;
  Scanline scan;
  std::vector<float> last_touch_m;  // travel; at 100 km a float is still within 4 mm
  std::size_t added = 0;            // footprints so far
};

// None added yet; the raster spans what all of `footprints` will work, so that it stays in place.
GrowingCoverage start_coverage(const Field& field, const std::vector<FootprintSample>& footprints,
                               double working_width_m, double cell_m);

// Adds those of the same footprints that come before `end`, which never goes back.
void grow_coverage(GrowingCoverage& coverage, const std::vector<FootprintSample>& footprints,
                   std::size_t end);

// Throws InputError as measure_coverage does, naming `source`, when it could for this field: what
// passes can be measured wherever the implement works.
void check_coverage_size(const Field& field, double working_width_m, double cell_m,
                         const std::string& source);

CoverageFigures coverage_figures(const CoverageRaster& raster);

}  // namespace headland
