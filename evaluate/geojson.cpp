#include "evaluate/geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kWgs84[] = "WGS 84 longitude, latitude in degrees";
constexpr char kLocal[] = "local metres, x east, y north: the field has no place on the earth";

std::vector<Eigen::Vector2d> all_points(const std::vector<GeoFeature>& features) {
  std::vector<Eigen::Vector2d> points;
  for (const GeoFeature& feature : features) {
    points.insert(points.end(), feature.points_W.begin(), feature.points_W.end());
  }
  return points;
}

Json coordinates_json(const std::vector<Eigen::Vector2d>& points, std::size_t first,
                      std::size_t count, int decimals) {
  Json list = Json::array();
  for (std::size_t i = first; i < first + count; ++i) {
    list.push_back({rounded(points[i].x(), decimals), rounded(points[i].y(), decimals)});
  }
  return list;
}

InputError feature_error(const std::filesystem::path& file, std::size_t index,
                         const std::string& value, const std::string& allowed) {
  return {file.string(), fmt::format("feature {}", index + 1), value, allowed};
}

Eigen::Vector2d position(const Json& pair, const std::filesystem::path& file, std::size_t index) {
  if (!pair.is_array() || pair.size() < 2 || !pair[0].is_number() || !pair[1].is_number()) {
    throw feature_error(file, index, "coordinates", "pairs of numbers are needed");
  }
  return {pair[0].get<double>(), pair[1].get<double>()};
}

GeoFeature read_feature(const Json& feature, const std::filesystem::path& file, std::size_t index) {
  const Json none = Json::object();
  const Json geometry = feature.is_object() ? feature.value("geometry", none) : none;
  const std::string type = geometry.is_object() ? geometry.value("type", Json("")).dump() : "";
  const Json coordinates = geometry.is_object() ? geometry.value("coordinates", none) : none;
  GeoFeature read;
  if (type == "\"Point\"") {
    read.points_W.push_back(position(coordinates, file, index));
  } else if (type == "\"LineString\"" && coordinates.is_array() && coordinates.size() >= 2) {
    for (const Json& pair : coordinates) read.points_W.push_back(position(pair, file, index));
  } else {
    throw feature_error(file, index, type, "a Point, or a LineString of two points or more");
  }
  read.properties = feature.value("properties", none);
  if (!read.properties.is_object()) read.properties = none;
  return read;
}

const Json& property(const GeoCollection& collection, std::size_t index, const std::string& key,
                     const std::filesystem::path& file) {
  const Json& properties = collection.features[index].properties;
  const auto found = properties.find(key);
  if (found == properties.end()) {
    throw feature_error(file, index, key, "the property is missing");
  }
  return *found;
}

}  // namespace

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;  // + 0.0 turns -0 into 0
}

Json frame_json(const GeoFrame& frame) {
  if (!frame.georeferenced) return nullptr;
  return {{"longitude_deg", frame.longitude_deg},
          {"latitude_deg", frame.latitude_deg},
          {"proj", proj_of(frame)}};
}

std::string geojson_text(const GeoFrame& frame, const GeoCollection& collection) {
  constexpr int kDegreeDecimals = 10;
  constexpr int kMetreDecimals = 6;
  std::vector<Eigen::Vector2d> points = all_points(collection.features);
  if (frame.georeferenced) points = wgs84_from_local(frame, points);
  const int decimals = frame.georeferenced ? kDegreeDecimals : kMetreDecimals;

  Json about = collection.about;
  about["coordinates"] = frame.georeferenced ? kWgs84 : kLocal;
  about["frame"] = frame_json(frame);
  std::string text = fmt::format(
      "{{\"type\":\"FeatureCollection\",\n\"headland\":{},\n\"features\":[", json_text(about));
  std::size_t first = 0;
  for (const GeoFeature& feature : collection.features) {
    const std::size_t count = feature.points_W.size();
    const Json list = coordinates_json(points, first, count, decimals);
    Json geometry;
    geometry["type"] = count == 1 ? "Point" : "LineString";
    geometry["coordinates"] = count == 1 ? list[0] : list;
    Json written;
    written["type"] = "Feature";
    written["properties"] = feature.properties;
    written["geometry"] = std::move(geometry);
    text += (first == 0 ? "\n" : ",\n") + json_text(written);
    first += count;
  }
  return text + "\n]}\n";
}

GeoCollection read_geojson(const GeoFrame& frame, const std::filesystem::path& file) {
  const Json top = parse_json(file);
  GeoCollection collection;
  if (top.is_object()) collection.about = top.value("headland", Json::object());
  const Json features = top.is_object() ? top.value("features", Json()) : Json();
  if (!features.is_array() || !collection.about.is_object()) {
    throw InputError(file.string(), "", "", "is not a FeatureCollection as headland writes it");
  }
  if (collection.about.value("coordinates", Json("")) != (frame.georeferenced ? kWgs84 : kLocal)) {
    throw InputError(
        file.string(), "headland.coordinates",
        json_text(collection.about.value("coordinates", Json(""))),
        fmt::format("the field of the scenario has '{}'", frame.georeferenced ? kWgs84 : kLocal));
  }
  for (std::size_t i = 0; i < features.size(); ++i) {
    collection.features.push_back(read_feature(features[i], file, i));
  }
  if (frame.georeferenced) {
    const std::vector<Eigen::Vector2d> points =
        local_from_wgs84(frame, all_points(collection.features));
    auto next = points.begin();
    for (GeoFeature& feature : collection.features) {
      const auto count = static_cast<std::ptrdiff_t>(feature.points_W.size());
      std::copy_n(next, count, feature.points_W.begin());
      next += count;
    }
  }
  return collection;
}

double number_property(const GeoCollection& collection, std::size_t index, const std::string& key,
                       const std::filesystem::path& file) {
  const Json& value = property(collection, index, key, file);
  if (value.is_number()) return value.get<double>();
  throw feature_error(file, index, key, "a number is needed, not " + json_text(value));
}

std::string word_property(const GeoCollection& collection, std::size_t index,
                          const std::string& key, const std::filesystem::path& file) {
  const Json& value = property(collection, index, key, file);
  if (value.is_string()) return value.get<std::string>();
  throw feature_error(file, index, key, "a word is needed, not " + json_text(value));
}

}  // namespace headland
