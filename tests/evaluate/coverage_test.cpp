#include "evaluate/coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kCell_m = 0.25;

Field rectangle(double width_m, double height_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  return field;
}

// Footprints of a bar of `width_m` driven along a line, as one strip.
void drive(std::vector<FootprintSample>& footprints, const Eigen::Vector2d& from,
           const Eigen::Vector2d& to, double width_m, double spacing_m = 0.1) {
  const double start_m = footprints.empty() ? 0.0 : footprints.back().travel_m + 10.0;
  const double length_m = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length_m;
  const Eigen::Vector2d left(-along.y(), along.x());
  const int steps = static_cast<int>(std::ceil(length_m / spacing_m));
  for (int k = 0; k <= steps; ++k) {
    const double s_m = length_m * k / steps;
    FootprintSample sample;
    sample.left_W = from + s_m * along + 0.5 * width_m * left;
    sample.right_W = from + s_m * along - 0.5 * width_m * left;
    sample.travel_m = start_m + s_m;
    sample.starts_strip = k == 0;
    footprints.push_back(sample);
  }
}

CoverageFigures figures(const Field& field, const std::vector<FootprintSample>& footprints,
                        double width_m, double cell_m = kCell_m) {
  return coverage_figures(measure_coverage(field, footprints, width_m, cell_m));
}

// A cell belongs to its centre, so an edge is misplaced by at most half a cell: the
// area is off by at most perimeter * cell / 2, and far less where the edge crosses the grid
// obliquely.
double edge_tolerance_m2(double perimeter_m, double cell_m = kCell_m) {
  return 0.5 * perimeter_m * cell_m;
}

// Around a circle the errors of its edge have both signs and mostly cancel.
double circle_tolerance_m2(double radius_m) {
  return edge_tolerance_m2(2.0 * std::numbers::pi * radius_m) / 3.0;
}

TEST(Coverage, NothingDrivenMissesEverything) {
  const CoverageFigures f = figures(rectangle(40.0, 20.0), {}, 2.0);
  EXPECT_DOUBLE_EQ(f.workable_m2, 800.0);
  EXPECT_EQ(f.covered_m2, 0.0);
  EXPECT_EQ(f.overlap_m2, 0.0);
  EXPECT_EQ(f.outside_m2, 0.0);
  EXPECT_DOUBLE_EQ(f.missed_m2, 800.0);
}

TEST(Coverage, StraightStripOnGridLinesIsExact) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {5.0, 10.0}, {35.0, 10.0}, 2.0);
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 2.0);
  EXPECT_DOUBLE_EQ(f.covered_m2, 60.0);
  EXPECT_EQ(f.overlap_m2, 0.0);
  EXPECT_DOUBLE_EQ(f.missed_m2, 740.0);
}

TEST(Coverage, ObliqueStripHasItsAnalyticArea) {
  for (const double angle_deg : {7.0, 31.0, 45.0, 83.0, 158.0, 271.0}) {
    const double angle_rad = angle_deg * std::numbers::pi / 180.0;
    const Eigen::Vector2d middle(50.0, 50.0);
    const Eigen::Vector2d half = 20.0 * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    std::vector<FootprintSample> footprints;
    drive(footprints, middle - half, middle + half, 3.0);
    const CoverageFigures f = figures(rectangle(100.0, 100.0), footprints, 3.0);
    EXPECT_NEAR(f.covered_m2, 120.0, 0.1 * edge_tolerance_m2(86.0)) << angle_deg;
    EXPECT_EQ(f.overlap_m2, 0.0) << angle_deg;
  }
}

TEST(Coverage, HalvingTheCellChangesTheAreaByLessThanAPercent) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {3.3, 4.1}, {88.7, 61.9}, 2.7);
  drive(footprints, {88.7, 70.0}, {3.3, 12.2}, 2.7);
  const Field field = rectangle(100.0, 100.0);
  constexpr double kAreaTolerance = 0.01;
  double coarse_m2 = figures(field, footprints, 2.7, 0.5).covered_m2;
  for (const double cell_m : {0.25, 0.125, 0.0625}) {
    const double fine_m2 = figures(field, footprints, 2.7, cell_m).covered_m2;
    EXPECT_NEAR(fine_m2, coarse_m2, kAreaTolerance * coarse_m2) << cell_m;
    coarse_m2 = fine_m2;
  }
}

