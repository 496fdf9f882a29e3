#include "evaluate/path_csv.h"

#include <fmt/format.h>

#include "evaluate/geojson.h"
#include "sim/route.h"

namespace headland {
namespace {

constexpr int kMetreDecimals = 6;
constexpr int kDegreeDecimals = 10;
constexpr int kAngleDecimals = 9;
constexpr int kSpeedDecimals = 3;

// Limits of the route at the path's points, which are its own but for repeated ones.
std::vector<double> speeds_mps(const Path& path, const Vehicle& vehicle) {
  const Route route = make_route(path, vehicle);
  std::vector<double> speeds;
  std::size_t at = 0;
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      std::size_t next = at;
      while (next < route.points.size() && route.points[next].p_W != point.p_W) ++next;
      if (next < route.points.size()) at = next;
      speeds.push_back(route.points[at].speed_limit_mps);
    }
  }
  return speeds;
}

}  // namespace

std::string path_csv(const Path& path, const Vehicle& vehicle, const GeoFrame& frame) {
  std::vector<Eigen::Vector2d> lon_lat_deg;
  if (frame.georeferenced) {
    for (const PathSegment& segment : path.segments) {
      for (const PathPoint& point : segment.points) lon_lat_deg.push_back(point.p_W);
    }
    lon_lat_deg = wgs84_from_local(frame, lon_lat_deg);
  }
  const std::vector<double> speeds = speeds_mps(path, vehicle);
  std::string text =
      "x_m,y_m,heading_rad,curvature_per_m,gear,speed_mps,implement,kind,segment,manoeuvre,"
      "reference";
  text += frame.georeferenced ? ",longitude_deg,latitude_deg\n" : "\n";
  std::size_t row = 0;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const PathSegment& segment = path.segments[i];
    for (const PathPoint& point : segment.points) {
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},vehicle", rounded(point.p_W.x(), kMetreDecimals),
          rounded(point.p_W.y(), kMetreDecimals), rounded(point.heading_rad, kAngleDecimals),
          rounded(point.curvature_per_m, kAngleDecimals), gear_name(segment.gear),
          rounded(speeds[row], kSpeedDecimals), segment.implement_down ? "down" : "up",
          path_kind_name(segment.kind), i, segment.manoeuvre);
      if (frame.georeferenced) {
        text += fmt::format(",{},{}", rounded(lon_lat_deg[row].x(), kDegreeDecimals),
                            rounded(lon_lat_deg[row].y(), kDegreeDecimals));
      }
      text += "\n";
      ++row;
    }
  }
  return text;
}

}  // namespace headland
