#include "terrains/soil_source.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "terrains/field_source.h"
#include "tests/terrains/raster_writer.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

// A field of 200 m by 100 m on the meridian of UTM zone 15, far from any cell's rounding.
constexpr double kEast = 500000.0;
constexpr double kNorth = 4860000.0;

Field utm_field() {
  FieldSource source;
  source.crs = "EPSG:32615";
  source.boundary = {{kEast, kNorth},
                     {kEast + 200.0, kNorth},
                     {kEast + 200.0, kNorth + 100.0},
                     {kEast, kNorth + 100.0}};
  return read_field(source, "test.yaml");
}

Eigen::Vector2d from_utm(const Field& field, double x, double y) {
  return local_from_wgs84(field.frame,
                          wgs84_from_crs("EPSG:32615", {{kEast + x, kNorth + y}}, "test"))
      .front();
}

// A rectangle in metres from the field's corner, as a GeoJSON feature in degrees.
std::string zone(double x0, double y0, double x1, double y1, const std::string& properties) {
  std::string ring;
  const Ring corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
  for (const Eigen::Vector2d& p : corners) {
    const Eigen::Vector2d lon_lat_deg =
        wgs84_from_crs("EPSG:32615", {{kEast + p.x(), kNorth + p.y()}}, "test").front();
    ring += fmt::format("{}[{:.9f}, {:.9f}]", ring.empty() ? "" : ", ", lon_lat_deg.x(),
                        lon_lat_deg.y());
  }
  return fmt::format(
      R"({{"type": "Feature", "properties": {{{}}}, "geometry": {{"type": "Polygon", )"
      R"("coordinates": [[{}]]}}}})",
      properties, ring);
}

std::string collection(const std::vector<std::string>& features) {
  return fmt::format(R"({{"type": "FeatureCollection", "features": [{}]}})",
                     fmt::join(features, ", "));
}

