// The local metric frame W and its place on the earth.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace headland {

// World frame W: x east, y north, z up, metres. When georeferenced, W is the transverse Mercator
// projection (WGS 84, scale 1 on the central meridian) whose origin is at the latitude and
// longitude below; the scale error is under 1e-7 within 2 km of the origin.
struct GeoFrame {
  bool georeferenced = false;
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

// Whether GDAL understands it: "EPSG:32615", WKT, PROJ.
bool is_known_crs(const std::string& crs);

// PROJ string of the frame, for GDAL. Asserts that it is georeferenced.
std::string proj_of(const GeoFrame& frame);

// Points (longitude, latitude) in degrees WGS 84 to p_W in metres and back, in the order given.
std::vector<Eigen::Vector2d> local_from_wgs84(const GeoFrame& frame,
                                              const std::vector<Eigen::Vector2d>& lon_lat_deg);
std::vector<Eigen::Vector2d> wgs84_from_local(const GeoFrame& frame,
                                              const std::vector<Eigen::Vector2d>& p_W);

// Points in any CRS that GDAL understands ("EPSG:32615", WKT, PROJ), x east or longitude first,
// to (longitude, latitude) in degrees. Throws InputError naming `source` for an unknown CRS or
// points outside its domain.
std::vector<Eigen::Vector2d> wgs84_from_crs(const std::string& crs,
                                            const std::vector<Eigen::Vector2d>& points,
                                            const std::string& source);

// p_W as a person finds it on the map: "lon -93.9784060, lat 43.9210276", or "x 1.000 m, y 2.000 m"
// when the frame has no place on the earth. For messages.
std::string place_text(const GeoFrame& frame, const Eigen::Vector2d& p_W);

}  // namespace headland
