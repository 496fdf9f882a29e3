#include "terrains/raster.h"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/nearest_heights.h"

namespace headland {
namespace {

// Largest error of the warp's approximated transformation, in raster pixels.
constexpr const char* kTransformError = "0.001";

// The first band of a raster with its mask, and what its numbers mean.
struct HeightBand {
  GDALDatasetUniquePtr file;
  GDALDatasetUniquePtr view;  // reads through `file`, so it goes first
  std::string crs;            // given with the terrain; empty: the file's own or none
  double scale = 1.0;         // height [m] = scale * number + offset_m
  double offset_m = 0.0;
};

double metres_per_unit(const std::string& unit, const OGRSpatialReference* reference,
                       const std::string& file) {
  if (unit.empty()) {
    return reference != nullptr && reference->IsCompound() != 0
               ? reference->GetTargetLinearUnits("VERT_CS")
               : 1.0;
  }
  constexpr double kFoot_m = 0.3048;
  constexpr double kUsSurveyFoot_m = 1200.0 / 3937.0;
  for (const char* metre : {"m", "metre", "meter", "metres", "meters"}) {
    if (EQUAL(unit.c_str(), metre)) return 1.0;
  }
  for (const char* foot : {"ft", "foot", "feet", "international foot"}) {
    if (EQUAL(unit.c_str(), foot)) return kFoot_m;
  }
  for (const char* foot : {"US survey foot", "us-ft", "ft_us", "ftUS", "sfoot"}) {
    if (EQUAL(unit.c_str(), foot)) return kUsSurveyFoot_m;
  }
  if (EQUAL(unit.c_str(), "cm")) return 0.01;
  throw InputError(file, "unit of the heights", unit, "metres or feet");
}

void require_placeable(GDALDataset& raster, const std::string& crs, const Field& field,
                       const std::string& file) {
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
    throw InputError(file, "", "", "has no CRS; give it as terrain.crs, for example EPSG:32615");
  }
  if (!field.frame.georeferenced && has_crs) {
    throw InputError(file, "", "",
                     "lies on the earth but the field does not; give the crs of the field's "
                     "coordinates as field.crs");
  }
}

HeightBand open_raster(const std::filesystem::path& path, const std::string& crs,
                       const Field& field, const GdalScope& gdal) {
  const std::string file = path.string();
  require_file_or_folder(path);
  HeightBand height;
  height.file.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (height.file == nullptr || height.file->GetRasterCount() == 0) {
    throw InputError(file, "", "",
                     "not a raster that GDAL reads (GeoTIFF, AAIGrid, SRTM...)" +
                         (gdal.complaint().empty() ? "" : ": " + gdal.complaint()));
  }
  GDALRasterBand& band = *height.file->GetRasterBand(1);
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour == GCI_PaletteIndex || colour == GCI_RedBand) {
    throw InputError(file, "", "", "a picture, not heights: its first band is a colour");
  }
  if (!crs.empty()) {
    const OGRSpatialReference known = spatial_reference(crs, file);
    height.crs = crs;
  }
  require_placeable(*height.file, crs, field, file);
  const double unit_m = metres_per_unit(band.GetUnitType(), height.file->GetSpatialRef(), file);
  height.scale = band.GetScale() * unit_m;
  height.offset_m = band.GetOffset() * unit_m;

  CPLStringList options;
  for (const char* word : {"-of", "VRT", "-b", "1"}) options.AddString(word);
  // GDAL itself takes an alpha band for a mask only when it holds whole numbers.
  for (GDALRasterBand* other : height.file->GetBands()) {
    if (other->GetColorInterpretation() != GCI_AlphaBand) continue;
    options.AddString("-mask");
    options.AddString(std::to_string(other->GetBand()).c_str());
  }
  const std::unique_ptr<GDALTranslateOptions, decltype(&GDALTranslateOptionsFree)> parsed(
      GDALTranslateOptionsNew(options.List(), nullptr), GDALTranslateOptionsFree);
  height.view.reset(GDALDataset::FromHandle(
      GDALTranslate("", GDALDataset::ToHandle(height.file.get()), parsed.get(), nullptr)));
  if (height.view == nullptr) throw InputError(file, "", "", gdal.complaint());
  return height;
}

