#include "terrains/given_track.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "terrains/csv_table.h"
#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/track.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

using Names = std::span<const std::string_view>;
constexpr std::array<std::string_view, 7> kX = {"x",         "x_m",  "x_w",   "easting",
                                                "easting_m", "east", "east_m"};
constexpr std::array<std::string_view, 7> kY = {"y",          "y_m",   "y_w",    "northing",
                                                "northing_m", "north", "north_m"};
constexpr std::array<std::string_view, 6> kLongitude = {"lon",       "lon_deg",       "long",
                                                        "longitude", "longitude_deg", "lng"};
constexpr std::array<std::string_view, 4> kLatitude = {"lat", "lat_deg", "latitude",
                                                       "latitude_deg"};
constexpr std::array<std::string_view, 8> kTime = {"time_s",  "t_s",       "t",        "time",
                                                   "seconds", "timestamp", "datetime", "utc"};
constexpr std::array<std::string_view, 5> kImplement = {"implement", "implement_on",
                                                        "implement_down", "working", "engaged"};

std::optional<std::size_t> column_of(const CsvTable& table, Names names, const std::string& file) {
  for (std::string_view name : names) {
    const auto found = std::ranges::find(table.header.cells, name);
    if (found != table.header.cells.end()) {
      if (std::count(found, table.header.cells.end(), name) > 1) {
        throw InputError(file, fmt::format("line {}, {}", table.header.line, name), "",
                         "the column stands twice");
      }
      return static_cast<std::size_t>(found - table.header.cells.begin());
    }
  }
  return std::nullopt;
}

constexpr std::array<std::string_view, 1> kReference = {"reference"};
// GPX holds what else a track has in a name space of its own, which GDAL puts before the name.
constexpr std::array<std::string_view, 3> kPrefixes = {"", "headland_", "ogr_"};

struct Columns {
  std::size_t x = 0;
  std::size_t y = 0;
  bool degrees = false;
};

Columns position_columns(const CsvTable& table, const GeoFrame& frame, const std::string& file) {
  const auto x = column_of(table, kX, file);
  const auto y = column_of(table, kY, file);
  const auto longitude = column_of(table, kLongitude, file);
  const auto latitude = column_of(table, kLatitude, file);
  const bool metres = x.has_value() && y.has_value();
  const bool degrees = longitude.has_value() && latitude.has_value();
  if (degrees && (frame.georeferenced || !metres)) return {*longitude, *latitude, true};
  if (metres) return {*x, *y, false};
  throw InputError(file, fmt::format("line {}", table.header.line),
                   fmt::format("{}", fmt::join(table.header.cells, ", ")),
                   "the header must name x and y (metres) or lon and lat (degrees)");
}

// Seconds, from whenever they are counted, or a date and time of day such as ISO 8601.
double csv_time_s(const CsvTable& table, const CsvRow& row, std::size_t column,
                  const std::filesystem::path& file) {
  OGRField parsed;
  if (row.cells[column].find(':') == std::string::npos ||
      OGRParseDate(row.cells[column].c_str(), &parsed, 0) == 0) {
    return csv_number(table, row, column, file);
  }
  const auto& date = parsed.Date;
  const std::chrono::sys_days day =
      std::chrono::year(date.Year) / std::chrono::month(date.Month) / std::chrono::day(date.Day);
  // GDAL: 0 and 1 are no time zone and local time, 100 is UTC, every step a quarter of an hour.
  const int ahead_s = date.TZFlag > 1 ? (date.TZFlag - 100) * 900 : 0;
  return std::chrono::duration<double>(day.time_since_epoch()).count() + date.Hour * 3600.0 +
         date.Minute * 60.0 + static_cast<double>(date.Second) - ahead_s;
}

// An interval of zero is nobody's usual.
double longest_interval_s(const std::vector<double>& times_s) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (times_s[i] > times_s[i - 1]) intervals_s.push_back(times_s[i] - times_s[i - 1]);
  }
  return intervals_s.empty() ? 0.0 : kLogGapFactor * upper_median(std::move(intervals_s));
}

// Whether the implement is down; refuses words that do not tell.
bool is_down(const std::string& word, const std::filesystem::path& path, const std::string& where) {
  constexpr std::array<std::string_view, 3> kDown = {"1", "down", "true"};
  constexpr std::array<std::string_view, 3> kUp = {"0", "up", "false"};
  const auto stands_for = [&](std::string_view name) { return EQUAL(word.c_str(), name.data()); };
  if (std::ranges::any_of(kDown, stands_for)) return true;
  if (std::ranges::any_of(kUp, stands_for)) return false;
  throw InputError(path.string(), where, word, "0 or up (raised), 1 or down (working)");
}

[[noreturn]] void refuse_never_down(const std::filesystem::path& path, std::string_view name) {
  throw InputError(path.string(), "", "",
                   fmt::format("no point with the implement down: '{}' never is", name));
}

// Of the properties that tell the same, the first that the feature has.
std::string property_of(const OGRFeature& feature, Names names) {
  for (const std::string_view name : names) {
    for (const std::string_view prefix : kPrefixes) {
      std::string whole = std::string(prefix) + std::string(name);
      const int index = feature.GetFieldIndex(whole.c_str());
      if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return whole;
    }
  }
  return {};
}

