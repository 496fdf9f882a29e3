// Ground cut into pieces: they add up, do not overlap, and have the shape their method promises.
#include "planner/decomposition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/part_sweep.h"
#include "planner/segment.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/random_ground.h"

namespace headland {
namespace {

// GEOS rounds points to 1e-6 m; edges of ground and cuts are some 1000 m long in all.
constexpr double kCutTolerance_m2 = 5e-3;

PolygonPart cross_ground() {
  return {{{10, 0},
           {20, 0},
           {20, 10},
           {30, 10},
           {30, 20},
           {20, 20},
           {20, 30},
           {10, 30},
           {10, 20},
           {0, 20},
           {0, 10},
           {10, 10}},
          {}};
}

PolygonPart square_around_square() {
  return {rectangle_ring(0, 0, 100, 100), {reversed(rectangle_ring(40, 40, 60, 60))}};
}

double sum_m2(const std::vector<Ring>& pieces) {
  double sum = 0.0;
  for (const Ring& piece : pieces) sum += signed_area_m2(piece);
  return sum;
}

// How far a corner lies inside the hull of the piece.
double dent_m(const Ring& piece) {
  const Ring corners = corners_of(piece);
  double deepest_m = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& before = corners[(i + corners.size() - 1) % corners.size()];
    const Eigen::Vector2d& after = corners[(i + 1) % corners.size()];
    if (cross(corners[i] - before, after - corners[i]) >= 0.0) continue;
    deepest_m = std::max(deepest_m, distance_to_segment(corners[i], before, after));
  }
  return deepest_m;
}

int concave_corner_count(const PolygonPart& ground) {
  int concave = 0;
  const auto count = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d& p_W = ring[i];
      const Eigen::Vector2d in = p_W - ring[(i + ring.size() - 1) % ring.size()];
      concave += cross(in, ring[(i + 1) % ring.size()] - p_W) < 0.0 ? 1 : 0;
    }
  };
  count(ground.outer);
  for (const Ring& hole : ground.holes) count(hole);
  return concave;
}

// Neither gaps nor overlaps: the pieces together are the ground, and so is their sum.
bool fill(const std::vector<Ring>& pieces, const PolygonPart& ground) {
  std::vector<PolygonSet> sets;
  for (const Ring& piece : pieces) sets.push_back({{PolygonPart{piece, {}}}});
  const double ground_m2 = area_m2(PolygonSet{{ground}});
  const PolygonSet whole = united(sets);
  return std::abs(sum_m2(pieces) - ground_m2) < kCutTolerance_m2 &&
         std::abs(area_m2(whole) - ground_m2) < kCutTolerance_m2 &&
         area_m2(difference(whole, {{ground}})) < kCutTolerance_m2;
}

TEST(ConvexPieces, ConvexGroundStaysWhole) {
  const std::vector<Ring> pieces = convex_pieces({regular_ring({5, 5}, 30.0, 7), {}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 7U);
}

TEST(ConvexPieces, TheEdgeLeadingToAConcaveCornerIsExtended) {
  // Of an L, counter-clockwise, (20, 10) -> (10, 10) leads to the concave corner and on to x = 0.
  const Ring l = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
  std::vector<Ring> pieces = convex_pieces({l, {}});
  ASSERT_EQ(pieces.size(), 2U);
  std::ranges::sort(pieces, {}, [](const Ring& piece) { return signed_area_m2(piece); });
  EXPECT_NEAR(signed_area_m2(pieces[0]), 200.0, kCutTolerance_m2);
  EXPECT_NEAR(signed_area_m2(pieces[1]), 200.0, kCutTolerance_m2);
  const bool cut_at_10 = std::ranges::any_of(
      pieces[0], [](const Eigen::Vector2d& p_W) { return p_W.isApprox(Eigen::Vector2d(0, 10)); });
  EXPECT_TRUE(cut_at_10);
}

TEST(ConvexPieces, ACutThatEndsInAConcaveCornerServesBoth) {
  // The four corners of a cross see each other along its edges: two cuts, three rectangles.
  const std::vector<Ring> pieces = convex_pieces(cross_ground());
  EXPECT_EQ(pieces.size(), 3U);
  EXPECT_TRUE(fill(pieces, cross_ground()));
}

TEST(ConvexPieces, AHoleIsCutFreeLikeAPinwheel) {
  const std::vector<Ring> pieces = convex_pieces(square_around_square());
  ASSERT_EQ(pieces.size(), 4U);
  for (const Ring& piece : pieces) EXPECT_NEAR(signed_area_m2(piece), 2400.0, kCutTolerance_m2);
}

TEST(ConvexPieces, OfAnyGroundAreConvexFillItAndAreAsManyAsConcaveCornersSay) {
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(3);
    const std::vector<Ring> pieces = convex_pieces(ground);
    for (const Ring& piece : pieces) RC_ASSERT(dent_m(piece) < kConvex_m);
    RC_ASSERT(fill(pieces, ground));
    const int holes = static_cast<int>(ground.holes.size());
    RC_ASSERT(static_cast<int>(pieces.size()) <= 1 + concave_corner_count(ground) - holes);
  }));
}

