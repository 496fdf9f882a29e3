#include "terrains/field_source.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "random_ring.h"
#include "terrains/field_outline.h"
#include "utm_square.h"

namespace headland {
namespace {

using test::expect_the_square;
using test::kDegreeDigits_m;
using test::kUtmRings;
using test::kUtmScale;
using test::line_of;
using test::rings_in_degrees;
using test::square;
using testing::HasSubstr;

FieldSource inline_field(const Ring& boundary, std::vector<Ring> holes = {}) {
  FieldSource source;
  source.boundary = boundary;
  source.holes = std::move(holes);
  return source;
}

TEST(InlineField, PlainMetresStayAsTheyAre) {
  const Field field =
      read_field(inline_field(square(10.0, 20.0, 50.0), {square(30.0, 40.0, 5.0)}), "demo.yaml");
  EXPECT_FALSE(field.frame.georeferenced);
  EXPECT_EQ(field.boundary, square(10.0, 20.0, 50.0));
  EXPECT_EQ(field.name, "demo");
  EXPECT_DOUBLE_EQ(field_area_m2(field), 2500.0 - 25.0);
}

TEST(InlineField, WithACrsComesToTheLocalFrame) {
  FieldSource source = inline_field(kUtmRings[0], {kUtmRings[1]});
  source.crs = "EPSG:32615";
  source.entry = Eigen::Vector2d(500000.0, 4860000.0);
  source.obstacles = {{.line = {{500150.0, 4860150.0}}}};
  const Field field = read_field(source, "demo.yaml");
  expect_the_square(field);
  EXPECT_LT(std::abs(field_clearance_m(field, *field.entry_W)), kDegreeDigits_m);
  EXPECT_NEAR(field_clearance_m(field, field.obstacles[0].p_W), 50.0 / kUtmScale, kDegreeDigits_m);
}

TEST(InlineField, RingsAreCleanedAndOriented) {
  Ring ring = square(0.0, 0.0, 50.0);
  std::ranges::reverse(ring);
  ring.insert(ring.begin() + 2, ring[2]);
  ring.push_back(ring.front());
  const Field field = read_field(inline_field(ring, {square(10.0, 10.0, 5.0)}), "demo.yaml");
  EXPECT_EQ(field.boundary.size(), 4U);
  EXPECT_GT(signed_area_m2(field.boundary), 0.0);
  EXPECT_LT(signed_area_m2(field.holes[0]), 0.0);
}

TEST(InlineField, AnySimpleRingIsTakenWhicheverWayItRuns) {
  EXPECT_TRUE(rc::check([] {
    Ring ring = any_ring();
    const double area_m2 = signed_area_m2(ring);
    if (*rc::gen::arbitrary<bool>()) std::ranges::reverse(ring);
    const Field field = read_field(inline_field(ring), "demo.yaml");
    RC_ASSERT(std::abs(signed_area_m2(field.boundary) - area_m2) < 1e-6);
  }));
}

// A boundary as a receiver logs it: 0.1 m and less from point to point.
TEST(InlineField, ManyPointsAreSimplifiedWithinTheStatedTolerance) {
  constexpr int kPoints = 100000;
  const auto wavy = [](int points) {
    Ring ring;
    for (int i = 0; i < points; ++i) {
      const double angle_rad = 2.0 * std::numbers::pi * i / points;
      const double radius_m = 300.0 + 5.0 * std::sin(30.0 * angle_rad);
      ring.emplace_back(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
    }
    return ring;
  };
  const Ring ring = wavy(kPoints);
  std::vector<std::string> notes;
  const Ring hole = square(10.0, 10.0, 5.0);
  const Field field = read_field(inline_field(ring, {hole}), "demo.yaml", &notes);
  EXPECT_LT(field.boundary.size(), 4000U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0],
            fmt::format("field: 100004 points of its outlines simplified to {} within 5 mm",
                        field.boundary.size() + 4));
  double worst_m = 0.0;
  for (std::size_t i = 0; i < ring.size(); i += 97) {
    worst_m = std::max(worst_m, std::abs(field_clearance_m(field, ring[i])));
  }
  EXPECT_LE(worst_m, kOutlineRounding_m);
  EXPECT_GT(worst_m, 0.1 * kOutlineRounding_m);
  EXPECT_NEAR(signed_area_m2(field.holes[0]), -25.0, 1e-9);
  // Few points stay as they are, and nothing is said.
  const Ring few = wavy(static_cast<int>(kManyPoints));
  notes.clear();
  EXPECT_EQ(read_field(inline_field(few), "demo.yaml", &notes).boundary, few);
  EXPECT_TRUE(notes.empty());
}

// Noise of a receiver is more than rounding: all of it would be planned by.
TEST(InlineField, RoughOutlinesAreSimplifiedInsideTheField) {
  constexpr int kPoints = 12000;
  Ring ring;
  for (int i = 0; i < kPoints; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kPoints;
    const double radius_m = 100.0 + 5.0 * std::sin(3.0 * angle_rad) + 0.01 * (i % 3);
    ring.emplace_back(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
  }
  std::vector<std::string> notes;
  Field given;
  given.boundary = ring;
  const Field field = read_field(inline_field(ring), "demo.yaml", &notes);
  EXPECT_LT(field.boundary.size(), kManyPoints);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0],
            fmt::format("field: {} points of its outlines simplified to {} within 40 mm, inside it",
                        kPoints, field.boundary.size()));
  for (std::size_t i = 0; i < field.boundary.size(); ++i) {
    const Eigen::Vector2d& a = field.boundary[i];
    const Eigen::Vector2d& b = field.boundary[(i + 1) % field.boundary.size()];
    for (const Eigen::Vector2d& p : {a, Eigen::Vector2d(0.5 * (a + b))}) {
      EXPECT_GE(field_clearance_m(given, p), 0.0);
    }
  }
  for (std::size_t i = 0; i < ring.size(); i += 31) {
    EXPECT_NEAR(field_clearance_m(field, ring[i]), 0.0, 0.04);
  }
}

TEST(FieldOutline, IsNotSimplifiedInsideWhereThatCutsItApart) {
  Field field;  // two squares and a neck of 4 cm between them
  field.boundary = {{0.0, 0.0},    {20.0, 0.0},   {20.0, 9.98}, {30.0, 9.98},
                    {30.0, 0.0},   {50.0, 0.0},   {50.0, 20.0}, {30.0, 20.0},
                    {30.0, 10.02}, {20.0, 10.02}, {20.0, 20.0}, {0.0, 20.0}};
  const Ring before = field.boundary;
  EXPECT_FALSE(simplify_outline_inside(field, 0.05));
  EXPECT_EQ(field.boundary, before);
  EXPECT_TRUE(simplify_outline_inside(field, 0.01));
  EXPECT_LT(signed_area_m2(field.boundary), signed_area_m2(before));
}

TEST(InlineField, EmptyBoundaryIsRefused) {
  EXPECT_THAT(line_of(inline_field({})), HasSubstr("demo.yaml: boundary: is empty"));
}

TEST(InlineField, BoundaryOfTwoPlacesIsRefused) {
  EXPECT_THAT(line_of(inline_field({{0.0, 0.0}, {50.0, 0.0}, {50.0, 0.0}})),
              HasSubstr("demo.yaml: boundary: '2 points': bounds no area"));
}

TEST(InlineField, FlatBoundaryIsRefused) {
  EXPECT_THAT(line_of(inline_field({{0.0, 0.0}, {50.0, 0.0}, {100.0, 0.0}})),
              HasSubstr("demo.yaml: boundary: "));
}

TEST(InlineField, SelfIntersectionIsRefusedWithItsPlace) {
  EXPECT_EQ(line_of(inline_field({{0.0, 0.0}, {50.0, 50.0}, {50.0, 0.0}, {0.0, 50.0}})),
            "demo.yaml: boundary: Self-intersection at x 25.000 m, y 25.000 m");
}

TEST(InlineField, SelfIntersectionOnTheEarthIsPlacedInDegrees) {
  FieldSource source = inline_field(
      {{500000.0, 4860000.0}, {500100.0, 4860100.0}, {500100.0, 4860000.0}, {500000.0, 4860100.0}});
  source.crs = "EPSG:32615";
  const auto place_deg = wgs84_from_crs("EPSG:32615", {{500050.0, 4860050.0}}, "test")[0];
  EXPECT_THAT(line_of(source),
              HasSubstr(fmt::format("Self-intersection at lon {:.6f}", place_deg.x())));
}

TEST(InlineField, BoundaryThatTouchesItselfIsRefused) {
  EXPECT_THAT(
      line_of(inline_field(
          {{0.0, 0.0}, {50.0, 0.0}, {25.0, 25.0}, {50.0, 50.0}, {0.0, 50.0}, {25.0, 25.0}})),
      HasSubstr("Self-intersection at x 25.000 m, y 25.000 m"));
}

TEST(InlineField, NanIsRefused) {
  EXPECT_EQ(line_of(inline_field(
                {{0.0, 0.0}, {50.0, std::numeric_limits<double>::quiet_NaN()}, {50.0, 50.0}})),
            "demo.yaml: boundary point 2: '50, nan': not a finite coordinate");
}

TEST(InlineField, NanInAHoleIsRefused) {
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 50.0),
                                   {{{10.0, std::numeric_limits<double>::infinity()}}})),
              HasSubstr("hole 1 point 1"));
}

