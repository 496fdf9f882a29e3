#include "terrains/raster.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>

#include "raster_writer.h"
#include "refusal.h"
#include "scratch_folder.h"
#include "terrains/field_source.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

using testing::HasSubstr;

double plane_m(double easting_m, double northing_m) {
  return 300.0 + 0.03 * (easting_m - 500000.0) - 0.02 * (northing_m - 4860000.0);
}

// 200 m square on zone 15's central meridian, given in degrees.
Field field_in_degrees() {
  FieldSource source;
  source.crs = "EPSG:4326";
  source.boundary = wgs84_from_crs(
      "EPSG:32615",
      {{500000.0, 4860000.0}, {500200.0, 4860000.0}, {500200.0, 4860200.0}, {500000.0, 4860200.0}},
      "test");
  return read_field(source, "test");
}

Field field_in_metres() {
  FieldSource source;
  source.boundary = {{0.0, 0.0}, {200.0, 0.0}, {200.0, 200.0}, {0.0, 200.0}};
  return read_field(source, "test");
}

// UTM coordinates of p_W, by way of degrees: the test's own path, not the warp's.
std::vector<Eigen::Vector2d> utm_m(const GeoFrame& frame, const std::vector<Eigen::Vector2d>& p_W) {
  OGRSpatialReference wgs84;
  wgs84.SetFromUserInput("EPSG:4326");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference utm;
  utm.SetFromUserInput("EPSG:32615");
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&wgs84, &utm));
  std::vector<Eigen::Vector2d> points = wgs84_from_local(frame, p_W);
  for (Eigen::Vector2d& point : points) transformation->Transform(1, &point.x(), &point.y());
  return points;
}

TerrainSource from_file(const std::filesystem::path& file) {
  TerrainSource source;
  source.file = file;
  return source;
}

std::string line_of(const TerrainSource& source, const Field& field) {
  return refusal([&] { read_terrain(source, field, "demo.yaml"); });
}

class RasterFile : public ScratchFolder {
 protected:
  std::filesystem::path plane(const std::string& name, Raster raster = {}) const {
    if (!raster.height) raster.height = plane_m;
    write(raster, path(name));
    return path(name);
  }
};

// The warp finds places to 0.001 pixels of 5 m, where the plane rises 0.036 m a metre.
constexpr double kWarp_m = 2e-4;

void expect_the_plane(const Heightfield& terrain, const Field& field, double tolerance_m) {
  std::vector<Eigen::Vector2d> nodes_W;
  std::vector<double> heights_m;
  for (int j = 0; j < terrain.rows; j += 7) {
    for (int i = 0; i < terrain.columns; i += 7) {
      nodes_W.emplace_back(terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j));
      heights_m.push_back(terrain.at(i, j));
    }
  }
  const std::vector<Eigen::Vector2d> nodes_utm = utm_m(field.frame, nodes_W);
  for (std::size_t k = 0; k < nodes_W.size(); ++k) {
    ASSERT_NEAR(heights_m[k], plane_m(nodes_utm[k].x(), nodes_utm[k].y()), tolerance_m)
        << nodes_W[k].transpose();
  }
}

TEST_F(RasterFile, PlaneInUtmUnderAFieldInDegreesIsRecovered) {
  const Field field = field_in_degrees();
  const Heightfield terrain = read_terrain(from_file(plane("a.tif")), field, "test");
  EXPECT_EQ(terrain.cell_m, 1.0);
  expect_the_plane(terrain, field, kWarp_m);
}

TEST_F(RasterFile, FineRastersKeepTheirCell) {
  Raster fine;
  fine.pixel_size = 0.5;
  fine.pixels = 600;
  fine.left = 499950.0;
  fine.bottom = 4859950.0;
  const Heightfield terrain =
      read_terrain(from_file(plane("a.tif", fine)), field_in_degrees(), "test");
  // UTM's 0.9996 makes its half metre a little longer on the ground.
  EXPECT_NEAR(terrain.cell_m, 0.5 / 0.9996, 1e-6);
}