TEST(Coverage, OverlapOfTwoStripsIsCountedOnce) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {5.0, 10.0}, {35.0, 10.0}, 2.0);
  drive(footprints, {35.0, 11.5}, {5.0, 11.5}, 2.0);
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 2.0);
  EXPECT_DOUBLE_EQ(f.covered_m2, 105.0);
  EXPECT_DOUBLE_EQ(f.overlap_m2, 15.0);
}

TEST(Coverage, AdjoiningStripsNeitherGapNorDouble) {
  // Edges at 11.0 m exactly: the half-open rule gives every cell to one of the two.
  std::vector<FootprintSample> footprints;
  drive(footprints, {5.0, 10.0}, {35.0, 10.0}, 2.0);
  drive(footprints, {35.0, 12.0}, {5.0, 12.0}, 2.0);
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 2.0);
  EXPECT_DOUBLE_EQ(f.covered_m2, 120.0);
  EXPECT_EQ(f.overlap_m2, 0.0);
}

TEST(Coverage, GapBetweenStripsIsMissed) {
  std::vector<FootprintSample> footprints;
  for (const double y_m : {1.0, 3.0, 6.0, 8.0}) drive(footprints, {-1.0, y_m}, {41.0, y_m}, 2.0);
  const CoverageFigures f = figures(rectangle(40.0, 9.0), footprints, 2.0);
  EXPECT_DOUBLE_EQ(f.missed_m2, 40.0);
  EXPECT_DOUBLE_EQ(f.covered_m2, 320.0);
  EXPECT_DOUBLE_EQ(f.outside_m2, 4 * 2.0 * 2.0);
}

TEST(Coverage, RaisedImplementLeavesNoStrip) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {5.0, 10.0}, {10.0, 10.0}, 2.0);
  drive(footprints, {30.0, 10.0}, {35.0, 10.0}, 2.0);
  EXPECT_DOUBLE_EQ(figures(rectangle(40.0, 20.0), footprints, 2.0).covered_m2, 20.0);
  // Negative control: joined by mistake, the gap would be filled.
  for (FootprintSample& sample : footprints) sample.starts_strip = false;
  EXPECT_DOUBLE_EQ(figures(rectangle(40.0, 20.0), footprints, 2.0).covered_m2, 60.0);
}

TEST(Coverage, WorkBeyondTheBoundaryIsOutsideHoweverFar) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {30.0, 10.0}, {60.0, 10.0}, 2.0);
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 2.0);
  EXPECT_DOUBLE_EQ(f.covered_m2, 20.0);
  EXPECT_DOUBLE_EQ(f.outside_m2, 40.0);
}

TEST(Coverage, TheRasterStaysSmallWhateverTheFootprints) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {30.0, 10.0}, {1.0e7, 10.0}, 2.0, 1.0e6);
  const CoverageRaster raster = measure_coverage(rectangle(40.0, 20.0), footprints, 2.0, 1.0);
  EXPECT_LE(raster.columns, 40 + 2 + kMaxCoverageMargin_m);
  EXPECT_DOUBLE_EQ(coverage_figures(raster).covered_m2, 20.0);
}

TEST(Coverage, HolesAndObstaclesAreNotWorkable) {
  Field field = rectangle(40.0, 20.0);
  field.holes.push_back({{10.0, 5.0}, {10.0, 15.0}, {20.0, 15.0}, {20.0, 5.0}});
  field.obstacles.push_back({.p_W = {30.0, 10.0}, .radius_m = 2.0});
  const double disc_m2 = 4.0 * std::numbers::pi;
  const CoverageFigures idle = figures(field, {}, 2.0);
  EXPECT_NEAR(idle.workable_m2, 700.0 - disc_m2, circle_tolerance_m2(2.0));

  std::vector<FootprintSample> footprints;
  drive(footprints, {0.0, 10.0}, {40.0, 10.0}, 2.0);
  const CoverageFigures f = figures(field, footprints, 2.0);
  // The strip crosses the hole over 10 m and the disc in a band of half-width 1 m.
  const double band_m2 = 2.0 * (std::sqrt(3.0) + 4.0 * std::asin(0.5));
  EXPECT_NEAR(f.outside_m2, 20.0 + band_m2, edge_tolerance_m2(4.0));
  EXPECT_DOUBLE_EQ(f.covered_m2 + f.outside_m2, 80.0);
}

TEST(Coverage, WallsAreNotWorkable) {
  Field field = rectangle(40.0, 20.0);
  field.obstacles.push_back({ObstacleKind::kWall, {10.0, 5.0}, 0.5, 1.0, {15.0, 8.0}});
  // A strip of the wall's thickness with round ends: 17 m long, 1 m wide.
  const double wall_m2 = 17.0 * 1.0 + 0.25 * std::numbers::pi;
  EXPECT_NEAR(figures(field, {}, 2.0).workable_m2, 800.0 - wall_m2, edge_tolerance_m2(36.0));
}

