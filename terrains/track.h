// A track driven or planned by another tool.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "terrains/geo_frame.h"

namespace headland {

// Points p_W [m] in the order driven; the implement works along them. `break_before` holds,
// ascending, the indices of points that are not joined to their predecessor: gaps in a log.
struct Track {
  std::vector<Eigen::Vector2d> points_W;
  std::vector<std::size_t> break_before;
};

// Reads a GeoJSON LineString / MultiLineString (or any vector file GDAL reads), or a CSV whose
// header names x and y in metres of W (x, x_m, easting...; y, ...) or longitude and latitude (lon,
// lon_deg, longitude, lng...; lat...). Optional CSV columns: a time in seconds or as ISO 8601 (a
// step of more than kLogGapFactor times the median interval, forwards or back, is a break) and an
// implement state (0/1; points with 0 are left out and break the track). Throws InputError with the
// line: missing file, no usable header, a field that is not a number, fewer than two points, points
// in degrees while `frame` is not georeferenced, a jump of more than kMaxJump_m between neighbours
// (names both lines). Neighbours at the same place are merged, and a point alone between two breaks
// is left out. For a field with no place on the earth, GeoJSON coordinates are taken as metres of
// W.
Track read_track(const std::filesystem::path& file, const GeoFrame& frame);

inline constexpr double kLogGapFactor = 3.0;
inline constexpr double kMaxJump_m = 2000.0;

}  // namespace headland
