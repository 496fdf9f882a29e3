#include "terrains/geo_frame.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <cassert>
#include <cmath>
#include <memory>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr const char* kWgs84 = "EPSG:4326";

struct Transformed {
  std::vector<Eigen::Vector2d> points;
  std::vector<int> succeeded;  // 0 or 1 a point
};

Transformed transformed(const OGRSpatialReference& from, const OGRSpatialReference& to,
                        const std::vector<Eigen::Vector2d>& points) {
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&from, &to));
  Transformed result{points, std::vector<int>(points.size(), 0)};
  if (transformation == nullptr || points.empty()) return result;
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    x[i] = points[i].x();
    y[i] = points[i].y();
  }
  transformation->Transform(static_cast<int>(points.size()), x.data(), y.data(), nullptr,
                            result.succeeded.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.points[i] = {x[i], y[i]};
    if (!result.points[i].allFinite()) result.succeeded[i] = 0;
  }
  return result;
}

}  // namespace

bool is_known_crs(const std::string& crs) {
  try {
    spatial_reference(crs, "");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string proj_of(const GeoFrame& frame) {
  assert(frame.georeferenced);
  return fmt::format(
      "+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
      frame.latitude_deg, frame.longitude_deg);
}

std::vector<Eigen::Vector2d> local_from_wgs84(const GeoFrame& frame,
                                              const std::vector<Eigen::Vector2d>& lon_lat_deg) {
  const GdalScope gdal;
  return transformed(spatial_reference(kWgs84, ""), spatial_reference(proj_of(frame), ""),
                     lon_lat_deg)
      .points;
}

std::vector<Eigen::Vector2d> wgs84_from_local(const GeoFrame& frame,
                                              const std::vector<Eigen::Vector2d>& p_W) {
  const GdalScope gdal;
  return transformed(spatial_reference(proj_of(frame), ""), spatial_reference(kWgs84, ""), p_W)
      .points;
}

std::vector<Eigen::Vector2d> wgs84_from_crs(const std::string& crs,
                                            const std::vector<Eigen::Vector2d>& points,
                                            const std::string& source) {
  const GdalScope gdal;
  const OGRSpatialReference from = spatial_reference(crs, source);
  const auto refuse = [&](std::size_t i) {
    const std::string where = fmt::format("point {}", i + 1);
    const std::string value = fmt::format("{}, {}", points[i].x(), points[i].y());
    throw InputError(source, where, value,
                     from.IsGeographic()
                         ? "not degrees: longitude -180..180 first, then latitude -90..90; metric "
                           "coordinates need the crs they are in"
                         : "outside the domain of the CRS; easting first, then northing");
  };
  if (from.IsGeographic()) {
    // A transformation from geographic to geographic lets any number through.
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!(std::abs(points[i].x()) <= 180.0 && std::abs(points[i].y()) <= 90.0)) refuse(i);
    }
  }
  Transformed result = transformed(from, spatial_reference(kWgs84, ""), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (result.succeeded[i] == 0) refuse(i);
  }
  return std::move(result.points);
}

std::string place_text(const GeoFrame& frame, const Eigen::Vector2d& p_W) {
  if (!frame.georeferenced) return fmt::format("x {:.3f} m, y {:.3f} m", p_W.x(), p_W.y());
  const Eigen::Vector2d lon_lat_deg = wgs84_from_local(frame, {p_W}).front();
  return fmt::format("lon {:.7f}, lat {:.7f}", lon_lat_deg.x(), lon_lat_deg.y());
}

}  // namespace headland
