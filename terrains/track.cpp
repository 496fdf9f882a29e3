#include "terrains/track.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "terrains/csv_table.h"
#include "terrains/field_source.h"
#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
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

// A field is larger than this in metres and smaller in degrees.
constexpr double kLargestDegreeSpan = 0.5;

struct GivenPoint {
  Eigen::Vector2d given = Eigen::Vector2d::Zero();  // W, or longitude and latitude
  bool joined = false;                              // to its predecessor
  std::size_t number = 0;                           // of its line or point in the file
};

// All points of a file, in order.
struct GivenTrack {
  std::vector<GivenPoint> points;
  bool degrees = false;
  std::string_view counted = "line";
};

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

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// A gap in a log is an interval much longer than usual; an interval of zero is nobody's usual.
double longest_joined_s(const std::vector<double>& times_s) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (times_s[i] > times_s[i - 1]) intervals_s.push_back(times_s[i] - times_s[i - 1]);
  }
  return intervals_s.empty() ? 0.0 : kLogGapFactor * median(std::move(intervals_s));
}

GivenTrack track_from_csv(const std::filesystem::path& path, const GeoFrame& frame) {
  const CsvTable table = read_csv(path);
  const Columns columns = position_columns(table, frame, path.string());
  const auto time = column_of(table, kTime, path.string());
  const auto implement = column_of(table, kImplement, path.string());
  GivenTrack track;
  track.degrees = columns.degrees;
  std::vector<double> times_s;
  if (time.has_value()) {
    for (const CsvRow& row : table.rows) {
      times_s.push_back(csv_time_s(table, row, *time, path));
    }
  }
  const double joined_s = longest_joined_s(times_s);
  bool joined = false;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const CsvRow& row = table.rows[i];
    // Receivers set their clocks back by a few seconds; a large step back is another log.
    if (i > 0 && time.has_value() && std::abs(times_s[i] - times_s[i - 1]) > joined_s) {
      joined = false;
    }
    const Eigen::Vector2d given(csv_number(table, row, columns.x, path),
                                csv_number(table, row, columns.y, path));
    if (implement.has_value()) {
      const double state = csv_number(table, row, *implement, path);
      if (state != 0.0 && state != 1.0) {
        throw InputError(path.string(),
                         fmt::format("line {}, {}", row.line, table.header.cells[*implement]),
                         row.cells[*implement], "0 (raised) or 1 (working)");
      }
      if (state == 0.0) {
        joined = false;
        continue;
      }
    }
    track.points.push_back({given, joined, row.line});
    joined = true;
  }
  return track;
}

void append_lines(const OGRGeometry& geometry, GivenTrack& track) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbLineString) {
    bool joined = false;
    for (const OGRPoint& point : *geometry.toLineString()) {
      track.points.push_back({{point.getX(), point.getY()}, joined, track.points.size() + 1});
      joined = true;
    }
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) append_lines(*part, track);
  }
}

GivenTrack track_from_vector_file(const std::filesystem::path& path, const GeoFrame& frame) {
  const GdalScope gdal;
  const GDALDatasetUniquePtr dataset = open_vector_file(path);
  GivenTrack track;
  track.counted = "point";
  std::string crs;
  for (OGRLayer* layer : dataset->GetLayers()) {
    for (const auto& feature : *layer) {
      const OGRGeometry* geometry = feature->GetGeometryRef();
      if (geometry == nullptr) continue;
      const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
      append_lines(*linear, track);
    }
    crs = crs_of(*layer);
    // The layers of a GPX file tell the same track several times.
    if (!track.points.empty()) break;
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

void require_metres(const GivenTrack& track, const std::string& file) {
  const std::string need =
      "longitude and latitude need a field with a place on the earth; give the crs of the field's "
      "coordinates as field.crs";
  if (track.degrees) throw InputError(file, "", "", need);
  Eigen::AlignedBox2d box;
  for (const GivenPoint& point : track.points) box.extend(point.given);
  const bool like_degrees = std::abs(box.center().x()) <= 180.0 &&
                            std::abs(box.center().y()) <= 90.0 && box.sizes().maxCoeff() > 0.0 &&
                            box.sizes().maxCoeff() < kLargestDegreeSpan;
  if (like_degrees) {
    throw InputError(
        file, fmt::format("{} {}", track.counted, track.points.front().number),
        fmt::format("{}, {}", track.points.front().given.x(), track.points.front().given.y()),
        "looks like degrees; " + need);
  }
}

void require_near(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W,
                  const std::string& file) {
  for (std::size_t i = 1; i < points_W.size(); ++i) {
    const double step_m = (points_W[i] - points_W[i - 1]).norm();
    if (step_m <= kMaxJump_m) continue;
    throw InputError(
        file,
        fmt::format("{}s {} and {}", given.counted, given.points[i - 1].number,
                    given.points[i].number),
        fmt::format("{:.0f} m apart", step_m),
        fmt::format("neighbours at most {} m apart; take out the stray point", kMaxJump_m));
  }
}

// Repeated points merged, sections of a single point left out: a stray fix is no line.
Track sections_joined(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W) {
  Track track;
  std::vector<Eigen::Vector2d> section_W;
  const auto finish_section = [&] {
    if (section_W.size() >= 2) {
      if (!track.points_W.empty()) track.break_before.push_back(track.points_W.size());
      track.points_W.insert(track.points_W.end(), section_W.begin(), section_W.end());
    }
    section_W.clear();
  };
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    if (!section_W.empty() && (points_W[i] - section_W.back()).norm() <= kSamePlace_m) continue;
    if (!given.points[i].joined) finish_section();
    section_W.push_back(points_W[i]);
  }
  finish_section();
  return track;
}

}  // namespace

Track read_track(const std::filesystem::path& path, const GeoFrame& frame) {
  const std::string file = path.string();
  std::string extension = path.extension().string();
  const bool csv = EQUAL(extension.c_str(), ".csv") || EQUAL(extension.c_str(), ".txt") ||
                   EQUAL(extension.c_str(), ".tsv");
  const GivenTrack given = csv ? track_from_csv(path, frame) : track_from_vector_file(path, frame);
  if (!frame.georeferenced) require_metres(given, file);
  std::vector<Eigen::Vector2d> points;
  for (const GivenPoint& point : given.points) points.push_back(point.given);
  if (given.degrees) {
    points = local_from_wgs84(frame, wgs84_from_crs("EPSG:4326", points, file));
  }
  require_near(given, points, file);
  Track track = sections_joined(given, points);
  if (track.points_W.size() < 2) {
    throw InputError(file, "", fmt::format("{} points", given.points.size()),
                     "a track has at least two different points that follow each other");
  }
  return track;
}

}  // namespace headland
