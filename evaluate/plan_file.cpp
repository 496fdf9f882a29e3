#include "evaluate/plan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "evaluate/geojson.h"
#include "evaluate/metrics.h"
#include "evaluate/path_check.h"
#include "evaluate/path_csv.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLengthDecimals = 3;
constexpr int kPlanAngleDecimals = 9;
constexpr std::string_view kViolation = "violation";

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t index,
                         const std::string& value, const std::string& allowed) {
  throw InputError(file.string(), fmt::format("feature {}", index + 1), value, allowed);
}

// The value whose name is `name` among `values`; refuses any other.
template <typename Kind, std::size_t kCount, typename NameOf>
Kind named(const std::array<Kind, kCount>& values, NameOf name_of, const std::string& name,
           const std::filesystem::path& file, std::size_t index) {
  std::string known;
  for (const Kind value : values) {
    if (name_of(value) == name) return value;
    known += (known.empty() ? "" : ", ") + std::string(name_of(value));
  }
  refuse(file, index, name, "known: " + known);
}

std::vector<double> numbers(const GeoFeature& feature, const std::string& key,
                            const std::filesystem::path& file, std::size_t index) {
  const Json list = feature.properties.value(key, Json());
  std::vector<double> values;
  if (list.is_array() && list.size() == feature.points_W.size()) {
    for (const Json& value : list) {
      if (value.is_number()) values.push_back(value.get<double>());
    }
  }
  if (values.size() != feature.points_W.size()) {
    refuse(file, index, key,
           fmt::format("{} numbers are needed, one a point", feature.points_W.size()));
  }
  return values;
}

double line_length_m(const std::vector<Eigen::Vector2d>& points) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum_m += (points[i] - points[i - 1]).norm();
  return sum_m;
}

int manoeuvre_of(const GeoCollection& collection, std::size_t index,
                 const std::filesystem::path& file) {
  constexpr double kMost = 1e9;
  const double number = number_property(collection, index, "manoeuvre", file);
  if (number >= 0.0 && number <= kMost && number == std::floor(number))
    return static_cast<int>(number);
  refuse(file, index, fmt::format("manoeuvre {}", number), "a count from 0 is needed");
}

GeoFeature feature_of(const PathSegment& segment) {
  GeoFeature feature;
  Json headings = Json::array();
  Json curvatures = Json::array();
  for (const PathPoint& point : segment.points) {
    feature.points_W.push_back(point.p_W);
    headings.push_back(rounded(point.heading_rad, kPlanAngleDecimals));
    curvatures.push_back(rounded(point.curvature_per_m, kPlanAngleDecimals));
  }
  feature.properties["kind"] = path_kind_name(segment.kind);
  feature.properties["gear"] = gear_name(segment.gear);
  feature.properties["implement"] = segment.implement_down ? "down" : "up";
  feature.properties["manoeuvre"] = segment.manoeuvre;
  feature.properties["length_m"] = rounded(length_m(segment), kLengthDecimals);
  feature.properties["heading_rad"] = std::move(headings);
  feature.properties["curvature_per_m"] = std::move(curvatures);
  return feature;
}

PathSegment segment_of(const GeoCollection& collection, std::size_t index,
                       const std::filesystem::path& file) {
  const GeoFeature& feature = collection.features[index];
  if (feature.points_W.size() < 2) refuse(file, index, "", "a segment needs two points");
  PathSegment segment;
  segment.kind = named(kEveryPathKind, path_kind_name,
                       word_property(collection, index, "kind", file), file, index);
  segment.gear = named(std::array{Gear::kForward, Gear::kReverse}, gear_name,
                       word_property(collection, index, "gear", file), file, index);
  const auto state = [](bool down) { return std::string_view(down ? "down" : "up"); };
  segment.implement_down = named(std::array{true, false}, state,
                                 word_property(collection, index, "implement", file), file, index);
  segment.manoeuvre = manoeuvre_of(collection, index, file);
  const std::vector<double> headings = numbers(feature, "heading_rad", file, index);
  const std::vector<double> curvatures = numbers(feature, "curvature_per_m", file, index);
  for (std::size_t i = 0; i < feature.points_W.size(); ++i) {
    segment.points.push_back({feature.points_W[i], headings[i], curvatures[i]});
  }
  return segment;
}

}  // namespace

std::string plan_geojson(const Plan& plan, const GeoFrame& frame) {
  GeoCollection collection;
  collection.about["planner"] = plan.planner;
  collection.about["swath_direction_rad"] = rounded(plan.swath_direction_rad, kPlanAngleDecimals);
  collection.about["headland_width_m"] = rounded(plan.headland_width_m, kLengthDecimals);
  collection.about["planned_length_m"] = rounded(plan.planned_length_m, kLengthDecimals);
  for (const Pass& pass : plan.passes) {
    GeoFeature feature{pass.points_W, {}};
    feature.properties["kind"] = pass_kind_name(pass.kind);
    feature.properties["order"] = collection.features.size() + 1;
    feature.properties["length_m"] = rounded(line_length_m(pass.points_W), kLengthDecimals);
    collection.features.push_back(std::move(feature));
  }
  return geojson_text(frame, collection);
}

std::string path_geojson(const Path& path, const GeoFrame& frame) {
  GeoCollection collection;
  collection.about["headings"] =
      "heading_rad counter-clockwise from east; in reverse gear the motion is opposite to it";
  for (const PathSegment& segment : path.segments) {
    collection.features.push_back(feature_of(segment));
  }
  for (const PathViolation& violation : path.violations) {
    GeoFeature feature{{violation.p_W}, {}};
    feature.properties["kind"] = kViolation;
    feature.properties["manoeuvre"] = violation.manoeuvre;
    feature.properties["overrun_m"] = rounded(violation.overrun_m, kLengthDecimals);
    feature.properties["what"] = violation.what;
    collection.features.push_back(std::move(feature));
  }
  return geojson_text(frame, collection);
}

bool is_path_file(const std::filesystem::path& file) {
  if (is_path_csv(file)) return true;
  if (file.extension() != ".geojson" && file.extension() != ".json") return false;
  const Json top = parse_json(file);
  const Json features = top.is_object() ? top.value("features", Json()) : Json();
  return features.is_array() && std::any_of(features.begin(), features.end(), [](const Json& one) {
           const Json properties = one.is_object() ? one.value("properties", Json()) : Json();
           return properties.is_object() && properties.contains("heading_rad");
         });
}

namespace {

Path path_of_geojson(const std::filesystem::path& file, const GeoFrame& frame) {
  const GeoCollection collection = read_geojson(frame, file);
  Path path;
  for (std::size_t i = 0; i < collection.features.size(); ++i) {
    if (word_property(collection, i, "kind", file) != kViolation) {
      path.segments.push_back(segment_of(collection, i, file));
      continue;
    }
    PathViolation violation;
    violation.p_W = collection.features[i].points_W.front();
    violation.manoeuvre = manoeuvre_of(collection, i, file);
    violation.overrun_m = number_property(collection, i, "overrun_m", file);
    violation.what = word_property(collection, i, "what", file);
    path.violations.push_back(std::move(violation));
  }
  return path;
}

}  // namespace

Path read_path(const std::filesystem::path& file, const Field& field) {
  Path path =
      is_path_csv(file) ? read_path_csv(file, field.frame) : path_of_geojson(file, field.frame);
  if (path.segments.empty()) throw InputError(file.string(), "", "", "holds no path segment");
  check_path(path, field, file);
  return path;
}

}  // namespace headland
