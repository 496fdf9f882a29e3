#include "terrains/obstacle_features.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "terrains/input_error.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

bool is_set(const OGRFeature& feature, const char* name) {
  const int index = feature.GetFieldIndex(name);
  return index >= 0 && feature.IsFieldSetAndNotNull(index) != 0;
}

std::string text_of(const OGRFeature& feature, const char* name) {
  // GDAL's reading calls are not const-correct.
  return const_cast<OGRFeature&>(feature).GetFieldAsString(feature.GetFieldIndex(name));
}

// A feature on its way to being obstacles.
struct GivenFeature {
  const OGRFeature& feature;
  std::string file;
  std::string where;

  double size_m(const char* name, double otherwise_m, double least_m, double most_m) const {
    if (!is_set(feature, name)) return otherwise_m;
    const std::string text = text_of(feature, name);
    char* end = nullptr;
    const double value_m = CPLStrtod(text.c_str(), &end);
    if (*end == '\0' && value_m >= least_m && value_m <= most_m) return value_m;
    throw InputError(file, where + ": " + name, text,
                     fmt::format("a number from {} to {} m", least_m, most_m));
  }
};

ObstacleKind kind_of(const GivenFeature& given) {
  const std::string name = text_of(given.feature, "obstacle");
  std::vector<std::string> known;
  for (const ObstacleKind kind : kEveryObstacleKind) {
    if (obstacle_kind_name(kind) == name) return kind;
    known.emplace_back(obstacle_kind_name(kind));
  }
  throw InputError(given.file, given.where + ": obstacle", name,
                   fmt::format("unknown obstacle; did you mean '{}'? (known: {})",
                               nearest_name(name, known), fmt::join(known, ", ")));
}

// The lines, or points as lines of one, that a geometry consists of.
void append_lines(const OGRGeometry& geometry, const GivenFeature& given,
                  std::vector<std::vector<Eigen::Vector2d>>& lines) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (geometry.IsEmpty()) {
    throw InputError(given.file, given.where, geometry.getGeometryName(),
                     "a part of its geometry is empty");
  }
  if (type == wkbPoint) {
    const OGRPoint& point = *geometry.toPoint();
    lines.push_back({{point.getX(), point.getY()}});
  } else if (type == wkbLineString) {
    std::vector<Eigen::Vector2d>& line = lines.emplace_back();
    for (const OGRPoint& point : *geometry.toLineString()) {
      line.emplace_back(point.getX(), point.getY());
    }
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      append_lines(*part, given, lines);
    }
  } else {
    throw InputError(given.file, given.where, geometry.getGeometryName(),
                     "an obstacle is a point or a line; what covers an area is a hole in the "
                     "field's polygon");
  }
}

// A surveyed line with points every few centimetres would be thousands of obstacles: bends of less
// than this are left out (Douglas and Peucker).
constexpr double kSmallBend_m = 0.01;

std::vector<Eigen::Vector2d> without_small_bends(const std::vector<Eigen::Vector2d>& line) {
  OGRLineString given;
  for (const Eigen::Vector2d& p : line) given.addPoint(p.x(), p.y());
  const std::unique_ptr<OGRGeometry> simple(given.Simplify(kSmallBend_m));
  if (simple == nullptr || simple->IsEmpty()) return line;
  std::vector<Eigen::Vector2d> result;
  for (const OGRPoint& p : *simple->toLineString()) result.emplace_back(p.getX(), p.getY());
  return result;
}

}  // namespace

ObstacleSource default_obstacle(ObstacleKind kind) {
  constexpr double kHalfThickness_m = 0.1;
  constexpr double kWallHeight_m = 1.5;
  if (runs_along_line(kind)) return {kind, {}, kHalfThickness_m, kWallHeight_m};
  return {kind, {}};
}

bool is_obstacle(const OGRFeature& feature) { return is_set(feature, "obstacle"); }

void add_obstacle(const ObstacleSource& obstacle, const std::string& source,
                  const std::string& where, Field& field) {
  const std::string kind(obstacle_kind_name(obstacle.kind));
  if (!runs_along_line(obstacle.kind)) {
    if (obstacle.line.size() != 1) {
      throw InputError(source, where, kind, "stands at a point; walls and fences run along lines");
    }
    field.obstacles.push_back(
        {obstacle.kind, obstacle.line.front(), obstacle.radius_m, obstacle.height_m});
    check_obstacle(field, field.obstacles.back(), source, where);
    return;
  }
  const std::size_t before = field.obstacles.size();
  const std::vector<Eigen::Vector2d> line = without_small_bends(obstacle.line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d run_W = line[i] - line[i - 1];
    if (run_W.norm() <= kSamePlace_m) continue;
    field.obstacles.push_back(
        {obstacle.kind, line[i - 1], obstacle.radius_m, obstacle.height_m, run_W});
    check_obstacle(field, field.obstacles.back(), source, where);
  }
  if (field.obstacles.size() == before) {
    throw InputError(source, where, kind, "runs along a line of at least two different points");
  }
}

void add_obstacle_features(GDALDataset& dataset, const FieldSource& source, Field& field) {
  const std::string file = source.file.string();
  for (OGRLayer* layer : dataset.GetLayers()) {
    const std::string crs = source.crs.empty() ? crs_of(*layer) : source.crs;
    int number = 0;
    for (const auto& feature : *layer) {
      const GivenFeature given{*feature, file, fmt::format("feature {}", ++number)};
      const OGRGeometry* geometry = feature->GetGeometryRef();
      if (!is_obstacle(*feature)) continue;
      ObstacleSource obstacle = default_obstacle(kind_of(given));
      if (geometry == nullptr || geometry->IsEmpty()) {
        throw InputError(file, given.where, std::string(obstacle_kind_name(obstacle.kind)),
                         "has no geometry that says where it is");
      }
      if (runs_along_line(obstacle.kind)) {
        obstacle.radius_m = 0.5 * given.size_m("thickness_m", 2.0 * obstacle.radius_m,
                                               kMinThickness_m, kMaxThickness_m);
      } else {
        obstacle.radius_m =
            given.size_m("radius_m", obstacle.radius_m, kMinObstacle_m, kMaxObstacleRadius_m);
      }
      obstacle.height_m =
          given.size_m("height_m", obstacle.height_m, kMinObstacle_m, kMaxObstacleHeight_m);
      // Arcs of curved lines become short chords.
      const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
      std::vector<std::vector<Eigen::Vector2d>> lines;
      append_lines(*linear, given, lines);
      for (std::vector<Eigen::Vector2d>& line : lines) {
        obstacle.line = field.frame.georeferenced
                            ? local_from_wgs84(field.frame,
                                               wgs84_from_crs(crs, line, file + ": " + given.where))
                            : line;
        add_obstacle(obstacle, file, given.where, field);
      }
    }
  }
}

}  // namespace headland
