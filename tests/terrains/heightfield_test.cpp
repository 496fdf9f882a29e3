#include "terrains/heightfield.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "random_ring.h"

namespace headland {
namespace {

// Heights are some tens of metres: rounding is some 1e-14 m, steps of 1e-7 m cost 1e-7 relative.
constexpr double kInterpolation_m = 1e-9;

Heightfield any_terrain() {
  Heightfield terrain;
  terrain.columns = *rc::gen::inRange(2, 7);
  terrain.rows = *rc::gen::inRange(2, 7);
  terrain.cell_m = any_number(0.1, 5.0);
  terrain.origin_W = {any_number(-10.0, 10.0), any_number(-10.0, 10.0)};
  for (int k = 0; k < terrain.columns * terrain.rows; ++k) {
    terrain.height_m.push_back(any_number(0.0, 50.0));
  }
  return terrain;
}

Eigen::Vector2d place(const Heightfield& terrain, double u, double v) {
  return terrain.origin_W + terrain.cell_m * Eigen::Vector2d(u, v);
}

double height_m(const Heightfield& terrain, const Eigen::Vector2d& p_W) {
  return surface_at(terrain, p_W.x(), p_W.y()).height_m;
}

TEST(Surface, PassesThroughEveryNode) {
  EXPECT_TRUE(rc::check([&] {
    const Heightfield terrain = any_terrain();
    const int i = *rc::gen::inRange(0, terrain.columns);
    const int j = *rc::gen::inRange(0, terrain.rows);
    RC_ASSERT(std::abs(height_m(terrain, place(terrain, i, j)) - terrain.at(i, j)) < 1e-9);
  }));
}

TEST(Surface, IsContinuousAcrossCellEdgesAndDiagonals) {
  // Slopes reach 50 m over 0.1 m; a step of 1e-9 cells of at most 5 m climbs at most 5e-6 m.
  constexpr double kStep_cells = 1e-9;
  constexpr double kContinuous_m = 1e-5;
  EXPECT_TRUE(rc::check([&] {
    const Heightfield terrain = any_terrain();
    const double v = any_number(0.0, terrain.rows - 1.0);
    const double edge = *rc::gen::inRange(0, terrain.columns);
    const double before = height_m(terrain, place(terrain, edge - kStep_cells, v));
    const double after = height_m(terrain, place(terrain, edge + kStep_cells, v));
    RC_ASSERT(std::abs(before - after) < kContinuous_m);
    const double f = any_number(0.0, 1.0);
    const double below = height_m(terrain, place(terrain, f - kStep_cells, 1.0 - f));
    const double above = height_m(terrain, place(terrain, f + kStep_cells, 1.0 - f));
    RC_ASSERT(std::abs(below - above) < kContinuous_m);
  }));
}

TEST(Surface, GradientIsTheFiniteDifferenceInsideATriangle) {
  // The triangle is a plane, so only rounding is left: 1e-14 m over a step of 1e-3 of a cell.
  constexpr double kStep_cells = 1e-3;
  constexpr double kGradient = 1e-8;
  EXPECT_TRUE(rc::check([&] {
    const Heightfield terrain = any_terrain();
    const int i = *rc::gen::inRange(0, terrain.columns - 1);
    const int j = *rc::gen::inRange(0, terrain.rows - 1);
    const bool upper = *rc::gen::arbitrary<bool>();
    const double f = any_number(0.1, 0.4);
    const double g = any_number(0.1, 0.4);
    const Eigen::Vector2d p_W =
        place(terrain, i + (upper ? 1.0 - f : f), j + (upper ? 1.0 - g : g));
    const double step_m = kStep_cells * terrain.cell_m;
    const Eigen::Vector2d gradient = surface_at(terrain, p_W.x(), p_W.y()).gradient;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = step_m * Eigen::Vector2d::Unit(axis);
      const double slope =
          (height_m(terrain, p_W + step) - height_m(terrain, p_W - step)) / (2.0 * step_m);
      RC_ASSERT(std::abs(slope - gradient[axis]) < kGradient);
    }
  }));
}

TEST(Surface, SplitsCellsFromSouthEastToNorthWest) {
  // One raised corner: the surface stays level on the other side of the diagonal.
  const Heightfield terrain{2, 2, 1.0, Eigen::Vector2d::Zero(), {0.0, 0.0, 0.0, 1.0}};
  EXPECT_EQ(height_m(terrain, {0.5, 0.5}), 0.0);
  EXPECT_EQ(height_m(terrain, {0.3, 0.3}), 0.0);
  EXPECT_DOUBLE_EQ(height_m(terrain, {0.75, 0.75}), 0.5);
}

TEST(Surface, PastTheEdgeTheEdgeHolds) {
  const Heightfield terrain{2, 2, 1.0, Eigen::Vector2d::Zero(), {0.0, 2.0, 4.0, 6.0}};
  const SurfacePoint west = surface_at(terrain, -5.0, 0.5);
  EXPECT_FALSE(west.inside);
  EXPECT_DOUBLE_EQ(west.height_m, 2.0);
  const SurfacePoint corner = surface_at(terrain, 9.0, 9.0);
  EXPECT_FALSE(corner.inside);
  EXPECT_DOUBLE_EQ(corner.height_m, 6.0);
  EXPECT_TRUE(surface_at(terrain, 1.0, 1.0).inside);
}

TEST(Surface, NanIsOutsideAndStillAHeight) {
  const Heightfield terrain{2, 2, 1.0, Eigen::Vector2d::Zero(), {1.0, 2.0, 3.0, 4.0}};
  const SurfacePoint point = surface_at(terrain, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_FALSE(point.inside);
  EXPECT_TRUE(std::isfinite(point.height_m));
}

TEST(Surface, PlaneIsExactEverywhere) {
  Heightfield terrain{5, 4, 0.5, Eigen::Vector2d(-3.0, 7.0), {}};
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p_W = place(terrain, i, j);
      terrain.height_m.push_back(10.0 + 0.2 * p_W.x() - 0.1 * p_W.y());
    }
  }
  EXPECT_TRUE(rc::check([&] {
    const Eigen::Vector2d p_W =
        place(terrain, any_number(0.0, terrain.columns - 1.0), any_number(0.0, terrain.rows - 1.0));
    const SurfacePoint point = surface_at(terrain, p_W.x(), p_W.y());
    RC_ASSERT(std::abs(point.height_m - (10.0 + 0.2 * p_W.x() - 0.1 * p_W.y())) < kInterpolation_m);
    RC_ASSERT((point.gradient - Eigen::Vector2d(0.2, -0.1)).norm() < kInterpolation_m);
  }));
}

}  // namespace
}  // namespace headland
