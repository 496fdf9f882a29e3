#include "terrains/soil_raster.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "terrains/input_error.h"
#include "terrains/raster_band.h"

namespace headland {
namespace {

constexpr RasterUse kConeIndices{"cone indices", "soil.crs"};

double kpa_per_unit(const RasterBand& band, const std::string& file) {
  if (band.unit.empty() || EQUAL(band.unit.c_str(), "kPa")) return 1.0;
  if (EQUAL(band.unit.c_str(), "MPa")) return 1000.0;
  throw InputError(file, "unit of the cone indices", band.unit, "kPa or MPa");
}

}  // namespace

double soil_raster_cell_m(const SoilSource& source, const Field& field) {
  const GdalScope gdal;
  return native_cell_m(open_raster_band(source.file, source.crs, kConeIndices, field, gdal), field);
}

void read_soil_raster(const SoilSource& source, const Field& field,
                      const std::vector<std::uint16_t>& in_field, SoilMap& map) {
  const std::string file = source.file.string();
  const GdalScope gdal;
  const RasterBand band = open_raster_band(source.file, source.crs, kConeIndices, field, gdal);
  const double unit_kpa = kpa_per_unit(band, file);
  const RasterGrid middles{map.origin_W + Eigen::Vector2d::Constant(0.5 * map.cell_m), map.cell_m,
                           map.columns, map.rows};
  const bool finer = native_cell_m(band, field) < map.cell_m;
  const auto numbers = warped<float>(band, field, middles, finer ? "average" : "near", gdal);

  std::map<double, std::uint16_t> known;
  for (int j = 0; j < map.rows; ++j) {
    for (int i = 0; i < map.columns; ++i) {
      const auto columns = static_cast<std::size_t>(map.columns);
      const auto from =
          static_cast<std::size_t>(map.rows - 1 - j) * columns + static_cast<std::size_t>(i);
      const auto to = static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i);
      if (!std::isfinite(numbers[from])) continue;
      const double cone_index_kpa =
          unit_kpa * (band.scale * static_cast<double>(numbers[from]) + band.offset);
      if (!(cone_index_kpa >= kMinConeIndex_kpa && cone_index_kpa <= kMaxConeIndex_kpa)) {
        if (in_field[to] == 0) continue;
        throw InputError(
            file, "", fmt::format("{:g}", numbers[from]),
            fmt::format(
                "not a cone index from {} to {} kPa, at {}; if it stands for "
                "no data, the file must declare it",
                kMinConeIndex_kpa, kMaxConeIndex_kpa,
                place_text(field.frame, middles.first_W + map.cell_m * Eigen::Vector2d(i, j))));
      }
      // At most kMaxConeIndex_kpa of them: their numbers fit the index.
      const double rounded_kpa = std::round(cone_index_kpa);
      const auto [place, added] =
          known.try_emplace(rounded_kpa, static_cast<std::uint16_t>(map.soils.size()));
      if (added) map.soils.push_back(soil_of_cone_index(rounded_kpa));
      map.index[to] = place->second;
    }
  }
}

}  // namespace headland
