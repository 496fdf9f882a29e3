#include "terrains/raster_band.h"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_utils.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <memory>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

// Largest error of the warp's approximated transformation, in raster pixels.
constexpr const char* kTransformError = "0.001";

void require_placeable(GDALDataset& raster, const std::string& crs, const RasterUse& use,
                       const Field& field, const std::string& file) {
  double geotransform[6];
  const bool placed = raster.GetGeoTransform(geotransform) == CE_None;
  if (!placed && raster.GetGCPCount() == 0) {
    throw InputError(file, "", "", "has no geotransform: it does not say where its pixels lie");
  }
  const double pixel_area = geotransform[1] * geotransform[5] - geotransform[2] * geotransform[4];
  if (placed && !(std::abs(pixel_area) > 0.0 && std::isfinite(pixel_area))) {
    throw InputError(file, "size of a pixel",
                     fmt::format("{} x {}", geotransform[1], geotransform[5]),
                     "finite and not 0; in an ASCII grid: cellsize");
  }
  const bool has_crs =
      !crs.empty() || raster.GetSpatialRef() != nullptr || raster.GetGCPSpatialRef() != nullptr;
  if (field.frame.georeferenced && !has_crs) {
    throw InputError(file, "", "",
                     fmt::format("has no CRS; give it as {}, for example EPSG:32615", use.crs_key));
  }
  if (!field.frame.georeferenced && has_crs) {
    throw InputError(file, "", "",
                     "lies on the earth but the field does not; give the crs of the field's "
                     "coordinates as field.crs");
  }
}

}  // namespace

RasterBand open_raster_band(const std::filesystem::path& path, const std::string& crs,
                            const RasterUse& use, const Field& field, const GdalScope& gdal) {
  const std::string file = path.string();
  require_file_or_folder(path);
  RasterBand opened;
  opened.file.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (opened.file == nullptr || opened.file->GetRasterCount() == 0) {
    throw InputError(file, "", "",
                     "not a raster that GDAL reads (GeoTIFF, AAIGrid, SRTM...)" +
                         (gdal.complaint().empty() ? "" : ": " + gdal.complaint()));
  }
  GDALRasterBand& band = *opened.file->GetRasterBand(1);
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour == GCI_PaletteIndex || colour == GCI_RedBand) {
    throw InputError(file, "", "",
                     fmt::format("a picture, not {}: its first band is a colour", use.numbers));
  }
  if (!crs.empty()) {
    const OGRSpatialReference known = spatial_reference(crs, file);
    opened.crs = crs;
  }
  require_placeable(*opened.file, crs, use, field, file);
  opened.scale = band.GetScale();
  opened.offset = band.GetOffset();
  opened.unit = band.GetUnitType();

  CPLStringList options;
  for (const char* word : {"-of", "VRT", "-b", "1"}) options.AddString(word);
  // GDAL itself takes an alpha band for a mask only when it holds whole numbers.
  for (GDALRasterBand* other : opened.file->GetBands()) {
    if (other->GetColorInterpretation() != GCI_AlphaBand) continue;
    options.AddString("-mask");
    options.AddString(std::to_string(other->GetBand()).c_str());
  }
  const std::unique_ptr<GDALTranslateOptions, decltype(&GDALTranslateOptionsFree)> parsed(
      GDALTranslateOptionsNew(options.List(), nullptr), GDALTranslateOptionsFree);
  opened.view.reset(GDALDataset::FromHandle(
      GDALTranslate("", GDALDataset::ToHandle(opened.file.get()), parsed.get(), nullptr)));
  if (opened.view == nullptr) throw InputError(file, "", "", gdal.complaint());
  return opened;
}