TEST(InlineField, DegreesTakenForMetresAreRefused) {
  EXPECT_EQ(line_of(inline_field(rings_in_degrees()[0])),
            "demo.yaml: boundary: '0.00249 m across': too small for a field (at least 5 m); "
            "coordinates in degrees need crs: EPSG:4326");
}

TEST(InlineField, DegreesOfAWholeCountryAreRefusedWithoutACrs) {
  EXPECT_THAT(line_of(inline_field({{9.5, 47.0}, {10.7, 47.0}, {10.7, 47.9}, {9.5, 47.9}})),
              AllOf(HasSubstr("too small for a field"), HasSubstr("EPSG:4326")));
  EXPECT_EQ(line_of(inline_field({{0, 0}, {5, 0}, {5, 5}, {0, 5}})), "accepted");
}

TEST(InlineField, MetresTakenForDegreesAreRefused) {
  FieldSource source = inline_field(square(0.0, 0.0, 500.0));
  source.crs = "EPSG:4326";
  EXPECT_THAT(line_of(source), HasSubstr("'500, 0': not degrees"));
}

TEST(InlineField, FieldOfHundredsOfKilometresIsRefused) {
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 3e5))),
              HasSubstr("'3e+05 m across': too large for one field"));
}

TEST(InlineField, HoleOutsideIsRefused) {
  EXPECT_EQ(line_of(inline_field(square(0.0, 0.0, 50.0), {square(60.0, 0.0, 5.0)})),
            "demo.yaml: hole 1: lies outside the boundary at x 60.000 m, y 5.000 m");
}

