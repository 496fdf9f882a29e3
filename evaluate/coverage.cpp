#include "evaluate/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/scanline.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;

  void include(const Eigen::Vector2d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

bool finite(const FootprintSample& footprint) {
  return footprint.left_W.allFinite() && footprint.right_W.allFinite();
}

Box box_of(const Ring& ring) {
  Box box;
  for (const Eigen::Vector2d& p_W : ring) box.include(p_W);
  return box;
}

Box widened(Box box, double margin_m) {
  box.low -= Eigen::Vector2d::Constant(margin_m);
  box.high += Eigen::Vector2d::Constant(margin_m);
  return box;
}

double widest_margin_m(double working_width_m) {
  return std::max(kMaxCoverageMargin_m, working_width_m);
}

// Columns and rows of a raster over `box`; refuses what would take too much memory to measure.
Eigen::Vector2d cells_of(const Box& box, double cell_m, const std::string& source) {
  // The raster's two bytes and the travel at the last touch.
  constexpr double kGbPerCell = 1e-9 * (2 + sizeof(float));
  const Eigen::Vector2d cells = ((box.high - box.low) / cell_m).array().ceil();
  const double needed_gb = cells.prod() * kGbPerCell;
  if (needed_gb <= kMaxCoverageMemory_gb) return cells;
  const double enough_m = 1.05 * cell_m * std::sqrt(needed_gb / kMaxCoverageMemory_gb);
  throw InputError(source, "coverage.cell_m", fmt::format("{:g}", cell_m),
                   fmt::format("{:.0f} x {:.0f} cells need {:.1f} GB, more than {:g} GB; at least "
                               "{:.2g} m for this field",
                               cells.x(), cells.y(), needed_gb, kMaxCoverageMemory_gb, enough_m));
}

CoverageRaster empty_raster(const Field& field, const std::vector<FootprintSample>& footprints,
                            double working_width_m, double cell_m) {
  const Box ground = box_of(field.boundary);
  const Box most = widened(ground, widest_margin_m(working_width_m));
  Box box = widened(ground, working_width_m);
  for (const FootprintSample& footprint : footprints) {
    if (!finite(footprint)) continue;
    box.include(footprint.left_W);
    box.include(footprint.right_W);
  }
  box.low = box.low.cwiseMax(most.low);
  box.high = box.high.cwiseMin(most.high);

  const Eigen::Vector2d cells = cells_of(box, cell_m, "");
  CoverageRaster raster;
  raster.columns = static_cast<int>(cells.x());
  raster.rows = static_cast<int>(cells.y());
  raster.cell_m = cell_m;
  raster.origin_W = box.low;
  const auto count =
      static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  raster.times.assign(count, 0);
  raster.in_field.assign(count, 0);
  return raster;
}

// p_W in the scanline's units, where cell centres are whole numbers.
Eigen::Vector2d in_cells(const CoverageRaster& raster, const Eigen::Vector2d& p_W) {
  return (p_W - raster.origin_W) / raster.cell_m - Eigen::Vector2d::Constant(0.5);
}

std::size_t index_of(const CoverageRaster& raster, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
         static_cast<std::size_t>(column);
}

void add_ring(Scanline& scan, const CoverageRaster& raster, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add_edge(scan, in_cells(raster, ring[i]), in_cells(raster, ring[(i + 1) % ring.size()]));
  }
}

void clear_obstacle(CoverageRaster& raster, const Obstacle& obstacle) {
  Box box;
  box.include(obstacle.p_W);
  box.include(obstacle.p_W + obstacle.run_W);
  box = widened(box, obstacle.radius_m);
  const Eigen::Vector2d low = in_cells(raster, box.low);
  const Eigen::Vector2d high = in_cells(raster, box.high);
  const int end_row = first_cell(high.y(), raster.rows);
  const int end_column = first_cell(high.x(), raster.columns);
  for (int row = first_cell(low.y(), raster.rows); row < end_row; ++row) {
    for (int column = first_cell(low.x(), raster.columns); column < end_column; ++column) {
      const Eigen::Vector2d middle_W =
          raster.origin_W + raster.cell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      if (obstacle_gap_m(obstacle, middle_W) <= 0.0) {
        raster.in_field[index_of(raster, column, row)] = 0;
      }
    }
  }
}