TEST_F(RasterFile, CoarserCellsOnRequest) {
  const Field field = field_in_degrees();
  TerrainSource source = from_file(plane("a.tif"));
  source.cell_m = 10.0;
  const Heightfield terrain = read_terrain(source, field, "test");
  EXPECT_EQ(terrain.cell_m, 10.0);
  // Twice the raster's pixel: places are found to 0.001 of the larger one.
  expect_the_plane(terrain, field, 2.0 * kWarp_m);
}

TEST_F(RasterFile, AsciiGridIsRead) {
  Raster ascii;
  ascii.driver = "AAIGrid";
  const Field field = field_in_degrees();
  // The format's text keeps 1e-3 m or better.
  expect_the_plane(read_terrain(from_file(plane("a.asc", ascii)), field, "test"), field, 2e-3);
}

TEST_F(RasterFile, SrtmTileIsRead) {
  // A tile of 1201 x 1201 big-endian 16-bit heights; its south-west sample lies on the degree of
  // its name. Heights rise by 1 m a sample to the east.
  std::string heights;
  for (int j = 0; j < 1201; ++j) {
    for (int i = 0; i < 1201; ++i) {
      heights += static_cast<char>(i >> 8);
      heights += static_cast<char>(i & 255);
    }
  }
  FieldSource square;
  square.crs = "EPSG:4326";
  square.boundary = {{-93.502, 43.5}, {-93.5, 43.5}, {-93.5, 43.502}, {-93.502, 43.502}};
  const Field field = read_field(square, "test");
  const Heightfield terrain =
      read_terrain(from_file(written("N43W094.hgt", heights)), field, "test");
  const Eigen::Vector2d lon_lat_deg = wgs84_from_local(field.frame, {{0.0, 0.0}})[0];
  // 0.001 pixels of 1 m rise.
  EXPECT_NEAR(surface_at(terrain, 0.0, 0.0).height_m, (lon_lat_deg.x() + 94.0) * 1200.0, 2e-3);
}

TEST_F(RasterFile, FeetBecomeMetres) {
  Raster feet;
  feet.unit = "ft";
  feet.height = [](double, double) { return 1000.0; };
  const Heightfield terrain =
      read_terrain(from_file(plane("a.tif", feet)), field_in_degrees(), "test");
  EXPECT_NEAR(terrain.at(50, 50), 304.8, 1e-9);
}

TEST_F(RasterFile, ScaleAndOffsetAreHonoured) {
  Raster scaled;
  scaled.type = GDT_Int32;
  scaled.scale = 0.01;
  scaled.offset = 100.0;
  scaled.height = [](double, double) { return 12345.0; };
  const Heightfield terrain =
      read_terrain(from_file(plane("a.tif", scaled)), field_in_degrees(), "test");
  EXPECT_NEAR(terrain.at(50, 50), 223.45, 1e-9);
}

TEST_F(RasterFile, UnknownUnitIsRefused) {
  Raster raster;
  raster.unit = "furlong";
  EXPECT_THAT(line_of(from_file(plane("a.tif", raster)), field_in_degrees()),
              HasSubstr("unit of the heights: 'furlong': metres or feet"));
}

TEST_F(RasterFile, MarginOutsideTheRasterTakesTheNearestHeights) {
  // The raster ends 10 m beyond the field, the terrain 30 m.
  Raster tight;
  tight.pixels = 44;
  tight.left = 499990.0;
  tight.bottom = 4859990.0;
  const Field field = field_in_degrees();
  const Heightfield terrain = read_terrain(from_file(plane("a.tif", tight)), field, "test");
  const auto height_m = [&](double easting_m, double northing_m) {
    const Eigen::Vector2d p_W = local_from_wgs84(
        field.frame, wgs84_from_crs("EPSG:32615", {{easting_m, northing_m}}, "test"))[0];
    return surface_at(terrain, p_W.x(), p_W.y()).height_m;
  };
  // The last known node is within a cell of the edge, and splines lean inwards there by less than
  // half a pixel: 3.5 m at 0.03.
  constexpr double kEdge_m = 0.11;
  EXPECT_NEAR(height_m(499975.0, 4860100.0), plane_m(499990.0, 4860100.0), kEdge_m);
  EXPECT_NEAR(height_m(500225.0, 4860100.0), plane_m(500210.0, 4860100.0), kEdge_m);
  for (double height : terrain.height_m) ASSERT_TRUE(std::isfinite(height));
}