// Whether a track is the vehicle's way; refuses words that do not tell, and two of them.
bool is_of_vehicle(const std::string& word, bool first, bool so_far,
                   const std::filesystem::path& path, const std::string& where) {
  const bool vehicle = EQUAL(word.c_str(), "vehicle");
  if (vehicle || EQUAL(word.c_str(), "implement")) {
    if (first || vehicle == so_far) return vehicle;
  }
  throw InputError(path.string(), where, word,
                   "vehicle or implement, the same in the whole file: whose way it is");
}

// The points of every line in the geometry; `count` counts those of the file.
void append_lines(const OGRGeometry& geometry, bool down, std::size_t& count, GivenTrack& track) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbLineString) {
    bool joined = false;
    for (const OGRPoint& point : *geometry.toLineString()) {
      track.points.push_back({{point.getX(), point.getY()}, joined, false, down, ++count});
      joined = true;
    }
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      append_lines(*part, down, count, track);
    }
  }
}

}  // namespace

double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

GivenTrack track_from_csv(const std::filesystem::path& path, const GeoFrame& frame) {
  const CsvTable table = read_csv(path);
  const Columns columns = position_columns(table, frame, path.string());
  const auto time = column_of(table, kTime, path.string());
  const auto implement = column_of(table, kImplement, path.string());
  const auto reference = column_of(table, kReference, path.string());
  GivenTrack track;
  track.degrees = columns.degrees;
  std::vector<double> times_s;
  if (time.has_value()) {
    for (const CsvRow& row : table.rows) {
      times_s.push_back(csv_time_s(table, row, *time, path));
    }
  }
  track.longest_interval_s = longest_interval_s(times_s);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const CsvRow& row = table.rows[i];
    // Receivers set their clocks back by a few seconds; a large step back is another log.
    const bool after_pause = i > 0 && time.has_value() &&
                             std::abs(times_s[i] - times_s[i - 1]) > track.longest_interval_s;
    const Eigen::Vector2d given(csv_number(table, row, columns.x, path),
                                csv_number(table, row, columns.y, path));
    const bool down = !implement.has_value() ||
                      is_down(row.cells[*implement], path,
                              fmt::format("line {}, {}", row.line, table.header.cells[*implement]));
    if (reference) {
      track.of_vehicle = is_of_vehicle(row.cells[*reference], i == 0, track.of_vehicle, path,
                                       fmt::format("line {}, reference", row.line));
    }
    track.points.push_back({given, i > 0, after_pause, down, row.line});
  }
  track.of_implement = reference && !track.of_vehicle;
  if (!table.rows.empty() && std::ranges::none_of(track.points, &GivenPoint::down)) {
    refuse_never_down(path, table.header.cells[*implement]);
  }
  return track;
}

GivenTrack track_from_vector_file(const std::filesystem::path& path, const GeoFrame& frame) {
  const GdalScope gdal;
  const GDALDatasetUniquePtr dataset = open_vector_file(path);
  GivenTrack track;
  track.counted = "point";
  std::string crs;
  std::size_t count = 0;  // of the points of lines, up or down
  std::size_t number = 0;
  std::string told_by;
  for (OGRLayer* layer : dataset->GetLayers()) {
    for (const auto& feature : *layer) {
      ++number;
      const OGRGeometry* geometry = feature->GetGeometryRef();
      if (geometry == nullptr) continue;
      const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
      const std::string name = property_of(*feature, kImplement);
      const bool down = name.empty() || is_down(feature->GetFieldAsString(name.c_str()), path,
                                                fmt::format("feature {}, {}", number, name));
      if (!name.empty()) told_by = name;
      const bool first = count == 0;
      append_lines(*linear, down, count, track);
      const std::string whose = property_of(*feature, kReference);
      if (whose.empty()) continue;
      track.of_vehicle =
          is_of_vehicle(feature->GetFieldAsString(whose.c_str()), first, track.of_vehicle, path,
                        fmt::format("feature {}, {}", number, whose));
      track.of_implement = !track.of_vehicle;
    }
    crs = crs_of(*layer);
    // The layers of a GPX file tell the same track several times.
    if (count > 0) break;
  }
  if (count > 0 && std::ranges::none_of(track.points, &GivenPoint::down)) {
    refuse_never_down(path, told_by);
  }
  if (track.points.empty()) {
    throw InputError(path.string(), "", "", "holds no line; a track is a LineString");
  }
  // A GeoJSON is formally WGS 84, but one written for a field with no place on the earth is in W.
  const bool geojson = EQUAL(dataset->GetDriverName(), "GeoJSON");
  if (!frame.georeferenced && (crs.empty() || geojson)) return track;
  track.degrees = true;
  if (!frame.georeferenced) return track;
  if (crs.empty()) throw InputError(path.string(), "", "", "has no CRS");
  std::vector<Eigen::Vector2d> points;
  for (const GivenPoint& point : track.points) points.push_back(point.given);
  points = wgs84_from_crs(crs, points, path.string());
  for (std::size_t i = 0; i < points.size(); ++i) track.points[i].given = points[i];
  return track;
}

}  // namespace headland
