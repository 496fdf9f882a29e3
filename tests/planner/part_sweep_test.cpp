// Parts worked up and down: lines, the four ways, what is swept whole.
#include "planner/part_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "planner/decomposition.h"
#include "planner/worked_parts.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/random_ground.h"

namespace headland {
namespace {

constexpr double kPoint_m = 1e-9;  // rounding of a few products

TEST(PartSweep, OfARectangleRunsAlongItsLongSide) {
  const Ring ring = rectangle_ring(0, 0, 100, 40);
  ASSERT_NEAR(longest_edge_rad(ring), 0.0, kPoint_m);
  const PartSweep sweep = sweep_of(ring, 0.0, 10.0);
  ASSERT_EQ(sweep.lines.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double level_m = 5.0 + 10.0 * static_cast<double>(i);
    EXPECT_TRUE(sweep.lines[i].from_W.isApprox(Eigen::Vector2d(0.0, level_m)));
    EXPECT_TRUE(sweep.lines[i].to_W.isApprox(Eigen::Vector2d(100.0, level_m)));
  }
}

TEST(PartSweep, LinesAreSpreadEvenlyAndNeverFartherApartThanTheWidth) {
  EXPECT_EQ(sweep_line_count(rectangle_ring(0, 0, 100, 41), 0.0, 10.0), 5);
  EXPECT_EQ(sweep_line_count(rectangle_ring(0, 0, 100, 0.5), 0.0, 10.0), 1);
  const PartSweep sweep = sweep_of(rectangle_ring(0, 0, 100, 41), 0.0, 10.0);
  EXPECT_NEAR(sweep.lines[0].from_W.y(), 4.1, kPoint_m);
  EXPECT_NEAR(sweep.lines[4].from_W.y(), 36.9, kPoint_m);
}

TEST(PartSweep, BeginsAtItsBaselineOnWhicheverSideThatLies) {
  // The longest edge is the upper one.
  const Ring ring = {{20, 0}, {80, 0}, {100, 30}, {0, 30}};
  const PartSweep sweep = sweep_of(ring, longest_edge_rad(ring), 10.0);
  ASSERT_EQ(sweep.lines.size(), 3U);
  EXPECT_NEAR(sweep.lines[0].from_W.y(), 25.0, kPoint_m);
}

TEST(Sweep, HasFourWaysOfWhichEachBeginsAtAnotherCorner) {
  const PartSweep sweep = sweep_of(rectangle_ring(0, 0, 100, 40), 0.0, 10.0);
  const double length = 4.0 * 100.0 + 3.0 * 10.0;
  const std::vector<Eigen::Vector2d> entries = {{0, 5}, {100, 5}, {0, 35}, {100, 35}};
  // Four lines: it ends on the side where it began.
  const std::vector<Eigen::Vector2d> exits = {{0, 35}, {100, 35}, {0, 5}, {100, 5}};
  for (std::size_t i = 0; i < kSweepWays.size(); ++i) {
    const Polyline line = points_of(sweep, kSweepWays[i]);
    EXPECT_EQ(line.size(), 8U);
    EXPECT_TRUE(line.front().isApprox(entries[i]));
    EXPECT_TRUE(line.back().isApprox(exits[i]));
    EXPECT_NEAR(length_m(line), length, kPoint_m);
  }
}

TEST(PartSweep, EntersTheNextLineAtItsNearerEnd) {
  // Leaning so much that the nearer end of the next line is on the other side: lines at 2.5 and
  // 7.5 run from 25 to 35 and from 75 to 85.
  const Ring ring = {{0, 0}, {10, 0}, {110, 10}, {100, 10}};
  PartSweep sweep;
  sweep.lines = {{{25, 2.5}, {35, 2.5}}, {{75, 7.5}, {85, 7.5}}};
  const PartSweep laid = sweep_of(ring, 0.0, 5.0);
  ASSERT_EQ(laid.lines.size(), 2U);
  const Polyline line = points_of(laid, {false, false});
  EXPECT_TRUE(line[0].isApprox(sweep.lines[0].from_W));
  EXPECT_TRUE(line[1].isApprox(sweep.lines[0].to_W));
  EXPECT_TRUE(line[2].isApprox(sweep.lines[1].from_W));
}

TEST(PartSweep, LongestEdgeGoesThroughPointsThatLieStraight) {
  // 60 m in two pieces are longer than 50 m in one.
  const Ring ring = {{0, 0}, {30, 0}, {60, 0}, {60, 50}, {0, 50}};
  EXPECT_EQ(corners_of(ring).size(), 4U);
  EXPECT_NEAR(longest_edge_rad(ring), 0.0, kPoint_m);
  EXPECT_NEAR(longest_edge_rad({{0, 0}, {30, 0}, {30, 50}, {0, 50}}), kPi / 2.0, kPoint_m);
}

TEST(IsSweptWhole, WhereEveryLineMeetsTheOutlineInOnePiece) {
  const Ring u = {{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
  EXPECT_FALSE(is_swept_whole(u, 0.0));
  EXPECT_TRUE(is_swept_whole(u, kPi / 2.0));
  const Ring l = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
  EXPECT_TRUE(is_swept_whole(l, 0.0));
  EXPECT_FALSE(is_swept_whole(l, 3.0 * kPi / 4.0));
}

TEST(PartSweep, OfAnyConvexPieceStaysInsideAndIsSweptWholeInAnyDirection) {
  EXPECT_TRUE(rc::check([] {
    const double width_m = any_number(3.0, 15.0);
    const double direction_rad = any_number(0.0, 3.0);
    for (const Ring& piece : convex_pieces(any_ground(2))) {
      RC_ASSERT(is_swept_whole(piece, direction_rad));
      const PolygonSet room = buffered({{PolygonPart{piece, {}}}}, kConvex_m, Join::kMitre);
      const Polyline line = points_of(sweep_of(piece, direction_rad, width_m), kSweepWays[1]);
      const std::vector<Polyline> inside = clip_line(line, room);
      RC_ASSERT(inside.size() == 1U);
      RC_ASSERT(std::abs(length_m(inside.front()) - length_m(line)) < 1e-3);
    }
  }));
}

TEST(WorkedParts, HaveTheirOwnSweepFirstAndOthersOnlyWhenAsked) {
  RegionParts parts;
  parts.parts = {{{{20, 0}, {80, 0}, {100, 30}, {0, 30}}, 0.0}};
  const std::vector<WorkedPart> own = worked_parts(parts, 10.0, PartSweeps::kOwn);
  ASSERT_EQ(own[0].sweeps.size(), 1U);
  const std::vector<WorkedPart> any = worked_parts(parts, 10.0, PartSweeps::kAny);
  ASSERT_EQ(any[0].sweeps.size(), 3U);  // two of the four edges are parallel
  EXPECT_EQ(any[0].sweeps[0].direction_rad, own[0].sweeps[0].direction_rad);
  const RegionProblem problem = region_problem(any, std::nullopt, Eigen::Vector2d(1, 2));
  ASSERT_EQ(problem.parts[0].size(), 12U);
  for (int variant = 0; variant < 12; ++variant) {
    const Polyline line = way_of(any, {0, variant});
    EXPECT_EQ(variant_of(problem, {0, variant}).entry_W, line.front());
    EXPECT_EQ(variant_of(problem, {0, variant}).exit_W, line.back());
    EXPECT_EQ(variant_of(problem, {0, variant}).cost, length_m(line));
  }
}

}  // namespace
}  // namespace headland