TEST_F(RasterFile, PartOfTheFieldOutsideTheRasterIsRefusedWithItsShare) {
  // The raster starts a quarter into the field: 25 % of it is missing.
  Raster east;
  east.left = 500050.0;
  const std::string line = line_of(from_file(plane("a.tif", east)), field_in_degrees());
  double percent = 0.0;
  const std::size_t at = line.find(": does not cover");
  ASSERT_NE(at, std::string::npos) << line;
  ASSERT_EQ(std::sscanf(line.c_str() + at, ": does not cover the field: %lf %% of it is missing",
                        &percent),
            1)
      << line;
  // Whole nodes of 1 m2: up to a row of 200 along each side of 50 x 200 m.
  EXPECT_NEAR(percent, 25.0, 0.6);
}

TEST_F(RasterFile, RasterElsewhereIsRefused) {
  Raster elsewhere;
  elsewhere.left = 700000.0;
  EXPECT_THAT(line_of(from_file(plane("a.tif", elsewhere)), field_in_degrees()),
              HasSubstr("does not cover the field: 100 % of it is missing"));
}

TEST_F(RasterFile, NodataInTheFieldIsRefusedWithAreaAndPlace) {
  // A 20 m square without data around (500110, 4860110).
  Raster gap;
  gap.height = [](double x, double y) {
    return std::abs(x - 500110.0) < 10.0 && std::abs(y - 4860110.0) < 10.0 ? kNoData
                                                                           : plane_m(x, y);
  };
  const std::string line = line_of(from_file(plane("a.tif", gap)), field_in_degrees());
  double area_m2 = 0.0, longitude_deg = 0.0, latitude_deg = 0.0;
  const std::size_t at = line.find("has no data over ");
  ASSERT_NE(at, std::string::npos) << line;
  ASSERT_EQ(std::sscanf(line.c_str() + at,
                        "has no data over %lf m2 of the field, around lon %lf, lat %lf", &area_m2,
                        &longitude_deg, &latitude_deg),
            3)
      << line;
  // Whole nodes of 1 m2: half a cell along each 20 m side.
  EXPECT_NEAR(area_m2, 400.0, 40.0);
  const auto place_deg = wgs84_from_crs("EPSG:32615", {{500110.0, 4860110.0}}, "test")[0];
  EXPECT_NEAR(longitude_deg, place_deg.x(), 3e-5);
  EXPECT_NEAR(latitude_deg, place_deg.y(), 3e-5);
}

TEST_F(RasterFile, NodataOutsideTheFieldIsFilled) {
  Raster gap;
  gap.height = [](double x, double y) { return x < 499980.0 ? kNoData : plane_m(x, y); };
  EXPECT_EQ(line_of(from_file(plane("a.tif", gap)), field_in_degrees()), "accepted");
}

TEST_F(RasterFile, UndeclaredNodataIsRefused) {
  Raster gap;
  gap.declare_nodata = false;
  gap.height = [](double x, double y) {
    return std::abs(x - 500110.0) < 10.0 && std::abs(y - 4860110.0) < 10.0 ? kNoData
                                                                           : plane_m(x, y);
  };
  const std::string line = line_of(from_file(plane("a.tif", gap)), field_in_degrees());
  EXPECT_THAT(line, HasSubstr("'-9999': not a height in metres at lon -92.99"));
  EXPECT_THAT(line, HasSubstr("if it stands for no data, the file must declare it"));
}

TEST_F(RasterFile, NanCountsAsNodata) {
  Raster gap;
  gap.declare_nodata = false;
  gap.height = [](double x, double y) {
    return std::abs(x - 500110.0) < 10.0 ? std::numeric_limits<double>::quiet_NaN() : plane_m(x, y);
  };
  EXPECT_THAT(line_of(from_file(plane("a.tif", gap)), field_in_degrees()),
              HasSubstr("has no data over"));
}

