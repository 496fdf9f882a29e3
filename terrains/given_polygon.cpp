#include "terrains/given_polygon.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "terrains/input_error.h"
#include "terrains/obstacle_features.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

constexpr double kOriginStep_deg = 1e-4;
constexpr double kHectare_m2 = 1e4;
constexpr std::size_t kMostTold = 12;  // polygons in a message

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

std::vector<GivenPolygon> polygons_in(OGRLayer& layer, const std::string& stem) {
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

OGRLayer& chosen_layer(GDALDataset& dataset, const FieldSource& field, const std::string& file) {
  std::vector<std::string> names;
  for (OGRLayer* layer : dataset.GetLayers()) names.emplace_back(layer->GetName());
  if (!field.layer.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(field.layer.c_str())) return *layer;
    throw InputError(file, "layer", field.layer,
                     fmt::format("no such layer; it has {}", fmt::join(names, ", ")));
  }
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (!polygons_in(*layer, "").empty()) return *layer;
  }
  throw InputError(file, "", "", "holds no polygon; a field's boundary is a polygon");
}

// Counted from 1 as a person counts; 0 for anything else.
std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

bool is_called(const GivenPolygon& polygon, const std::string& name) {
  return polygon.name == name || std::ranges::count(polygon.other_names, name) > 0;
}

// "1 North, 12.30 ha; 2 South, 8.00 ha", largest first.
std::string told(const std::vector<GivenPolygon>& polygons, const std::string& file) {
  struct Entry {
    double area_m2 = 0.0;
    std::string text;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const double area_m2 = field_area_m2(placed(polygons[i], file));
    entries.push_back(
        {area_m2, fmt::format("{} {}, {:.2f} ha", i + 1, polygons[i].name, area_m2 / kHectare_m2)});
  }
  std::ranges::stable_sort(entries, std::greater<>{}, &Entry::area_m2);
  std::string text;
  for (std::size_t i = 0; i < std::min(entries.size(), kMostTold); ++i) {
    text += (i > 0 ? "; " : "") + entries[i].text;
  }
  return text + (entries.size() > kMostTold ? "; ..." : "");
}

}  // namespace

std::vector<GivenPolygon> polygons_of(GDALDataset& dataset, const FieldSource& field) {
  const std::string file = field.file.string();
  OGRLayer& layer = chosen_layer(dataset, field, file);
  std::vector<GivenPolygon> polygons = polygons_in(layer, field.file.stem().string());
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
  return polygons;
}

GivenPolygon chosen_polygon(std::vector<GivenPolygon> polygons, const FieldSource& field) {
  const std::string file = field.file.string();
  if (field.part.empty()) {
    if (polygons.size() == 1) return std::move(polygons.front());
    throw InputError(file, "", fmt::format("{} polygons", polygons.size()),
                     "a field is one polygon with holes; choose one with field.part, its name or "
                     "number: " +
                         told(polygons, file));
  }
  const auto count = std::ranges::count_if(
      polygons, [&](const GivenPolygon& polygon) { return is_called(polygon, field.part); });
  if (count > 1) {
    throw InputError(file, "part", field.part,
                     fmt::format("{} polygons have this name; give the number of one: {}", count,
                                 told(polygons, file)));
  }
  const std::size_t number = number_of(field.part);
  if (count == 0 && number >= 1 && number <= polygons.size()) return polygons[number - 1];
  std::vector<std::string> names;
  for (GivenPolygon& polygon : polygons) {
    if (is_called(polygon, field.part)) return std::move(polygon);
    names.push_back(polygon.name);
  }
  throw InputError(file, "part", field.part,
                   fmt::format("no polygon has this name; did you mean '{}'? There are: {}",
                               nearest_name(field.part, names), told(polygons, file)));
}

Field placed(const GivenPolygon& given, const std::string& source,
             const std::optional<GeoFrame>& frame) {
  Field field;
  field.name = given.name;
  field.boundary = given.boundary;
  field.holes = given.holes;
  if (given.crs.empty() || given.boundary.empty()) return field;
  field.boundary = wgs84_from_crs(given.crs, given.boundary, source);
  if (frame) {
    field.frame = *frame;
  } else {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& lon_lat_deg : field.boundary) box.extend(lon_lat_deg);
    field.frame.georeferenced = true;
    // Dividing by a whole number gives the double nearest to the decimal that people will read.
    const auto rounded_deg = [](double angle_deg) {
      return std::round(angle_deg / kOriginStep_deg) / std::round(1.0 / kOriginStep_deg);
    };
    field.frame.longitude_deg = rounded_deg(box.center().x());
    field.frame.latitude_deg = rounded_deg(box.center().y());
  }
  field.boundary = local_from_wgs84(field.frame, field.boundary);
  for (Ring& hole : field.holes) {
    hole = local_from_wgs84(field.frame, wgs84_from_crs(given.crs, hole, source));
  }
  return field;
}

}  // namespace headland