TEST(ConvexPieces, AreTheSameWhereverTheGroundLies) {
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(2);
    PolygonPart moved = ground;
    const double angle_rad = any_number(0.0, 6.0);
    const Eigen::Rotation2Dd turn(angle_rad);
    const auto move = [&](Ring& ring) {
      for (Eigen::Vector2d& p_W : ring) p_W = turn * p_W + Eigen::Vector2d(2000.0, -500.0);
    };
    move(moved.outer);
    for (Ring& hole : moved.holes) move(hole);
    const auto areas_m2 = [](const PolygonPart& part) {
      std::vector<double> areas;
      for (const Ring& piece : convex_pieces(part)) areas.push_back(signed_area_m2(piece));
      std::ranges::sort(areas);
      return areas;
    };
    const std::vector<double> here = areas_m2(ground);
    const std::vector<double> there = areas_m2(moved);
    RC_PRE(here.size() == there.size());  // cuts that graze a corner may fall on either side
    for (std::size_t i = 0; i < here.size(); ++i) {
      RC_ASSERT(std::abs(here[i] - there[i]) < kCutTolerance_m2);
    }
  }));
}

TEST(Trapezoids, SliceThroughEveryCorner) {
  // The six corners of a tilted hexagon lie on six levels, with five slabs between them.
  const std::vector<Ring> pieces = trapezoids({regular_ring({0, 0}, 10.0, 6), {}}, 0.3);
  EXPECT_EQ(pieces.size(), 5U);
  // Around a square hole: left, right, below and above.
  EXPECT_EQ(trapezoids(square_around_square(), 0.0).size(), 4U);
}

TEST(Trapezoids, OfAnyGroundAreConvexWithAtMostFourCornersAndFillIt) {
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(3);
    const std::vector<Ring> pieces = trapezoids(ground, any_number(0.0, 3.0));
    for (const Ring& piece : pieces) {
      RC_ASSERT(dent_m(piece) < kConvex_m);
      RC_ASSERT(corners_of(piece).size() <= 4U);
    }
    RC_ASSERT(fill(pieces, ground));
  }));
}

TEST(BoustrophedonCells, EndWhereSlicesSplitOrJoin) {
  // Below, above, and on both sides of the hole; an L is one cell either way.
  EXPECT_EQ(boustrophedon_cells(square_around_square(), 0.0).size(), 4U);
  EXPECT_EQ(boustrophedon_cells(square_around_square(), 0.4).size(), 4U);
  const PolygonPart l{{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 30}, {0, 30}}, {}};
  EXPECT_EQ(boustrophedon_cells(l, 0.0).size(), 1U);
  EXPECT_EQ(boustrophedon_cells(l, kPi / 2.0).size(), 1U);
  // A U has two arms where slices run across them, and none along them.
  const PolygonPart u{{{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}},
                      {}};
  EXPECT_EQ(boustrophedon_cells(u, 0.0).size(), 3U);
  EXPECT_EQ(boustrophedon_cells(u, kPi / 2.0).size(), 1U);
}

TEST(BoustrophedonCells, OfAnyGroundAreSweptWholeAndFillIt) {
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(3);
    const double slice_rad = any_number(0.0, 3.0);
    const std::vector<Ring> cells = boustrophedon_cells(ground, slice_rad);
    for (const Ring& cell : cells) RC_ASSERT(is_swept_whole(cell, slice_rad));
    RC_ASSERT(fill(cells, ground));
    RC_ASSERT(cells.size() <= trapezoids(ground, slice_rad).size());
  }));
}

TEST(LeastWidthDirection, IsTheOneThatCrossesLeastGround) {
  // A long strip is worked along itself.
  const PolygonPart strip{rectangle_ring(0, 0, 100, 20), {}};
  EXPECT_NEAR(least_width_direction_rad(strip), 0.0, 1e-12);
  // No direction on a fine grid makes a smaller sum of widths.
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(2);
    const auto sum_of_widths_m = [&](double direction_rad) {
      double sum_m = 0.0;
      const Eigen::Vector2d across(-std::sin(direction_rad), std::cos(direction_rad));
      const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          sum_m += std::abs(across.dot(ring[(i + 1) % ring.size()] - ring[i])) / 2.0;
        }
      };
      add(ground.outer);
      for (const Ring& hole : ground.holes) add(hole);
      return sum_m;
    };
    const double best_m = sum_of_widths_m(least_width_direction_rad(ground));
    for (int step = 0; step < 180; ++step) {
      RC_ASSERT(sum_of_widths_m(step * kPi / 180.0) > best_m - 1e-9);
    }
  }));
}

}  // namespace
}  // namespace headland
