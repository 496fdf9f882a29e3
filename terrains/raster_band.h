// One band of a raster file, and its numbers brought onto a grid in W.
#pragma once

#include <gdal_priv.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "terrains/field.h"
#include "terrains/gdal_scope.h"

namespace headland {

// What a raster is read for, in the words of its messages.
struct RasterUse {
  std::string_view numbers;  // "heights"
  std::string_view crs_key;  // of the scenario: "terrain.crs"
};

// The first band of a raster with its mask.
struct RasterBand {
  GDALDatasetUniquePtr file;
  GDALDatasetUniquePtr view;  // reads through `file`, so it goes first
  std::string crs;            // given with the file; empty: the file's own or none
  double scale = 1.0;         // quantity = scale * number + offset, in the band's unit
  double offset = 0.0;
  std::string unit;  // empty: not said
};

// Opens a raster and makes sure that it can be placed. A live GdalScope keeps GDAL's messages.
// Throws InputError: missing, unreadable, no raster, a picture, no geotransform, no CRS while the
// field has one or the other way round, unknown `crs`.
RasterBand open_raster_band(const std::filesystem::path& file, const std::string& crs,
                            const RasterUse& use, const Field& field, const GdalScope& gdal);

// Points in a grid in W: column i, row j at first_W + cell_m (i, j).
struct RasterGrid {
  Eigen::Vector2d first_W = Eigen::Vector2d::Zero();
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
};

// The band's numbers at the grid's points, row by row from the NORTH; NaN where there are none.
// `resampling` as GDAL names it: "near", "average", "cubicspline". Float or double.
template <typename Number>
std::vector<Number> warped(const RasterBand& band, const Field& field, const RasterGrid& grid,
                           const char* resampling, const GdalScope& gdal);

// Where points in W lie in the raster, in pixels from its corner; NaN where they cannot.
std::vector<Eigen::Vector2d> pixels_from_local(const RasterBand& band, const Field& field,
                                               const std::vector<Eigen::Vector2d>& p_W);

// Side of the raster's pixel [m] at the middle of the field. Throws InputError when the raster lies
// elsewhere.
double native_cell_m(const RasterBand& band, const Field& field);

}  // namespace headland
