#include "terrains/field_source.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>

#include "terrains/field_outline.h"
#include "terrains/gdal_scope.h"
#include "terrains/given_polygon.h"
#include "terrains/grid_field.h"
#include "terrains/grid_map_file.h"
#include "terrains/input_error.h"
#include "terrains/obstacle_features.h"
#include "terrains/task_data.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

void require_finite_point(const Eigen::Vector2d& point, const std::string& source,
                          const std::string& where) {
  if (!point.allFinite()) {
    throw InputError(source, where, fmt::format("{}, {}", point.x(), point.y()),
                     "not a finite coordinate");
  }
}

Field read_grid_field(const FieldSource& given, const std::string& source) {
  Field field = field_of_grid(read_grid_map(given.grid_map, given.cell_m), given.margin_m, source);
  field.name = given.grid_map.stem().string();
  field.entry_W = given.entry;
  check_field(field, given.grid_map.string());
  check_entry(field, source, given.entry_place);
  return field;
}

// A whole country's degrees are no field in metres either.
void refuse_degrees(const Field& field, const std::string& source) {
  if (field.frame.georeferenced) return;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : field.boundary) box.extend(p_W);
  const double extent_m = box.sizes().maxCoeff();
  if (extent_m >= kLeastPlainExtent_m) return;
  throw InputError(source, "boundary", fmt::format("{:.3g} m across", extent_m),
                   fmt::format("too small for a field (at least {} m); coordinates in degrees need "
                               "crs: EPSG:4326",
                               kLeastPlainExtent_m));
}

// Of outlines of which too many points are left otherwise; see simplify_outline_inside.
constexpr std::array<double, 3> kRoughOutlines_m = {0.01, 0.02, 0.05};

// A ring's points that it keeps its shape without are left out; of rough rings with more than can
// be planned by, roughness too.
void simplify(Field& field, std::vector<std::string>* notes) {
  const auto points_of_rings = [&field] {
    std::size_t count = field.boundary.size();
    for (const Ring& hole : field.holes) count += hole.size();
    return count;
  };
  const std::size_t before = points_of_rings();
  if (before <= kManyPoints) return;
  const Field given = field;
  simplify_outline(field, kOutlineRounding_m);
  std::string how = fmt::format("{:g} mm", 1e3 * kOutlineRounding_m);
  for (const double tolerance_m : kRoughOutlines_m) {
    if (points_of_rings() <= kManyPoints) break;
    Field inside = given;
    if (!simplify_outline_inside(inside, tolerance_m)) break;
    field = std::move(inside);
    how = fmt::format("{:g} mm, inside it", 2e3 * tolerance_m);
  }
  if (notes == nullptr) return;
  notes->push_back(fmt::format("field: {} points of its outlines simplified to {} within {}",
                               before, points_of_rings(), how));
}

GivenPolygon given_polygon(const FieldSource& given, const std::string& source,
                           GDALDatasetUniquePtr& dataset) {
  if (given.file.empty()) {
    GivenPolygon polygon;
    polygon.name = std::filesystem::path(source).stem().string();
    polygon.crs = given.crs;
    polygon.boundary = given.boundary;
    polygon.holes = given.holes;
    return polygon;
  }
  if (is_task_data(given.file)) return chosen_polygon(polygons_of_task_data(given.file), given);
  dataset = open_vector_file(given.file);
  return chosen_polygon(polygons_of(*dataset, given), given);
}

}  // namespace

Field read_field(const FieldSource& given, const std::string& source,
                 std::vector<std::string>* notes) {
  if (!given.grid_map.empty()) return read_grid_field(given, source);
  const bool from_file = !given.file.empty();
  const std::string geometry_source = from_file ? given.file.string() : source;
  const GdalScope gdal;
  GDALDatasetUniquePtr dataset;
  const GivenPolygon polygon = given_polygon(given, source, dataset);
  if (polygon.boundary.empty()) {
    throw InputError(geometry_source, "boundary", "", "is empty; give at least three points");
  }
  for (std::size_t i = 0; i < polygon.boundary.size(); ++i) {
    require_finite_point(polygon.boundary[i], geometry_source,
                         fmt::format("boundary point {}", i + 1));
  }
  Field field = placed(polygon, geometry_source, given.frame);
  refuse_degrees(field, geometry_source);

  const std::string point_crs = given.crs.empty() && from_file ? "EPSG:4326" : given.crs;
  const auto local = [&](const Eigen::Vector2d& point, const std::string& crs,
                         const std::string& where) {
    require_finite_point(point, source, where);
    if (!field.frame.georeferenced) return point;
    return local_from_wgs84(field.frame, wgs84_from_crs(crs, {point}, source + ": " + where))
        .front();
  };
  if (given.entry.has_value()) field.entry_W = local(*given.entry, point_crs, given.entry_place);
  for (const Ring& ring : given.to_work) {
    field.to_work.push_back(
        field.frame.georeferenced
            ? local_from_wgs84(field.frame, wgs84_from_crs(point_crs, ring, source + ": to_work"))
            : ring);
  }
  check_field(field, geometry_source);
  check_to_work(field, geometry_source);
  check_entry(field, source, given.entry_place);
  simplify(field, notes);
  const auto add = [&](const std::vector<ObstacleSource>& obstacles, const std::string& crs,
                       const std::string& where_from) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      ObstacleSource obstacle = obstacles[i];
      const std::string where = fmt::format("{}[{}]", obstacle.place, i);
      for (Eigen::Vector2d& point : obstacle.line) point = local(point, crs, where);
      add_obstacle(obstacle, where_from, where, field);
    }
  };
  add(polygon.obstacles, polygon.crs, geometry_source);
  add(given.obstacles, point_crs, source);
  if (dataset != nullptr) add_obstacle_features(*dataset, given, field);
  return field;
}

}  // namespace headland
