// Where the soil comes from: one for the whole field, zones in a vector file, or a raster of cone
// indices.
#pragma once

#include <filesystem>
#include <string>

#include "terrains/field.h"
#include "terrains/soil_map.h"

namespace headland {

// As a scenario gives it.
struct SoilSource {
  Soil soil = *find_soil("firm");  // everywhere, or where the file says nothing
  std::filesystem::path file;      // vector or raster; empty: one soil
  std::string layer;               // of a vector file; empty: the only or first with polygons
  std::string crs;                 // of the file; empty: its own
  double cell_m = 0.0;             // of the map; 0: 1 m, or a finer raster's own
};

struct SoilReading {
  SoilMap map;
  double default_ratio = 0.0;  // part of the field's area where the file says nothing
};

// The soil over the field's bounding box and kSoilMargin_m around it, in W.
// Vector files (anything GDAL reads): polygons whose property `soil` names a known soil or whose
// property `cone_index_kpa` (`cone_index` where names are short) gives a number; each cell takes
// the zone its middle lies in, the last one in the file where zones overlap. Raster files: the
// first band is cone index in kPa (or MPa, if its unit says so), rounded to 1 kPa. Files say
// nothing of texture: all have that of `soil`. Throws InputError: missing or unreadable file; no
// CRS while the field has one, or the other way round; a zone without soil, with two, or with an
// unknown one (nearest name); a cone index out of range (place); a file that says nothing about the
// field; a map too large for memory.
SoilReading read_soil(const SoilSource& soil, const Field& field, const std::string& source);

// "firm", "cone index 900 kPa", "zones.geojson".
std::string soil_text(const SoilSource& soil);

inline constexpr double kDefaultSoilCell_m = 1.0;
inline constexpr double kMinSoilCell_m = 0.05;
inline constexpr double kMaxSoilCell_m = 100.0;
inline constexpr double kSoilMargin_m = 10.0;
inline constexpr double kMaxSoilCells = 5e7;

}  // namespace headland