TEST(InlineField, HoleAcrossTheBoundaryIsRefused) {
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 50.0),
                                   {square(10.0, 10.0, 5.0), square(45.0, 10.0, 10.0)})),
              HasSubstr("hole 2: crosses or touches the boundary at x 50.000 m"));
}

TEST(InlineField, HolesInOrAcrossEachOtherAreRefused) {
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 50.0),
                                   {square(10.0, 10.0, 20.0), square(15.0, 15.0, 5.0)})),
              HasSubstr("hole 2: lies inside hole 1"));
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 50.0),
                                   {square(15.0, 15.0, 5.0), square(10.0, 10.0, 20.0)})),
              HasSubstr("hole 1: lies inside hole 2"));
  EXPECT_THAT(line_of(inline_field(square(0.0, 0.0, 50.0),
                                   {square(10.0, 10.0, 20.0), square(20.0, 20.0, 20.0)})),
              HasSubstr("hole 2: crosses or touches hole 1"));
}

TEST(InlineField, ObstaclesOutsideOrAbsurdAreRefused) {
  FieldSource source = inline_field(square(0.0, 0.0, 50.0));
  source.obstacles = {{.line = {{70.0, 5.0}}}};
  EXPECT_EQ(line_of(source),
            "demo.yaml: field.obstacles[0]: lies outside the boundary at x 70.000 m, y 5.000 m");
  source.obstacles = {{.line = {{7.0, 5.0}}, .radius_m = -1.0}};
  EXPECT_EQ(line_of(source), "demo.yaml: field.obstacles[0].radius_m: '-1': from 0.01 to 50 m");
  source.obstacles = {{.line = {{7.0, 5.0}}, .height_m = 0.0}};
  EXPECT_EQ(line_of(source), "demo.yaml: field.obstacles[0].height_m: '0': from 0.01 to 100 m");
}

TEST(InlineField, EntryMayBeAtTheGateButNotDownTheRoad) {
  FieldSource source = inline_field(square(0.0, 0.0, 50.0));
  source.entry = Eigen::Vector2d(25.0, -0.5);
  EXPECT_EQ(line_of(source), "accepted");
  source.entry = Eigen::Vector2d(25.0, -30.0);
  EXPECT_EQ(line_of(source),
            "demo.yaml: field.entry: lies 30.0 m outside the field (at most 1 m) at x 25.000 m, y "
            "-30.000 m");
}

}  // namespace
}  // namespace headland
