// Fields read from files of every kind.
#include <gmock/gmock.h>

#include <fstream>

#include "scratch_folder.h"
#include "terrains/field_source.h"
#include "utm_square.h"
#include "vector_writer.h"

namespace headland {
namespace {

using test::expect_the_square;
using test::kUtmRings;
using test::kUtmScale;
using test::line_of;
using test::rings_in_degrees;
using test::square;
using testing::HasSubstr;

FieldSource from_file(const std::filesystem::path& file) {
  FieldSource source;
  source.file = file;
  return source;
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