TEST_F(RasterFile, RasterWithoutCrsNeedsOne) {
  Raster bare;
  bare.crs = "";
  const Field field = field_in_degrees();
  TerrainSource source = from_file(plane("a.tif", bare));
  EXPECT_THAT(line_of(source, field), HasSubstr("has no CRS; give it as terrain.crs"));
  source.crs = "EPSG:32615";
  expect_the_plane(read_terrain(source, field, "test"), field, kWarp_m);
  source.crs = "EPSG:nonsense";
  EXPECT_THAT(line_of(source, field), HasSubstr("'EPSG:nonsense': unknown CRS"));
}

TEST_F(RasterFile, LocalFieldTakesALocalRasterOnly) {
  Raster local;
  local.crs = "";
  local.left = -150.0;
  local.bottom = -150.0;
  local.height = [](double x, double y) { return 5.0 + 0.1 * x + 0.05 * y; };
  const Heightfield terrain =
      read_terrain(from_file(plane("a.tif", local)), field_in_metres(), "test");
  EXPECT_NEAR(surface_at(terrain, 100.0, 50.0).height_m, 17.5, kWarp_m);
  EXPECT_THAT(line_of(from_file(plane("b.tif")), field_in_metres()),
              HasSubstr("lies on the earth but the field does not"));
}

TEST_F(RasterFile, MissingAndOtherFilesAreRefused) {
  const Field field = field_in_degrees();
  EXPECT_EQ(line_of(from_file("/nowhere/dem.tif"), field), "/nowhere/dem.tif: no such file");
  EXPECT_THAT(line_of(from_file(written("a.tif", "no picture")), field),
              HasSubstr("a.tif: not a raster that GDAL reads"));
}

TEST_F(RasterFile, TruncatedFileIsRefused) {
  const auto file = plane("a.tif");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(line_of(from_file(file), field_in_degrees()), HasSubstr("a.tif: "));
}

TEST_F(RasterFile, PictureIsRefused) {
  GDALAllRegister();
  const char* const options[] = {"PHOTOMETRIC=RGB", nullptr};
  {
    const GDALDatasetUniquePtr picture(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path("a.tif").c_str(), 10, 10, 3, GDT_Byte, const_cast<char**>(options)));
  }
  EXPECT_THAT(line_of(from_file(path("a.tif")), field_in_degrees()),
              HasSubstr("a picture, not heights"));
}

TEST_F(RasterFile, RasterThatDoesNotSayWhereItLiesIsRefused) {
  GDALAllRegister();
  {
    const GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path("a.tif").c_str(), 10, 10, 1, GDT_Float32, nullptr));
  }
  EXPECT_THAT(line_of(from_file(path("a.tif")), field_in_degrees()),
              HasSubstr("has no geotransform"));
}

TEST_F(RasterFile, AlphaBandMarksNodata) {
  GDALAllRegister();
  const auto file = path("a.tif");
  {
    const char* const options[] = {"ALPHA=YES", nullptr};
    GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), 100, 100, 2, GDT_Float32, const_cast<char**>(options)));
    double geotransform[6] = {499850.0, 5.0, 0.0, 4860350.0, 0.0, -5.0};
    raster->SetGeoTransform(geotransform);
    OGRSpatialReference reference;
    reference.SetFromUserInput("EPSG:32615");
    raster->SetSpatialRef(&reference);
    raster->GetRasterBand(1)->Fill(250.0);
    raster->GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
    raster->GetRasterBand(2)->Fill(255.0);
    std::vector<float> clear(100 * 30, 0.0F);
    ASSERT_EQ(raster->GetRasterBand(2)->RasterIO(GF_Write, 0, 40, 100, 30, clear.data(), 100, 30,
                                                 GDT_Float32, 0, 0, nullptr),
              CE_None);
  }
  EXPECT_THAT(line_of(from_file(file), field_in_degrees()), HasSubstr("has no data over"));
}

}  // namespace
}  // namespace headland
