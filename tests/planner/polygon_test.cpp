#include "planner/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "terrains/input_error.h"

namespace headland {
namespace {

// Set operations round points to 1e-6 m; the perimeters here are below 1000 m.
constexpr double kAreaTolerance_m2 = 1e-3;
// A circle drawn with 96 chords loses 1 - sin(x)/x, x = 2 pi / 96, of its area.
constexpr double kChordAreaLoss = 7.2e-4;

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

PolygonSet ground(const Ring& outer) { return {{PolygonPart{outer, {}}}}; }

Field square_with_hole() {
  Field field;
  field.boundary = rectangle(0, 0, 100, 100);
  field.holes = {{{40, 40}, {40, 60}, {60, 60}, {60, 40}}};
  return field;
}

TEST(Polygon, FieldIsBoundaryMinusHoles) {
  const PolygonSet set = from_field(square_with_hole());
  ASSERT_EQ(set.parts.size(), 1U);
  EXPECT_EQ(set.parts[0].holes.size(), 1U);
  EXPECT_NEAR(area_m2(set), 100.0 * 100.0 - 20.0 * 20.0, kAreaTolerance_m2);
}

TEST(Polygon, ObstaclesAreTakenOutNeverTooSmall) {
  Field field = square_with_hole();
  field.obstacles = {{ObstacleKind::kTree, {20, 20}, 0.5, 5.0},
                     {ObstacleKind::kRock, {80, 20}, 1.0, 1.0}};
  const double margin_m = 1.0;
  const double discs_m2 = std::numbers::pi * (1.5 * 1.5 + 2.0 * 2.0);
  const double taken_m2 = 9600.0 - area_m2(from_field(field, margin_m));
  EXPECT_GE(taken_m2, discs_m2);
  const double most_m2 = std::numbers::pi * (std::pow(1.5 + kDiscTolerance_m, 2.0) +
                                             std::pow(2.0 + kDiscTolerance_m, 2.0));
  EXPECT_LE(taken_m2, most_m2);
}

TEST(Polygon, ObstacleAcrossTheBoundaryCutsAnOpenBay) {
  Field field;
  field.boundary = rectangle(0, 0, 10, 10);
  field.obstacles = {{ObstacleKind::kTree, {0, 5}, 1.0, 5.0}};
  const PolygonSet set = from_field(field);
  ASSERT_EQ(set.parts.size(), 1U);
  EXPECT_TRUE(set.parts[0].holes.empty());
  EXPECT_NEAR(area_m2(set), 100.0 - std::numbers::pi / 2.0, kDiscTolerance_m * std::numbers::pi);
}

TEST(Polygon, MitreKeepsCornersAndRoundHasThePerimeterFormula) {
  const PolygonSet square = ground(rectangle(0, 0, 10, 10));
  EXPECT_NEAR(area_m2(buffered(square, 2.0, Join::kMitre)), 14.0 * 14.0, kAreaTolerance_m2);
  const double round_m2 = 100.0 + 40.0 * 2.0 + std::numbers::pi * 4.0;
  EXPECT_NEAR(area_m2(buffered(square, 2.0, Join::kRound)), round_m2,
              kChordAreaLoss * std::numbers::pi * 4.0 + kAreaTolerance_m2);
  EXPECT_NEAR(area_m2(buffered(square, -2.0, Join::kRound)), 36.0, kAreaTolerance_m2);
  EXPECT_TRUE(buffered(square, -5.5, Join::kRound).parts.empty());
}

TEST(Polygon, ShrinkingSplitsAtANarrowNeck) {
  const PolygonSet dumbbell = ground({{0, 0},
                                      {20, 0},
                                      {20, 9},
                                      {30, 9},
                                      {30, 0},
                                      {50, 0},
                                      {50, 20},
                                      {30, 20},
                                      {30, 11},
                                      {20, 11},
                                      {20, 20},
                                      {0, 20}});
  EXPECT_EQ(buffered(dumbbell, -1.5, Join::kMitre).parts.size(), 2U);
}

TEST(Polygon, RingsComeBackOriented) {
  const PolygonSet set = difference(ground(rectangle(0, 0, 10, 10)), ground(rectangle(4, 4, 6, 6)));
  ASSERT_EQ(set.parts.size(), 1U);
  ASSERT_EQ(set.parts[0].holes.size(), 1U);
  EXPECT_GT(signed_area_m2(set.parts[0].outer), 0.0);
  EXPECT_LT(signed_area_m2(set.parts[0].holes[0]), 0.0);
  EXPECT_EQ(set.parts[0].outer.size(), 4U);
}

TEST(Polygon, InclusionExclusionHoldsForAnyTwoRectangles) {
  rc::check("area(a or b) = area(a but not b) + area(b) = area(b but not a) + area(a)", [] {
    const auto coordinate = [] { return *rc::gen::inRange(-500, 500) / 10.0; };
    const auto any_rectangle = [&] {
      const double x = coordinate();
      const double y = coordinate();
      return ground(
          rectangle(x, y, x + 0.1 + std::abs(coordinate()), y + 0.1 + std::abs(coordinate())));
    };
    const PolygonSet a = any_rectangle();
    const PolygonSet b = any_rectangle();
    const std::vector<PolygonSet> both{a, b};
    const double united_m2 = area_m2(united(both));
    RC_ASSERT(std::abs(area_m2(difference(a, b)) + area_m2(b) - united_m2) < kAreaTolerance_m2);
    RC_ASSERT(std::abs(area_m2(difference(b, a)) + area_m2(a) - united_m2) < kAreaTolerance_m2);
  });
}

TEST(Polygon, CoversWhatLiesInsideAndNothingElse) {
  const PolygonSet holed = from_field(square_with_hole());
  EXPECT_TRUE(covers(holed, ground(rectangle(0, 0, 40, 100))));
  EXPECT_FALSE(covers(holed, ground(rectangle(0, 0, 41, 100))));
  EXPECT_FALSE(covers(holed, ground(rectangle(45, 45, 55, 55))));
  EXPECT_TRUE(covers(holed, PolygonSet{}));
}

TEST(Polygon, StripOfAStraightLineIsARectangle) {
  const Polyline line{{0, 0}, {30, 40}};
  EXPECT_NEAR(area_m2(strip(line, 3.0)), 150.0, kAreaTolerance_m2);
  EXPECT_TRUE(strip({{1, 1}, {1, 1}}, 3.0).parts.empty());
}

// Neighbouring strips share edges up to rounding; GEOS' union on plain doubles loses some of them.
TEST(Polygon, UnionOfManyTouchingStripsKeepsAllOfThem) {
  const double width_m = 2.0;
  const double length = 208.0;
  const Eigen::Vector2d along(std::cos(0.5), std::sin(0.5));
  const Eigen::Vector2d across(-along.y(), along.x());
  std::vector<PolygonSet> strips;
  for (int i = 0; i < 39; ++i) {
    const Eigen::Vector2d begin =
        Eigen::Vector2d(40.0, -25.0) + 6.0 * along + (7.0 + width_m * i) * across;
    strips.push_back(strip({begin, begin + length * along}, width_m));
  }
  // The grid moves corners by up to a micrometre.
  EXPECT_NEAR(area_m2(united(strips)), 39.0 * width_m * length, 39.0 * length * 2e-6);
}

TEST(Polygon, StripOfAClosedLineHasNoGapAtItsSeam) {
  const Polyline loop{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
  const double width_m = 2.0;
  const double corners_m2 = 4.0 * std::numbers::pi / 4.0;
  EXPECT_NEAR(area_m2(strip(loop, width_m)), 40.0 + 40.0 - 4.0 + corners_m2,
              kChordAreaLoss * std::numbers::pi + kAreaTolerance_m2);
}

TEST(Polygon, LineIsClippedIntoPiecesInItsOwnDirection) {
  const PolygonSet set = from_field(square_with_hole());
  const std::vector<Polyline> pieces = clip_line({{110, 50}, {-10, 50}}, set);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].front(), Eigen::Vector2d(100, 50));
  EXPECT_EQ(pieces[0].back(), Eigen::Vector2d(60, 50));
  EXPECT_EQ(pieces[1].back(), Eigen::Vector2d(0, 50));
  EXPECT_TRUE(clip_line({{45, 50}, {55, 50}}, set).empty());
}

TEST(Polygon, TheWidestDiscTouchesWhatIsNearest) {
  const Disc square = widest_disc(ground(rectangle(10, 20, 40, 50)));
  EXPECT_NEAR(square.radius_m, 15.0, kDiscTolerance_m);
  EXPECT_NEAR((square.centre_W - Eigen::Vector2d(25, 35)).norm(), 0.0, 2.0 * kDiscTolerance_m);
  EXPECT_EQ(widest_disc({}).radius_m, 0.0);
}

TEST(Polygon, SimplifyingKeepsCornersAndDropsWhatLiesOnEdges) {
  Ring ring;
  for (int i = 0; i < 400; ++i) ring.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.004);
  ring.insert(ring.end(), {{40.0, 0.0}, {40.0, 30.0}, {0.0, 30.0}});
  const PolygonSet simple = simplified(ground(ring), 0.01);
  ASSERT_EQ(simple.parts.size(), 1U);
  EXPECT_EQ(simple.parts[0].outer.size(), 4U);
  EXPECT_NEAR(area_m2(simple), 1200.0, 0.004 * 40.0);
}

TEST(Polygon, CrossingRingsAreRefused) {
  const PolygonSet bow_tie = ground({{0, 0}, {10, 10}, {10, 0}, {0, 11}});
  EXPECT_THROW(difference(bow_tie, ground(rectangle(2, 0, 8, 9))), InputError);
}

}  // namespace
}  // namespace headland