TEST(Coverage, TurningAboutOneEndCoversTheDiscOnce) {
  std::vector<FootprintSample> footprints;
  constexpr double kBar_m = 4.0;
  for (int k = 0; k <= 360; ++k) {
    const double angle_rad = 2.0 * std::numbers::pi * k / 360.0;
    FootprintSample sample;
    sample.left_W = {20.0, 10.0};
    sample.right_W =
        sample.left_W + kBar_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    sample.travel_m = 0.5 * kBar_m * angle_rad;
    sample.starts_strip = k == 0;
    footprints.push_back(sample);
  }
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, kBar_m);
  const double disc_m2 = std::numbers::pi * kBar_m * kBar_m;
  EXPECT_NEAR(f.covered_m2, disc_m2, circle_tolerance_m2(kBar_m));
  EXPECT_EQ(f.overlap_m2, 0.0);
}

TEST(Coverage, TurningAboutTheMiddleOnTheSpotIsNotAnOverlap) {
  // The inner half of the bar sweeps backwards: its quadrangles cross themselves. Without travel
  // nothing is touched "again".
  std::vector<FootprintSample> footprints;
  for (int k = 0; k <= 360; ++k) {
    const double angle_rad = 4.0 * std::numbers::pi * k / 360.0;
    const Eigen::Vector2d arm(2.0 * std::cos(angle_rad), 2.0 * std::sin(angle_rad));
    FootprintSample sample;
    sample.left_W = Eigen::Vector2d(20.0, 10.0) + arm;
    sample.right_W = Eigen::Vector2d(20.0, 10.0) - arm;
    sample.starts_strip = k == 0;
    footprints.push_back(sample);
  }
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 4.0);
  EXPECT_NEAR(f.covered_m2, 4.0 * std::numbers::pi, circle_tolerance_m2(2.0));
  EXPECT_EQ(f.overlap_m2, 0.0);
}

TEST(Coverage, ComingBackAfterTheGapCountsAgain) {
  // Twice around a circle: every cell is left for 2 pi r - its own stay, far more than the gap.
  std::vector<FootprintSample> footprints;
  constexpr double kRadius_m = 6.0;
  for (int k = 0; k <= 1440; ++k) {
    const double angle_rad = 4.0 * std::numbers::pi * k / 1440.0;
    const Eigen::Vector2d outwards(std::cos(angle_rad), std::sin(angle_rad));
    FootprintSample sample;
    sample.left_W = Eigen::Vector2d(20.0, 10.0) + (kRadius_m - 1.0) * outwards;
    sample.right_W = Eigen::Vector2d(20.0, 10.0) + (kRadius_m + 1.0) * outwards;
    sample.travel_m = kRadius_m * angle_rad;
    sample.starts_strip = k == 0;
    footprints.push_back(sample);
  }
  const CoverageFigures f = figures(rectangle(40.0, 20.0), footprints, 2.0);
  const double ring_m2 = 4.0 * std::numbers::pi * kRadius_m;
  EXPECT_NEAR(f.covered_m2, ring_m2, 2.0 * circle_tolerance_m2(kRadius_m));
  EXPECT_NEAR(f.overlap_m2, f.covered_m2, 0.01 * ring_m2);
}

TEST(Coverage, IsInvariantUnderRotationAndTranslationOfTheWholeScene) {
  Field field = rectangle(60.0, 40.0);
  field.holes.push_back({{20.0, 10.0}, {20.0, 20.0}, {35.0, 20.0}, {35.0, 10.0}});
  std::vector<FootprintSample> footprints;
  for (int k = 0; k < 15; ++k) {
    const double y_m = 1.5 + 2.6 * k;
    drive(footprints, {-1.0, y_m}, {61.0, y_m}, 3.0);
  }
  const CoverageFigures here = figures(field, footprints, 3.0);
  for (const double angle_rad : {0.4, 1.1, 2.9}) {
    const Eigen::Isometry2d X_WS =
        Eigen::Translation2d(531.7, -212.3) * Eigen::Rotation2Dd(angle_rad);
    Field moved = field;
    for (Eigen::Vector2d& p_W : moved.boundary) p_W = X_WS * p_W;
    for (Eigen::Vector2d& p_W : moved.holes.front()) p_W = X_WS * p_W;
    std::vector<FootprintSample> moved_footprints = footprints;
    for (FootprintSample& sample : moved_footprints) {
      sample.left_W = X_WS * sample.left_W;
      sample.right_W = X_WS * sample.right_W;
    }
    const CoverageFigures there = figures(moved, moved_footprints, 3.0);
    // Aligned edges on one side, oblique ones on the other: half a percent of the field.
    constexpr double kTolerance_m2 = 0.005 * 60.0 * 40.0;
    EXPECT_NEAR(there.workable_m2, here.workable_m2, kTolerance_m2);
    EXPECT_NEAR(there.covered_m2, here.covered_m2, kTolerance_m2);
    EXPECT_NEAR(there.missed_m2, here.missed_m2, kTolerance_m2);
    EXPECT_NEAR(there.outside_m2, here.outside_m2, kTolerance_m2);
    // Every strip edge within the field is oblique now: 30 edges of 60 m, a tenth of a cell each.
    EXPECT_NEAR(there.overlap_m2, here.overlap_m2, 30 * 60.0 * 0.1 * kCell_m);
  }
}

