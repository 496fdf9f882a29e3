// Heights from a raster file, brought onto a grid in W.
#pragma once

#include <filesystem>
#include <string>

#include "terrains/field.h"
#include "terrains/heightfield.h"

namespace headland {

// Side of a raster's pixel [m] at the middle of the field. crs as in TerrainSource. Throws
// InputError for a file that is missing, unreadable or no raster, and for a raster that cannot be
// placed: no geotransform, no CRS while the field has one, or the other way round.
double native_cell_m(const std::filesystem::path& file, const std::string& crs, const Field& field);

// Fills `terrain.height_m`, whose grid is given, with the first band of the raster warped into W
// by cubic splines. The band's unit (feet or metres), scale and offset are honoured; heights are
// otherwise used as they are, whatever their vertical datum. Nodes outside the field may lie
// outside the raster or in nodata: they take the nearest node's height. Throws InputError as
// above; nodes in the field outside the raster (percentage) or in nodata (area, place); heights
// outside [kLowestHeight_m, kHighestHeight_m], which are undeclared nodata.
void read_raster(const std::filesystem::path& file, const std::string& crs, const Field& field,
                 Heightfield& terrain);

inline constexpr double kLowestHeight_m = -500.0;
inline constexpr double kHighestHeight_m = 9000.0;

}  // namespace headland
