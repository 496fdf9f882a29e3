#include "terrains/field_source.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "random_ring.h"
#include "refusal.h"
#include "scratch_folder.h"
#include "terrains/field_outline.h"
#include "vector_writer.h"

namespace headland {
namespace {

using testing::HasSubstr;

// Coordinates in degrees are written with 7 digits by some drivers: 1e-7 deg is 11 mm, and each
// side of the field has two ends.
constexpr double kDegreeDigits_m = 0.02;

Ring square(double left, double bottom, double side) {
  return {
      {left, bottom}, {left + side, bottom}, {left + side, bottom + side}, {left, bottom + side}};
}

FieldSource inline_field(const Ring& boundary, std::vector<Ring> holes = {}) {
  FieldSource source;
  source.boundary = boundary;
  source.holes = std::move(holes);
  return source;
}

FieldSource from_file(const std::filesystem::path& file) {
  FieldSource source;
  source.file = file;
  return source;
}

std::string line_of(const FieldSource& source) {
  return refusal([&] { read_field(source, "demo.yaml"); });
}

// The same 200 m square with a 50 m hole on zone 15's central meridian, in UTM and in degrees.
const std::vector<Ring> kUtmRings = {square(500000.0, 4860000.0, 200.0),
                                     square(500050.0, 4860050.0, 50.0)};

std::vector<Ring> rings_in_degrees() {
  std::vector<Ring> rings;
  for (const Ring& ring : kUtmRings) rings.push_back(wgs84_from_crs("EPSG:32615", ring, "test"));
  return rings;
}

// UTM's scale is 0.9996 on its central meridian.
constexpr double kUtmScale = 0.9996;
constexpr double kTrueSide_m = 200.0 / kUtmScale;
constexpr double kTrueHole_m = 50.0 / kUtmScale;

void expect_the_square(const Field& field) {
  ASSERT_TRUE(field.frame.georeferenced);
  ASSERT_EQ(field.boundary.size(), 4U);
  ASSERT_EQ(field.holes.size(), 1U);
  EXPECT_NEAR(signed_area_m2(field.boundary), kTrueSide_m * kTrueSide_m,
              4.0 * kTrueSide_m * kDegreeDigits_m);
  EXPECT_NEAR(signed_area_m2(field.holes[0]), -kTrueHole_m * kTrueHole_m,
              4.0 * kTrueHole_m * kDegreeDigits_m);
  // The origin is the middle, rounded to 1e-4 deg: at most 8 m away.
  Eigen::Vector2d mean_W = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p_W : field.boundary) mean_W += 0.25 * p_W;
  EXPECT_LT(mean_W.norm(), 8.0);
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

class FieldFile : public ScratchFolder {};

TEST_F(FieldFile, EveryFormatOfGdalReadsBackTheSame) {
  const OGRPolygon in_utm = polygon_of(kUtmRings);
  const OGRPolygon in_degrees = polygon_of(rings_in_degrees());
  struct Format {
    std::string driver, name, crs;
    const OGRPolygon* polygon;
  };
  for (const Format& format : {Format{"GeoJSON", "a.geojson", "EPSG:4326", &in_degrees},
                               Format{"GPKG", "a.gpkg", "EPSG:32615", &in_utm},
                               Format{"GPKG", "b.gpkg", "EPSG:4326", &in_degrees},
                               Format{"ESRI Shapefile", "a.shp", "EPSG:32615", &in_utm},
                               Format{"ESRI Shapefile", "b.shp", "EPSG:4326", &in_degrees},
                               Format{"KML", "a.kml", "EPSG:4326", &in_degrees},
                               Format{"GML", "a.gml", "EPSG:32615", &in_utm},
                               Format{"GML", "b.gml", "EPSG:4326", &in_degrees}}) {
    SCOPED_TRACE(format.name);
    write_features(path(format.name), format.driver, format.crs, {format.polygon});
    const Field field = read_field(from_file(path(format.name)), "demo.yaml");
    expect_the_square(field);
    EXPECT_EQ(field.name, "field 1");
  }
}

TEST_F(FieldFile, MultiPolygonOfOnePartIsAPolygon) {
  OGRMultiPolygon parts;
  const OGRPolygon part = polygon_of(rings_in_degrees());
  parts.addGeometry(&part);
  write_features(path("a.geojson"), "GeoJSON", "EPSG:4326", {&parts});
  expect_the_square(read_field(from_file(path("a.geojson")), "demo.yaml"));
}

TEST_F(FieldFile, ObstaclesAndEntryAreInDegrees) {
  const OGRPolygon polygon = polygon_of(kUtmRings);
  write_features(path("a.gpkg"), "GPKG", "EPSG:32615", {&polygon});
  FieldSource source = from_file(path("a.gpkg"));
  source.entry = rings_in_degrees()[0][0];
  const Field field = read_field(source, "demo.yaml");
  EXPECT_LT(std::abs(field_clearance_m(field, *field.entry_W)), 1e-3);
}

TEST_F(FieldFile, OneOfSeveralPolygonsIsNamed) {
  const OGRPolygon small = polygon_of({square(500300.0, 4860000.0, 100.0)});
  const OGRPolygon large = polygon_of(kUtmRings);
  write_features(path("a.gpkg"), "GPKG", "EPSG:32615", {&small, &large});
  EXPECT_EQ(
      line_of(from_file(path("a.gpkg"))),
      path("a.gpkg").string() +
          ": '2 polygons': a field is one polygon with holes; choose one with field.part, its "
          "name or number: 2 field 2, 3.75 ha; 1 field 1, 1.00 ha");
  FieldSource source = from_file(path("a.gpkg"));
  for (const char* part : {"field 2", "2"}) {
    source.part = part;
    expect_the_square(read_field(source, "demo.yaml"));
  }
  source.part = "field 1";
  EXPECT_NEAR(field_area_m2(read_field(source, "demo.yaml")), 1e4 / (kUtmScale * kUtmScale), 1.0);
  source.part = "field 3";
  EXPECT_THAT(line_of(source),
              HasSubstr("part: 'field 3': no polygon has this name; did you mean "));
}

TEST_F(FieldFile, PartsOfAMultipolygonAreNumbered) {
  OGRMultiPolygon both;
  for (const double left : {500000.0, 500300.0}) {
    const OGRPolygon part = polygon_of({square(left, 4860000.0, left > 500200.0 ? 100.0 : 200.0)});
    both.addGeometry(&part);
  }
  write_features(path("a.gpkg"), "GPKG", "EPSG:32615", {&both});
  FieldSource source = from_file(path("a.gpkg"));
  EXPECT_THAT(line_of(source), HasSubstr("'2 polygons': a field is one polygon with holes"));
  source.part = "field 1";
  EXPECT_THAT(line_of(source), HasSubstr("2 polygons have this name; give the number of one"));
  source.part = "2";
  EXPECT_NEAR(field_area_m2(read_field(source, "demo.yaml")), 1e4 / (kUtmScale * kUtmScale), 1.0);
}

TEST_F(FieldFile, LayerCanBeNamed) {
  const OGRPolygon polygon = polygon_of(kUtmRings);
  write_features(path("a.gpkg"), "GPKG", "EPSG:32615", {&polygon}, "north");
  FieldSource source = from_file(path("a.gpkg"));
  source.layer = "north";
  expect_the_square(read_field(source, "demo.yaml"));
  source.layer = "nort";
  EXPECT_THAT(line_of(source), HasSubstr("layer: 'nort': no such layer; it has north"));
}

TEST_F(FieldFile, CrsGivenStandsInForAMissingOne) {
  const OGRPolygon polygon = polygon_of(kUtmRings);
  write_features(path("a.shp"), "ESRI Shapefile", "", {&polygon});
  EXPECT_THAT(line_of(from_file(path("a.shp"))), HasSubstr("has no CRS; give it as crs"));
  FieldSource source = from_file(path("a.shp"));
  source.crs = "EPSG:32615";
  expect_the_square(read_field(source, "demo.yaml"));
}

TEST_F(FieldFile, MissingFileIsRefused) {
  EXPECT_EQ(line_of(from_file("/nowhere/field.geojson")), "/nowhere/field.geojson: no such file");
}

TEST_F(FieldFile, MalformedJsonIsRefusedWithItsLine) {
  const auto file = written("a.geojson", "{\"type\": \"FeatureCollection\",\n\"features\": [\n,]}");
  EXPECT_THAT(line_of(from_file(file)), HasSubstr("a.geojson: line 3: malformed JSON"));
}

TEST_F(FieldFile, NanInJsonIsRefusedWithItsLine) {
  const auto file = written("a.geojson", "{\"type\": \"Polygon\",\n\"coordinates\": [[[NaN, 1]]]}");
  EXPECT_THAT(line_of(from_file(file)), HasSubstr("a.geojson: line 2: malformed JSON"));
}

TEST_F(FieldFile, OtherJsonAndOtherFilesAreRefused) {
  EXPECT_THAT(line_of(from_file(written("a.json", "{\"a\": 1}"))),
              HasSubstr("a.json: not a vector file that GDAL reads"));
  EXPECT_THAT(line_of(from_file(written("a.gpkg", "nothing of the kind"))),
              HasSubstr("a.gpkg: not a vector file that GDAL reads"));
  EXPECT_THAT(line_of(from_file(written("empty.geojson", ""))),
              HasSubstr("empty.geojson: line 1: malformed JSON"));
}

TEST_F(FieldFile, FileWithoutPolygonsIsRefused) {
  OGRPoint point(-93.0, 44.0);
  write_features(path("a.geojson"), "GeoJSON", "EPSG:4326", {&point});
  EXPECT_THAT(line_of(from_file(path("a.geojson"))), HasSubstr("a.geojson: holds no polygon"));
}

TEST_F(FieldFile, EmptyPolygonIsRefused) {
  const auto file = written("a.geojson", R"({"type": "Feature", "properties": {},
    "geometry": {"type": "Polygon", "coordinates": []}})");
  EXPECT_THAT(line_of(from_file(file)), HasSubstr("a.geojson: holds no polygon"));
}

TEST_F(FieldFile, GeoJsonInMetresIsRefused) {
  const OGRPolygon polygon = polygon_of(kUtmRings);
  write_features(path("a.geojson"), "GeoJSON", "", {&polygon});
  EXPECT_THAT(line_of(from_file(path("a.geojson"))),
              HasSubstr("not degrees: longitude -180..180 first"));
}

}  // namespace
}  // namespace headland
