// GeoJSON as headland writes it: lines and points with properties, in WGS 84 when the field is
// georeferenced, and otherwise in the metres of frame W, which the file then says of itself.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "terrains/geo_frame.h"

namespace headland {

// One point makes a Point, several make a LineString.
struct GeoFeature {
  std::vector<Eigen::Vector2d> points_W;
  nlohmann::ordered_json properties;
};

struct GeoCollection {
  nlohmann::ordered_json about;  // the collection's member "headland"
  std::vector<GeoFeature> features;
};

// Where the local frame is on the earth: longitude_deg, latitude_deg and proj, the string GDAL and
// PROJ take; null when it is nowhere.
nlohmann::ordered_json frame_json(const GeoFrame& frame);

// One feature a line. The member "headland" also tells the coordinates and the frame. Coordinates
// are rounded to 1e-10 deg (11 um) or 1e-6 m, so that writing what was read gives the same bytes.
std::string geojson_text(const GeoFrame& frame, const GeoCollection& collection);

// Reads such a file back. Throws InputError naming the feature: missing file, malformed JSON (with
// the line), another geometry, coordinates that are not numbers, degrees where the field has no
// place on the earth or the reverse.
GeoCollection read_geojson(const GeoFrame& frame, const std::filesystem::path& file);

// The property `key` of feature `index` as a number or a word. Throws InputError when it is not.
double number_property(const GeoCollection& collection, std::size_t index, const std::string& key,
                       const std::filesystem::path& file);
std::string word_property(const GeoCollection& collection, std::size_t index,
                          const std::string& key, const std::filesystem::path& file);

// `value` with so many decimals.
double rounded(double value, int decimals);

}  // namespace headland
