#include "terrains/raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/nearest_heights.h"
#include "terrains/raster_band.h"

namespace headland {
namespace {

constexpr RasterUse kHeights{"heights", "terrain.crs"};

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
  return native_cell_m(open_raster_band(file, crs, kHeights, field, gdal), field);
}

void read_raster(const std::filesystem::path& path, const std::string& crs, const Field& field,
                 Heightfield& terrain) {
  const std::string file = path.string();
  const GdalScope gdal;
  const RasterBand band = open_raster_band(path, crs, kHeights, field, gdal);
  const double unit_m = metres_per_unit(band.unit, band.file->GetSpatialRef(), file);
  const double scale_m = band.scale * unit_m;
  const double offset_m = band.offset * unit_m;
  const RasterGrid nodes{terrain.origin_W, terrain.cell_m, terrain.columns, terrain.rows};
  const auto smooth = warped<double>(band, field, nodes, "cubicspline", gdal);
  // Splines reach into nodata and past the edge; the nearest pixel says where there is data.
  const auto nearest = warped<float>(band, field, nodes, "near", gdal);

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
      const double pixel_m = scale_m * static_cast<double>(nearest[from]) + offset_m;
      if (pixel_m < kLowestHeight_m || pixel_m > kHighestHeight_m) {
        throw InputError(file, "", fmt::format("{:g}", nearest[from]),
                         "not a height in metres at " + place_text(field.frame, p_W) +
                             "; if it stands for no data, the file must declare it");
      }
      known[to] = 1;
      terrain.height_m[to] = scale_m * smooth[from] + offset_m;
    }
  }
  const std::vector<Eigen::Vector2d> pixels = pixels_from_local(band, field, unknown_W);
  std::vector<NodeOfField> unknown;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool in_raster = pixels[i].x() >= 0.0 && pixels[i].y() >= 0.0 &&
                           pixels[i].x() <= band.view->GetRasterXSize() &&
                           pixels[i].y() <= band.view->GetRasterYSize();
    unknown.push_back({unknown_W[i], in_raster});
  }
  const bool any_known = std::ranges::find(known, 1) != known.end();
  require_cover(unknown, any_known, field, terrain.cell_m, file);
  carry_heights_outwards(known, terrain);
}

}  // namespace headland
