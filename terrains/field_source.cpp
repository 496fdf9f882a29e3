#include "terrains/field_source.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "terrains/gdal_scope.h"
#include "terrains/grid_field.h"
#include "terrains/grid_map_file.h"
#include "terrains/input_error.h"
#include "terrains/obstacle_features.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

constexpr double kOriginStep_deg = 1e-4;

// One polygon as it was given, x,y in `crs`; no crs means metres with no place on the earth.
struct GivenPolygon {
  std::string name;
  std::string crs;
  Ring boundary;
  std::vector<Ring> holes;
};

Ring ring_of(const OGRLinearRing& line) {
  Ring ring;
  for (const OGRPoint& point : line) ring.emplace_back(point.getX(), point.getY());
  return ring;
}

void append_polygons(const OGRGeometry& geometry, const GivenPolygon& like,
                     std::vector<GivenPolygon>& polygons) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    const OGRPolygon& polygon = *geometry.toPolygon();
    GivenPolygon given = like;
    if (const OGRLinearRing* exterior = polygon.getExteriorRing()) {
      given.boundary = ring_of(*exterior);
    }
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
      given.holes.push_back(ring_of(*polygon.getInteriorRing(i)));
    }
    polygons.push_back(std::move(given));
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      append_polygons(*part, like, polygons);
    }
  }
}

std::string feature_name(const OGRFeature& feature, const std::string& otherwise) {
  for (const char* key : {"name", "Name", "NAME"}) {
    const int index = feature.GetFieldIndex(key);
    if (index >= 0 && feature.IsFieldSetAndNotNull(index)) {
      std::string name = feature.GetFieldAsString(index);
      if (!name.empty()) return name;
    }
  }
  return otherwise;
}

std::vector<GivenPolygon> polygons_of(OGRLayer& layer, const std::string& stem) {
  std::vector<GivenPolygon> polygons;
  GivenPolygon like;
  like.crs = crs_of(layer);
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || is_obstacle(*feature)) continue;
    like.name = feature_name(*feature, stem);
    // Arcs of curved polygons become short chords.
    const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
    append_polygons(*linear, like, polygons);
  }
  return polygons;
}

// In W when the polygon has a CRS: its origin is at the middle of the boundary.
Field placed(const GivenPolygon& given, const std::string& source) {
  Field field;
  field.name = given.name;
  field.boundary = given.boundary;
  field.holes = given.holes;
  if (given.crs.empty() || given.boundary.empty()) return field;
  field.boundary = wgs84_from_crs(given.crs, given.boundary, source);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& lon_lat_deg : field.boundary) box.extend(lon_lat_deg);
  field.frame.georeferenced = true;
  // Dividing by a whole number gives the double nearest to the decimal that people will read.
  const auto rounded_deg = [](double angle_deg) {
    return std::round(angle_deg / kOriginStep_deg) / std::round(1.0 / kOriginStep_deg);
  };
  field.frame.longitude_deg = rounded_deg(box.center().x());
  field.frame.latitude_deg = rounded_deg(box.center().y());
  field.boundary = local_from_wgs84(field.frame, field.boundary);
  for (Ring& hole : field.holes) {
    hole = local_from_wgs84(field.frame, wgs84_from_crs(given.crs, hole, source));
  }
  return field;
}

OGRLayer& chosen_layer(GDALDataset& dataset, const FieldSource& field, const std::string& file) {
  std::vector<std::string> names;
  for (OGRLayer* layer : dataset.GetLayers()) names.emplace_back(layer->GetName());
  if (!field.layer.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(field.layer.c_str())) return *layer;
    throw InputError(file, "layer", field.layer,
                     fmt::format("no such layer; it has {}", fmt::join(names, ", ")));
  }
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (!polygons_of(*layer, "").empty()) return *layer;
  }
  throw InputError(file, "", "", "holds no polygon; a field's boundary is a polygon");
}

GivenPolygon only_polygon(const FieldSource& field, GDALDataset& dataset) {
  const std::string file = field.file.string();
  OGRLayer& layer = chosen_layer(dataset, field, file);
  std::vector<GivenPolygon> polygons = polygons_of(layer, field.file.stem().string());
  if (polygons.empty()) {
    throw InputError(file, "layer", layer.GetName(),
                     "holds no polygon; a field's boundary is a polygon");
  }
  for (GivenPolygon& polygon : polygons) {
    if (!field.crs.empty()) polygon.crs = field.crs;
    if (polygon.crs.empty()) {
      throw InputError(file, "", "", "has no CRS; give it as crs, for example EPSG:4326");
    }
  }
  if (polygons.size() == 1) return std::move(polygons.front());
  std::size_t largest = 0;
  double largest_m2 = -1.0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const double area_m2 = field_area_m2(placed(polygons[i], file));
    if (area_m2 > largest_m2) {
      largest = i;
      largest_m2 = area_m2;
    }
  }
  throw InputError(file, "", fmt::format("{} polygons", polygons.size()),
                   fmt::format("a field is one polygon with holes; the largest is number {}, {}, "
                               "{:.2f} ha: keep one in a file of its own",
                               largest + 1, polygons[largest].name, largest_m2 * 1e-4));
}

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

}  // namespace

Field read_field(const FieldSource& given, const std::string& source) {
  if (!given.grid_map.empty()) return read_grid_field(given, source);
  const bool from_file = !given.file.empty();
  const std::string geometry_source = from_file ? given.file.string() : source;
  const GdalScope gdal;
  GDALDatasetUniquePtr dataset;
  GivenPolygon polygon;
  if (from_file) {
    dataset = open_vector_file(given.file);
    polygon = only_polygon(given, *dataset);
  } else {
    polygon = {std::filesystem::path(source).stem().string(), given.crs, given.boundary,
               given.holes};
  }
  if (polygon.boundary.empty()) {
    throw InputError(geometry_source, "boundary", "", "is empty; give at least three points");
  }
  for (std::size_t i = 0; i < polygon.boundary.size(); ++i) {
    require_finite_point(polygon.boundary[i], geometry_source,
                         fmt::format("boundary point {}", i + 1));
  }
  Field field = placed(polygon, geometry_source);

  const std::string point_crs = given.crs.empty() && from_file ? "EPSG:4326" : given.crs;
  const auto local = [&](const Eigen::Vector2d& point, const std::string& where) {
    require_finite_point(point, source, where);
    if (!field.frame.georeferenced) return point;
    return local_from_wgs84(field.frame, wgs84_from_crs(point_crs, {point}, source + ": " + where))
        .front();
  };
  if (given.entry.has_value()) field.entry_W = local(*given.entry, given.entry_place);
  check_field(field, geometry_source);
  check_entry(field, source, given.entry_place);
  for (std::size_t i = 0; i < given.obstacles.size(); ++i) {
    ObstacleSource obstacle = given.obstacles[i];
    const std::string where = fmt::format("{}[{}]", obstacle.place, i);
    for (Eigen::Vector2d& point : obstacle.line) point = local(point, where);
    add_obstacle(obstacle, source, where, field);
  }
  if (from_file) add_obstacle_features(*dataset, given, field);
  return field;
}

}  // namespace headland