std::vector<Eigen::Vector2d> pixels_from_local(const RasterBand& band, const Field& field,
                                               const std::vector<Eigen::Vector2d>& p_W) {
  CPLStringList options;
  if (!band.crs.empty()) options.SetNameValue("SRC_SRS", band.crs.c_str());
  if (field.frame.georeferenced) {
    options.SetNameValue("DST_SRS", proj_of(field.frame).c_str());
  }
  const std::unique_ptr<void, decltype(&GDALDestroyGenImgProjTransformer)> transformer(
      GDALCreateGenImgProjTransformer2(GDALDataset::ToHandle(band.view.get()), nullptr,
                                       options.List()),
      GDALDestroyGenImgProjTransformer);
  std::vector<Eigen::Vector2d> pixels(
      p_W.size(), Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
  if (transformer == nullptr) return pixels;
  for (std::size_t i = 0; i < p_W.size(); ++i) {
    double x = p_W[i].x();
    double y = p_W[i].y();
    double z = 0.0;
    int success = 0;
    GDALGenImgProjTransform(transformer.get(), 1, 1, &x, &y, &z, &success);
    if (success != 0) pixels[i] = {x, y};
  }
  return pixels;
}

template <typename Number>
std::vector<Number> warped(const RasterBand& band, const Field& field, const RasterGrid& points,
                           const char* resampling, const GdalScope& gdal) {
  const std::string file = band.file->GetDescription();
  std::vector<Number> numbers(
      static_cast<std::size_t>(points.columns) * static_cast<std::size_t>(points.rows),
      std::numeric_limits<Number>::quiet_NaN());
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const GDALDatasetUniquePtr grid(
      memory->Create("", points.columns, points.rows, 0, GDT_Float32, nullptr));
  CPLStringList memory_band;
  memory_band.SetNameValue("DATAPOINTER",
                           fmt::format("{}", static_cast<void*>(numbers.data())).c_str());
  grid->AddBand(sizeof(Number) == sizeof(double) ? GDT_Float64 : GDT_Float32, memory_band.List());
  // Pixels are areas around the nodes.
  const double half_m = 0.5 * points.cell_m;
  double geotransform[6] = {points.first_W.x() - half_m,
                            points.cell_m,
                            0.0,
                            points.first_W.y() + (points.rows - 1) * points.cell_m + half_m,
                            0.0,
                            -points.cell_m};
  grid->SetGeoTransform(geotransform);
  if (field.frame.georeferenced) {
    const OGRSpatialReference local = spatial_reference(proj_of(field.frame), file);
    grid->SetSpatialRef(&local);
  }
  CPLStringList options;
  for (const char* word : {"-r", resampling, "-dstnodata", "nan", "-et", kTransformError, "-wt",
                           "Float64", "-novshift"}) {
    options.AddString(word);
  }
  if (!band.crs.empty()) {
    options.AddString("-s_srs");
    options.AddString(band.crs.c_str());
  }
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> parsed(
      GDALWarpAppOptionsNew(options.List(), nullptr), GDALWarpAppOptionsFree);
  GDALDatasetH from = GDALDataset::ToHandle(band.view.get());
  int usage_error = 0;
  GDALDatasetH done =
      GDALWarp(nullptr, GDALDataset::ToHandle(grid.get()), 1, &from, parsed.get(), &usage_error);
  if (done == nullptr) throw InputError(file, "", "", "cannot be read: " + gdal.complaint());
  grid->FlushCache(false);
  return numbers;
}

template std::vector<float> warped(const RasterBand&, const Field&, const RasterGrid&, const char*,
                                   const GdalScope&);
template std::vector<double> warped(const RasterBand&, const Field&, const RasterGrid&, const char*,
                                    const GdalScope&);

double native_cell_m(const RasterBand& band, const Field& field) {
  Eigen::AlignedBox2d box_W;
  for (const Eigen::Vector2d& p_W : field.boundary) box_W.extend(p_W);
  const Eigen::Vector2d middle_W = box_W.center();
  const std::vector<Eigen::Vector2d> pixels = pixels_from_local(
      band, field,
      {middle_W, middle_W + Eigen::Vector2d::UnitX(), middle_W + Eigen::Vector2d::UnitY()});
  Eigen::Matrix2d pixels_per_m;
  pixels_per_m << pixels[1] - pixels[0], pixels[2] - pixels[0];
  const double cell_m = 1.0 / std::sqrt(std::abs(pixels_per_m.determinant()));
  if (!std::isfinite(cell_m)) {
    throw InputError(band.file->GetDescription(), "", "",
                     "does not cover the field: 100 % of it is missing");
  }
  return cell_m;
}

}  // namespace headland
