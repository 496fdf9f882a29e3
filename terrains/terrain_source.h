// Where a terrain comes from: a raster or a named generator with a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "terrains/parameter.h"

namespace headland {

// Roughness added to any terrain: a Gaussian random surface of the stated rms height and
// correlation length. 0 rms: none.
struct MicroRelief {
  double rms_m = 0.0;
  double correlation_m = 1.0;
};

struct TerrainSource {
  std::filesystem::path file;  // raster; empty: generator
  std::string crs;             // of a raster without one; empty: the raster's own
  std::string generator = "flat";
  Parameters parameters;   // of the generator, resolved
  double cell_m = 0.0;     // 0: min(1 m, a raster's own, half the micro-relief's correlation)
  double margin_m = 30.0;  // terrain needed around the field; see read_terrain
  MicroRelief micro_relief;
  std::uint64_t seed = 1;
};

using HeightFunction = double (*)(double x_m, double y_m, const Parameters&, std::uint64_t seed);

// Generators give a height at p_W relative to the middle of the field's bounding box.
struct GeneratorEntry {
  std::string_view name;
  std::string_view what;
  HeightFunction height_m;
  std::span<const ParameterSpec> parameters;
};

std::span<const GeneratorEntry> generators();

// The terrain over the field's bounding box plus margin, in W. A raster in any CRS is warped into
// W with cubic splines; the margin may lie outside a raster or in nodata (the nearest heights are
// carried outwards), the field itself may not. A field without a place on the earth takes only a
// raster without a CRS, whose coordinates then are those of W. Throws InputError: missing or
// unreadable file, raster without CRS, not covering the field (percentage missing), nodata inside
// the field (area, place), too large for memory (needed and allowed), cell, margin or roughness
// out of range, unknown generator (nearest name).
Heightfield read_terrain(const TerrainSource& terrain, const Field& field,
                         const std::string& source);

inline constexpr double kMaxTerrainBytes = 2e9;
inline constexpr double kMinCell_m = 0.01;
inline constexpr double kMaxCell_m = 100.0;
inline constexpr double kMinMargin_m = 1.0;
inline constexpr double kMaxMargin_m = 1000.0;
inline constexpr double kMaxRoughness_m = 0.5;  // rms of micro-relief
inline constexpr double kMinCorrelation_m = 0.05;
inline constexpr double kMaxCorrelation_m = 100.0;

}  // namespace headland