void mark_field(CoverageRaster& raster, Scanline& scan, const Field& field) {
  if (field.to_work.empty()) {
    add_ring(scan, raster, field.boundary);
    for (const Ring& hole : field.holes) add_ring(scan, raster, hole);
  }
  for (const Ring& outline : field.to_work) add_ring(scan, raster, outline);
  fill(scan, [&](int row, int begin, int end) {
    const auto first =
        raster.in_field.begin() + static_cast<std::ptrdiff_t>(index_of(raster, begin, row));
    std::fill(first, first + (end - begin), std::uint8_t{1});
  });
  for (const Obstacle& obstacle : field.obstacles) clear_obstacle(raster, obstacle);
}

}  // namespace

GrowingCoverage start_coverage(const Field& field, const std::vector<FootprintSample>& footprints,
                               double working_width_m, double cell_m) {
  assert(cell_m > 0.0 && working_width_m > 0.0);
  GrowingCoverage coverage;
  coverage.raster = empty_raster(field, footprints, working_width_m, cell_m);
  coverage.scan = make_scanline(coverage.raster.columns, coverage.raster.rows);
  constexpr float kNever = -std::numeric_limits<float>::infinity();
  coverage.last_touch_m.assign(coverage.raster.times.size(), kNever);
  mark_field(coverage.raster, coverage.scan, field);
  return coverage;
}

void grow_coverage(GrowingCoverage& coverage, const std::vector<FootprintSample>& footprints,
                   std::size_t end) {
  CoverageRaster& raster = coverage.raster;
  for (std::size_t k = std::max<std::size_t>(coverage.added, 1); k < end; ++k) {
    const FootprintSample& before = footprints[k - 1];
    const FootprintSample& now = footprints[k];
    if (now.starts_strip || !finite(before) || !finite(now)) continue;
    const Eigen::Vector2d corners[] = {in_cells(raster, before.left_W),
                                       in_cells(raster, before.right_W),
                                       in_cells(raster, now.right_W), in_cells(raster, now.left_W)};
    for (std::size_t c = 0; c < 4; ++c) add_edge(coverage.scan, corners[c], corners[(c + 1) % 4]);
    fill(coverage.scan, [&](int row, int begin, int end_column) {
      for (int column = begin; column < end_column; ++column) {
        const std::size_t cell = index_of(raster, column, row);
        float& last_touch_m = coverage.last_touch_m[cell];
        if (now.travel_m - last_touch_m > kCoverageGap_m && raster.times[cell] < 255) {
          ++raster.times[cell];
        }
        last_touch_m = static_cast<float>(now.travel_m);
      }
    });
  }
  coverage.added = std::max(coverage.added, end);
}

CoverageRaster measure_coverage(const Field& field, const std::vector<FootprintSample>& footprints,
                                double working_width_m, double cell_m) {
  GrowingCoverage coverage = start_coverage(field, footprints, working_width_m, cell_m);
  grow_coverage(coverage, footprints, footprints.size());
  return std::move(coverage.raster);
}

void check_coverage_size(const Field& field, double working_width_m, double cell_m,
                         const std::string& source) {
  cells_of(widened(box_of(field.boundary), widest_margin_m(working_width_m)), cell_m, source);
}

CoverageFigures coverage_figures(const CoverageRaster& raster) {
  std::size_t workable = 0;
  std::size_t covered = 0;
  std::size_t passes = 0;
  std::size_t outside = 0;
  for (std::size_t cell = 0; cell < raster.times.size(); ++cell) {
    const std::uint8_t times = raster.times[cell];
    if (raster.in_field[cell] != 0) {
      ++workable;
      covered += times > 0 ? 1 : 0;
      passes += times;
    } else {
      outside += times > 0 ? 1 : 0;
    }
  }
  const double cell_m2 = raster.cell_m * raster.cell_m;
  CoverageFigures figures;
  figures.workable_m2 = cell_m2 * static_cast<double>(workable);
  figures.covered_m2 = cell_m2 * static_cast<double>(covered);
  figures.overlap_m2 = cell_m2 * static_cast<double>(passes - covered);
  figures.missed_m2 = cell_m2 * static_cast<double>(workable - covered);
  figures.outside_m2 = cell_m2 * static_cast<double>(outside);
  return figures;
}

}  // namespace headland