class SoilSourceFile : public ScratchFolder {
 protected:
  SoilSource zones(const std::vector<std::string>& features) const {
    SoilSource source;
    source.file = written("zones.geojson", collection(features));
    source.soil = *find_soil("tilled");
    return source;
  }
  std::string refused(const SoilSource& source, const Field& field = utm_field()) const {
    const std::string message = refusal([&] { read_soil(source, field, "test.yaml"); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  }
  std::string refused_zone(const std::string& properties) const {
    return refused(zones({zone(0, 0, 100, 100, properties)}));
  }
};

TEST_F(SoilSourceFile, OneSoilNeedsNoGrid) {
  SoilSource source;
  source.soil = soil_of_cone_index(750.0);
  const SoilReading reading = read_soil(source, utm_field(), "test.yaml");
  EXPECT_EQ(reading.map.columns, 0);
  EXPECT_EQ(soil_at(reading.map, {3.0, 4.0}).name, "cone index 750 kPa");
}

TEST_F(SoilSourceFile, ZonesHoldWhereTheirPolygonsLie) {
  const Field field = utm_field();
  const SoilReading reading =
      read_soil(zones({zone(-5, -5, 60, 105, R"("soil": "soft")"),
                       zone(120, -5, 205, 40, R"("cone_index_kpa": 1500.4)")}),
                field, "test.yaml");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double x = 200.0 * part(random);
    const double y = 100.0 * part(random);
    // A cell of 1 m has its own soil: to within its diagonal from an edge either is right.
    const auto near = [](double value, double edge) { return std::abs(value - edge) < 1.0; };
    if (near(x, 60.0) || near(x, 120.0) || near(y, 40.0)) continue;
    const std::string expected = x < 60.0                ? "soft"
                                 : x > 120.0 && y < 40.0 ? "cone index 1500 kPa"
                                                         : "tilled";
    EXPECT_EQ(soil_at(reading.map, from_utm(field, x, y)).name, expected) << x << ", " << y;
  }
  // 60 x 100 and 80 x 40 of 200 x 100 m2 are zones. Cells along the edges: half a percent.
  EXPECT_NEAR(reading.default_ratio, 1.0 - (6000.0 + 3200.0) / 20000.0, 0.005);
}

TEST_F(SoilSourceFile, TheLastOfOverlappingZonesHolds) {
  const Field field = utm_field();
  const SoilReading reading = read_soil(zones({zone(-20, -20, 220, 120, R"("soil": "hard")"),
                                               zone(50, 0, 150, 100, R"("soil": "soft")")}),
                                        field, "test.yaml");
  EXPECT_EQ(soil_at(reading.map, from_utm(field, 100.0, 50.0)).name, "soft");
  EXPECT_EQ(soil_at(reading.map, from_utm(field, 20.0, 50.0)).name, "hard");
  EXPECT_EQ(reading.default_ratio, 0.0);
}

TEST_F(SoilSourceFile, AZoneOfTheDefaultSoilIsNoGap) {
  const SoilReading reading =
      read_soil(zones({zone(-20, -20, 220, 120, R"("soil": "tilled")")}), utm_field(), "test.yaml");
  EXPECT_EQ(reading.default_ratio, 0.0);
}

Raster cone_indices() {
  Raster raster;
  raster.left = kEast - 50.0;
  raster.bottom = kNorth - 50.0;
  raster.pixels = 60;
  raster.height = [](double x, double y) { return 500.0 + 2.0 * (x - kEast) + 5.0 * (y - kNorth); };
  return raster;
}

TEST_F(SoilSourceFile, ARasterGivesEveryCellItsConeIndex) {
  const Field field = utm_field();
  for (const bool megapascal : {false, true}) {
    Raster raster = cone_indices();
    if (megapascal) {
      raster.unit = "MPa";
      raster.height = [own = raster.height](double x, double y) { return 1e-3 * own(x, y); };
    }
    SoilSource source;
    source.file = path("ci.tif");
    write(raster, source.file);
    const SoilReading reading = read_soil(source, field, "test.yaml");
    EXPECT_EQ(reading.default_ratio, 0.0);
    for (const auto& [x, y] : {std::pair(10.0, 10.0), {190.0, 10.0}, {10.0, 90.0}}) {
      const Soil& soil = soil_at(reading.map, from_utm(field, x, y));
      // Half a pixel of 5 m away, at 2 and 5 kPa a metre, and half a cell of 1 m more.
      EXPECT_NEAR(std::get<BrixiusSoil>(soil.law).cone_index_kpa, 500.0 + 2.0 * x + 5.0 * y, 21.0);
    }
  }
}

TEST_F(SoilSourceFile, WhereARasterHasNoDataTheDefaultHolds) {
  const Field field = utm_field();
  Raster raster = cone_indices();
  raster.height = [](double x, double) { return x < kEast + 50.0 ? kNoData : 800.0; };
  SoilSource source;
  source.soil = *find_soil("hard");
  source.file = path("ci.tif");
  write(raster, source.file);
  const SoilReading reading = read_soil(source, field, "test.yaml");
  EXPECT_NEAR(reading.default_ratio, 0.25, 0.01);  // a cell's width of 200 m: half a percent
  EXPECT_EQ(soil_at(reading.map, from_utm(field, 30.0, 50.0)).name, "hard");
  EXPECT_EQ(soil_at(reading.map, from_utm(field, 70.0, 50.0)).name, "cone index 800 kPa");
}

TEST_F(SoilSourceFile, RefusesZonesWithoutASoil) {
  const std::string at = path("zones.geojson").string() + ": feature 1";
  EXPECT_EQ(refused_zone(R"("name": "a")"),
            at + ": a zone needs a property soil (a known soil's name) or cone_index_kpa");
  EXPECT_THAT(refused_zone(R"("soil": "sofd")"),
              HasSubstr(at + ": soil: 'sofd': unknown soil; did you mean 'soft'?"));
  EXPECT_EQ(refused_zone(R"("soil": "soft", "cone_index_kpa": 450)"),
            at + ": has both soil and cone_index_kpa; give one of them");
  for (const char* value : {"-450", "0", "1e9", "\"wet\""}) {
    EXPECT_THAT(refused_zone(fmt::format("\"cone_index_kpa\": {}", value)),
                HasSubstr("a number from 10 to 20000 kPa"));
  }
  EXPECT_EQ(refused_zone(R"("cone_index_kpa": true)"),
            at + ": cone_index_kpa: 'true': a number in kPa is needed");
}

// A zone whose edges cross covers either half or nothing, as one reads it.
TEST_F(SoilSourceFile, RefusesZonesThatCrossThemselves) {
  const std::string bow_tie =
      R"({"type": "Feature", "properties": {"soil": "soft"}, "geometry": {"type": "Polygon", )"
      R"("coordinates": [[[-93, 43.9], [-92.99, 43.91], [-92.99, 43.9], [-93, 43.91], [-93, 43.9]]]}})";
  EXPECT_EQ(refused(zones({zone(0, 0, 50, 50, R"("soil": "soft")"), bow_tie})),
            path("zones.geojson").string() +
                ": feature 2: its polygon crosses itself, or its rings one another");
}

TEST_F(SoilSourceFile, RefusesFilesThatAreNone) {
  SoilSource source;
  source.file = path("none.geojson");
  EXPECT_THAT(refused(source), HasSubstr("none.geojson: no such file"));
  source.file = written("text.tif", "no raster");
  EXPECT_THAT(refused(source), HasSubstr("neither a raster nor a vector file that GDAL reads"));
  source.file = written("broken.geojson", "{\n\"type\": [\n");
  EXPECT_THAT(refused(source), HasSubstr("line 3"));
  source.file = written("points.geojson", collection({R"({"type": "Feature", "properties": {},
      "geometry": {"type": "Point", "coordinates": [-93, 43]}})"}));
  EXPECT_THAT(refused(source), HasSubstr("holds no polygon; the zones of a soil map are polygons"));
  source = zones({zone(0, 0, 100, 100, R"("soil": "soft")")});
  source.layer = "subsoil";
  EXPECT_THAT(refused(source), HasSubstr("layer: 'subsoil': no such layer; it has zones"));
}

TEST_F(SoilSourceFile, RefusesFilesThatLieElsewhere) {
  EXPECT_THAT(refused(zones({zone(5000, 0, 5100, 100, R"("soil": "soft")")})),
              HasSubstr("says nothing about the soil of the field: it lies elsewhere"));
  Field local;
  local.boundary = {{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}};
  EXPECT_THAT(refused(zones({zone(0, 0, 100, 100, R"("soil": "soft")")}), local),
              HasSubstr("lies on the earth but the field does not"));
  Raster raster = cone_indices();
  raster.crs = "";
  SoilSource source;
  source.file = path("ci.tif");
  write(raster, source.file);
  EXPECT_THAT(refused(source), HasSubstr("has no CRS; give it as soil.crs"));
  source.crs = "EPSG:32615";
  EXPECT_EQ(refused(source), "accepted");
}

TEST_F(SoilSourceFile, RefusesRastersOfOtherThings) {
  SoilSource source;
  source.file = path("ci.tif");
  Raster raster = cone_indices();
  raster.height = [](double x, double) { return x > kEast + 100.0 ? 0.0 : 800.0; };
  write(raster, source.file);
  EXPECT_THAT(refused(source), HasSubstr("'0': not a cone index from 10 to 20000 kPa, at lon -9"));
  raster = cone_indices();
  raster.unit = "m";
  write(raster, source.file);
  EXPECT_THAT(refused(source), HasSubstr("unit of the cone indices: 'm': kPa or MPa"));
  write(cone_indices(), source.file);
  source.layer = "a";
  EXPECT_THAT(refused(source), HasSubstr("test.yaml: soil.layer: 'a': only of vector files"));
}

TEST_F(SoilSourceFile, RefusesMapsTooLargeForMemory) {
  SoilSource source = zones({zone(0, 0, 100, 100, R"("soil": "soft")")});
  source.cell_m = 0.01;
  EXPECT_THAT(refused(source), HasSubstr("test.yaml: soil.cell_m: '0.01': 22"));
}

}  // namespace
}  // namespace headland