// Where points in W lie in the raster, in pixels from its corner; NaN where they cannot.
std::vector<Eigen::Vector2d> pixels_from_local(const HeightBand& height, const Field& field,
                                               const std::vector<Eigen::Vector2d>& p_W) {
  CPLStringList options;
  if (!height.crs.empty()) options.SetNameValue("SRC_SRS", height.crs.c_str());
  if (field.frame.georeferenced) {
    options.SetNameValue("DST_SRS", proj_of(field.frame).c_str());
  }
  const std::unique_ptr<void, decltype(&GDALDestroyGenImgProjTransformer)> transformer(
      GDALCreateGenImgProjTransformer2(GDALDataset::ToHandle(height.view.get()), nullptr,
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

// The band on the terrain's grid, row by row from the north; NaN where there is none.
template <typename Number>
std::vector<Number> warped(const HeightBand& height, const Field& field, const Heightfield& terrain,
                           const char* resampling, const std::string& file, const GdalScope& gdal) {
  std::vector<Number> numbers(
      static_cast<std::size_t>(terrain.columns) * static_cast<std::size_t>(terrain.rows),
      std::numeric_limits<Number>::quiet_NaN());
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const GDALDatasetUniquePtr grid(
      memory->Create("", terrain.columns, terrain.rows, 0, GDT_Float32, nullptr));
  CPLStringList band;
  band.SetNameValue("DATAPOINTER", fmt::format("{}", static_cast<void*>(numbers.data())).c_str());
  grid->AddBand(sizeof(Number) == sizeof(double) ? GDT_Float64 : GDT_Float32, band.List());
  // Pixels are areas around the nodes.
  const double half_m = 0.5 * terrain.cell_m;
  double geotransform[6] = {terrain.origin_W.x() - half_m,
                            terrain.cell_m,
                            0.0,
                            terrain.origin_W.y() + (terrain.rows - 1) * terrain.cell_m + half_m,
                            0.0,
                            -terrain.cell_m};
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
  if (!height.crs.empty()) {
    options.AddString("-s_srs");
    options.AddString(height.crs.c_str());
  }
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> parsed(
      GDALWarpAppOptionsNew(options.List(), nullptr), GDALWarpAppOptionsFree);
  GDALDatasetH from = GDALDataset::ToHandle(height.view.get());
  int usage_error = 0;
  GDALDatasetH done =
      GDALWarp(nullptr, GDALDataset::ToHandle(grid.get()), 1, &from, parsed.get(), &usage_error);
  if (done == nullptr) throw InputError(file, "", "", "cannot be read: " + gdal.complaint());
  grid->FlushCache(false);
  return numbers;
}

struct NodeOfField {
  Eigen::Vector2d p_W;
  bool in_raster = false;
};

// Refuses the raster when nodes of the field have no height.
void require_cover(const std::vector<NodeOfField>& unknown, bool any_known, const Field& field,
                   double cell_m, const std::string& file) {
  const double node_m2 = cell_m * cell_m;
  const auto outside = std::ranges::count(unknown, false, &NodeOfField::in_raster);
  const bool elsewhere = !any_known && outside == std::ssize(unknown);
  if (elsewhere || outside > 0) {
    const double counted = static_cast<double>(outside) * node_m2 / field_area_m2(field);
    const double percent = elsewhere ? 100.0 : std::min(100.0, 100.0 * counted);
    throw InputError(file, "", "",
                     fmt::format("does not cover the field: {:.3g} % of it is missing", percent));
  }
  if (unknown.empty()) return;
  Eigen::Vector2d mean_W = Eigen::Vector2d::Zero();
  for (const NodeOfField& node : unknown) mean_W += node.p_W / static_cast<double>(unknown.size());
  const auto middle = std::ranges::min_element(
      unknown, {}, [&](const NodeOfField& node) { return (node.p_W - mean_W).squaredNorm(); });
  throw InputError(file, "", "",
                   fmt::format("has no data over {:.4g} m2 of the field, around {}; fill it first",
                               static_cast<double>(unknown.size()) * node_m2,
                               place_text(field.frame, middle->p_W)));
}

}  // namespace

double native_cell_m(const std::filesystem::path& file, const std::string& crs,
                     const Field& field) {
  const GdalScope gdal;
  const HeightBand height = open_raster(file, crs, field, gdal);
  Eigen::AlignedBox2d box_W;
  for (const Eigen::Vector2d& p_W : field.boundary) box_W.extend(p_W);
  const Eigen::Vector2d middle_W = box_W.center();
  const std::vector<Eigen::Vector2d> pixels = pixels_from_local(
      height, field,
      {middle_W, middle_W + Eigen::Vector2d::UnitX(), middle_W + Eigen::Vector2d::UnitY()});
  Eigen::Matrix2d pixels_per_m;
  pixels_per_m << pixels[1] - pixels[0], pixels[2] - pixels[0];
  const double cell_m = 1.0 / std::sqrt(std::abs(pixels_per_m.determinant()));
  if (!std::isfinite(cell_m)) {
    throw InputError(file.string(), "", "", "does not cover the field: 100 % of it is missing");
  }
  return cell_m;
}

void read_raster(const std::filesystem::path& path, const std::string& crs, const Field& field,
                 Heightfield& terrain) {
  const std::string file = path.string();
  const GdalScope gdal;
  const HeightBand height = open_raster(path, crs, field, gdal);
  const auto smooth = warped<double>(height, field, terrain, "cubicspline", file, gdal);
  // Splines reach into nodata and past the edge; the nearest pixel says where there is data.
  const auto nearest = warped<float>(height, field, terrain, "near", file, gdal);

  std::vector<unsigned char> known(smooth.size(), 0);
  std::vector<Eigen::Vector2d> unknown_W;
  terrain.height_m.assign(smooth.size(), 0.0);
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const auto from = static_cast<std::size_t>(terrain.rows - 1 - j) *
                            static_cast<std::size_t>(terrain.columns) +
                        static_cast<std::size_t>(i);
      const auto to = static_cast<std::size_t>(j) * static_cast<std::size_t>(terrain.columns) +
                      static_cast<std::size_t>(i);
      const Eigen::Vector2d p_W = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j);
      if (!std::isfinite(smooth[from]) || !std::isfinite(nearest[from])) {
        if (inside_field(field, p_W)) unknown_W.push_back(p_W);
        continue;
      }
      const double pixel_m = height.scale * static_cast<double>(nearest[from]) + height.offset_m;
      if (pixel_m < kLowestHeight_m || pixel_m > kHighestHeight_m) {
        throw InputError(file, "", fmt::format("{:g}", nearest[from]),
                         "not a height in metres at " + place_text(field.frame, p_W) +
                             "; if it stands for no data, the file must declare it");
      }
      known[to] = 1;
      terrain.height_m[to] = height.scale * smooth[from] + height.offset_m;
    }
  }
  const std::vector<Eigen::Vector2d> pixels = pixels_from_local(height, field, unknown_W);
  std::vector<NodeOfField> unknown;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool in_raster = pixels[i].x() >= 0.0 && pixels[i].y() >= 0.0 &&
                           pixels[i].x() <= height.view->GetRasterXSize() &&
                           pixels[i].y() <= height.view->GetRasterYSize();
    unknown.push_back({unknown_W[i], in_raster});
  }
  const bool any_known = std::ranges::find(known, 1) != known.end();
  require_cover(unknown, any_known, field, terrain.cell_m, file);
  carry_heights_outwards(known, terrain);
}

}  // namespace headland
