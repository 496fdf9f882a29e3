#include "terrains/soil_source.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/soil_raster.h"
#include "terrains/soil_zones.h"

namespace headland {
namespace {

bool holds_raster(const std::filesystem::path& file) {
  require_file_or_folder(file);
  const GdalScope gdal;
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VECTOR | GDAL_OF_READONLY));
  const std::string extension = file.extension().string();
  // A broken GeoJSON is left to the reader of zones, which finds the line.
  if (dataset == nullptr && extension != ".geojson" && extension != ".json") {
    throw InputError(file.string(), "", "",
                     "neither a raster nor a vector file that GDAL reads" +
                         (gdal.complaint().empty() ? "" : ": " + gdal.complaint()));
  }
  return dataset != nullptr && dataset->GetRasterCount() > 0;
}

void lay_grid(const Field& field, double cell_m, const std::string& source, SoilMap& map) {
  Eigen::AlignedBox2d box_W;
  for (const Eigen::Vector2d& p_W : field.boundary) box_W.extend(p_W);
  const Eigen::Array2d first = ((box_W.min().array() - kSoilMargin_m) / cell_m).floor();
  const Eigen::Array2d last = ((box_W.max().array() + kSoilMargin_m) / cell_m).ceil();
  const Eigen::Array2d cells = last - first;
  if (cells.prod() > kMaxSoilCells) {
    throw InputError(source, "soil.cell_m", fmt::format("{:g}", cell_m),
                     fmt::format("{:.0f} x {:.0f} cells are too many; at least {:.2g} m for this "
                                 "field",
                                 cells.x(), cells.y(),
                                 // Rounded up to the two digits printed.
                                 1.05 * cell_m * std::sqrt(cells.prod() / kMaxSoilCells)));
  }
  map.origin_W = (first * cell_m).matrix();
  map.cell_m = cell_m;
  map.columns = static_cast<int>(cells.x());
  map.rows = static_cast<int>(cells.y());
  map.index.assign(static_cast<std::size_t>(cells.prod()), 0);
}

}  // namespace

SoilReading read_soil(const SoilSource& soil, const Field& field, const std::string& source) {
  SoilReading reading{uniform_soil(soil.soil), 0.0};
  if (soil.file.empty()) return reading;
  SoilMap& map = reading.map;
  const bool raster = holds_raster(soil.file);
  if (raster && !soil.layer.empty()) {
    throw InputError(source, "soil.layer", soil.layer,
                     "only of vector files; " + soil.file.filename().string() + " is a raster");
  }
  double cell_m = soil.cell_m;
  if (cell_m == 0.0) {
    cell_m = raster
                 ? std::clamp(soil_raster_cell_m(soil, field), kMinSoilCell_m, kDefaultSoilCell_m)
                 : kDefaultSoilCell_m;
  }
  lay_grid(field, cell_m, source, map);
  const std::vector<std::uint16_t> in_field = cells_in_field(map, field);
  if (raster) {
    read_soil_raster(soil, field, in_field, map);
  } else {
    read_soil_zones(soil, field, map);
  }
  for (Soil& read : map.soils) read.texture = soil.soil.texture;
  long cells = 0;
  long by_default = 0;
  for (std::size_t i = 0; i < in_field.size(); ++i) {
    cells += in_field[i];
    if (in_field[i] == 1 && map.index[i] == 0) ++by_default;
  }
  if (cells > 0 && by_default == cells) {
    throw InputError(soil.file.string(), "", "",
                     "says nothing about the soil of the field: it lies elsewhere");
  }
  if (cells > 0) {
    reading.default_ratio = static_cast<double>(by_default) / static_cast<double>(cells);
  }
  return reading;
}

std::string soil_text(const SoilSource& soil) {
  return soil.file.empty() ? soil.soil.name : soil.file.filename().string();
}

}  // namespace headland