TEST(Coverage, AgreesCellByCellWithAskingEveryCentre) {
  struct Strip {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };
  constexpr double kWidth_m = 3.0;
  std::mt19937_64 random(11);
  const auto coordinate = [&] { return 50.0 * std::generate_canonical<double, 53>(random); };
  std::vector<Strip> strips;
  std::vector<FootprintSample> footprints;
  for (int k = 0; k < 25; ++k) {
    Strip strip{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    strips.push_back(strip);
    drive(footprints, strip.from, strip.to, kWidth_m);
  }
  const CoverageRaster raster = measure_coverage(rectangle(50.0, 50.0), footprints, kWidth_m, 0.5);
  // Rounding decides about centres this close to an edge.
  constexpr double kOnEdge_m = 1e-9;
  int compared = 0;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const Eigen::Vector2d p_W =
          raster.origin_W + raster.cell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      int times = 0;
      bool on_edge = false;
      for (const Strip& strip : strips) {
        const Eigen::Vector2d along = (strip.to - strip.from).normalized();
        const Eigen::Vector2d p = p_W - strip.from;
        const double end_m = std::min(p.dot(along), (strip.to - strip.from).norm() - p.dot(along));
        const double side_m = 0.5 * kWidth_m - std::abs(p.x() * along.y() - p.y() * along.x());
        const double inside_m = std::min(end_m, side_m);
        on_edge = on_edge || std::abs(inside_m) < kOnEdge_m;
        times += inside_m > 0.0 ? 1 : 0;
      }
      if (on_edge) continue;
      ++compared;
      ASSERT_EQ(raster.times[static_cast<std::size_t>(row * raster.columns + column)], times)
          << p_W.transpose();
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(Coverage, FootprintsThatAreNotFiniteAreLeftOut) {
  std::vector<FootprintSample> footprints;
  drive(footprints, {5.0, 10.0}, {35.0, 10.0}, 2.0);
  footprints[100].left_W.x() = std::numeric_limits<double>::quiet_NaN();
  // Both quadrangles at the bad footprint are lost, 2 m x 0.2 m, to the nearest column of cells.
  EXPECT_NEAR(figures(rectangle(40.0, 20.0), footprints, 2.0).covered_m2, 60.0 - 0.4,
              2.0 * kCell_m);
}

TEST(Coverage, RefusesMoreCellsThanTheMachineHolds) {
  try {
    measure_coverage(rectangle(5000.0, 5000.0), {}, 2.0, 0.02);
    FAIL() << "took 6e10 cells";
  } catch (const InputError& error) {
    // (5004 / 0.02)^2 cells of 6 bytes.
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("coverage.cell_m: '0.02'"),
                                             testing::HasSubstr("need 375.6 GB"),
                                             testing::HasSubstr("at least 0.29 m")));
  }
}

TEST(Coverage, TheSizeIsRefusedBeforeDrivingWithRoomForTheWidestMargin) {
  const Field field = rectangle(1000.0, 500.0);
  EXPECT_NO_THROW(check_coverage_size(field, 2.0, 0.06, "a.yaml"));
  try {
    check_coverage_size(field, 2.0, 0.02, "a.yaml");
    FAIL() << "took 2e9 cells";
  } catch (const InputError& error) {
    // 1200 m x 700 m at 0.02 m, 6 bytes a cell.
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("a.yaml: coverage.cell_m: '0.02'"),
                                             testing::HasSubstr("need 12.6 GB")));
  }
}

}  // namespace
}  // namespace headland
