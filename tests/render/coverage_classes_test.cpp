#include "render/coverage_classes.h"

#include <gtest/gtest.h>

namespace headland {
namespace {

CoverageRaster row_of(std::vector<std::uint8_t> times, std::vector<std::uint8_t> in_field) {
  CoverageRaster raster;
  raster.columns = static_cast<int>(times.size());
  raster.rows = 1;
  raster.cell_m = 2.0;
  raster.times = std::move(times);
  raster.in_field = std::move(in_field);
  return raster;
}

TEST(CoverageClasses, TellTimesCoveredAndMissedApart) {
  const CoverageRaster raster = row_of({0, 1, 2, 3, 200, 0}, {1, 1, 1, 1, 0, 0});
  const CoverageClasses classes = coverage_classes(raster, true);
  const std::vector<std::uint8_t> expected = {0, 0, 0,   255, 255, 0, 0,   0, 0, 255, 0, 0,
                                              0, 0, 255, 0,   0,   0, 255, 0, 0, 0,   0, 0};
  EXPECT_EQ(classes.shares, expected);
  EXPECT_DOUBLE_EQ(classes.size_m.x(), 12.0);
}

TEST(CoverageClasses, LeaveMissedGroundPlainWhenAsked) {
  const CoverageClasses classes = coverage_classes(row_of({0}, {1}), false);
  EXPECT_EQ(classes.shares, std::vector<std::uint8_t>(4, 0));
}

TEST(CoverageClasses, AverageARasterThatIsTooWide) {
  // Alternately worked and missed, twice the width a texture may have.
  CoverageRaster raster = row_of({}, {});
  raster.columns = 2 * kMaxTexels;
  raster.rows = 2;
  for (int i = 0; i < raster.columns * raster.rows; ++i) {
    raster.times.push_back(static_cast<std::uint8_t>(i % 2));
    raster.in_field.push_back(1);
  }
  const CoverageClasses classes = coverage_classes(raster, true);
  EXPECT_EQ(classes.columns, kMaxTexels);
  EXPECT_EQ(classes.rows, 1);
  EXPECT_EQ(classes.shares[0], 127);
  EXPECT_EQ(classes.shares[3], 127);
}

TEST(CoverageAreas, AddUpToTheRaster) {
  const CoverageAreas areas = coverage_areas(row_of({0, 1, 1, 2, 7, 3, 0}, {1, 1, 1, 1, 1, 0, 0}));
  EXPECT_EQ(areas.inside_m2, (std::array<double, 4>{8.0, 4.0, 4.0, 4.0}));
  EXPECT_EQ(areas.outside_m2, 4.0);
}

}  // namespace
}  // namespace headland
