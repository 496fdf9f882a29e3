#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluate/metrics.h"
#include "evaluate/path_csv.h"
#include "terrains/csv_table.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct Table {
  const fs::path& file;
  const CsvTable& csv;

  std::size_t column(std::string_view name) const {
    const auto found = std::ranges::find(csv.header.cells, name);
    if (found != csv.header.cells.end()) {
      return static_cast<std::size_t>(found - csv.header.cells.begin());
    }
    throw InputError(file.string(), fmt::format("line {}, {}", csv.header.line, name), "",
                     "the column is missing");
  }

  [[noreturn]] void refuse(const CsvRow& row, std::size_t at, const std::string& allowed) const {
    throw InputError(file.string(), fmt::format("line {}, {}", row.line, csv.header.cells[at]),
                     row.cells[at], allowed);
  }

  int count(const CsvRow& row, std::size_t at) const {
    constexpr double kMost = 1e9;
    const double value = csv_number(csv, row, at, file);
    if (value >= 0.0 && value <= kMost && value == std::floor(value)) {
      return static_cast<int>(value);
    }
    refuse(row, at, "a count from 0");
  }

  // The value whose name stands in the cell.
  template <typename Value, std::size_t kCount, typename NameOf>
  Value named(const CsvRow& row, std::size_t at, const std::array<Value, kCount>& values,
              NameOf name_of) const {
    std::string known;
    for (const Value value : values) {
      if (name_of(value) == row.cells[at]) return value;
      known += (known.empty() ? "" : ", ") + std::string(name_of(value));
    }
    refuse(row, at, "known: " + known);
  }
};

}  // namespace

bool is_path_csv(const fs::path& file) {
  if (file.extension() != ".csv") return false;
  const std::vector<std::string> header = read_csv(file).header.cells;
  return std::ranges::all_of(
      std::array{"heading_rad", "curvature_per_m", "segment"},
      [&](const char* name) { return std::ranges::count(header, name) > 0; });
}

Path read_path_csv(const fs::path& file, const GeoFrame& frame) {
  const CsvTable csv = read_csv(file);
  const Table table{file, csv};
  const std::size_t x = table.column(frame.georeferenced ? "longitude_deg" : "x_m");
  const std::size_t y = table.column(frame.georeferenced ? "latitude_deg" : "y_m");
  const std::size_t heading = table.column("heading_rad");
  const std::size_t curvature = table.column("curvature_per_m");
  const std::size_t gear = table.column("gear");
  const std::size_t implement = table.column("implement");
  const std::size_t kind = table.column("kind");
  const std::size_t segment = table.column("segment");
  const std::size_t manoeuvre = table.column("manoeuvre");
  const auto state = [](bool down) { return std::string_view(down ? "down" : "up"); };
  Path path;
  std::vector<Eigen::Vector2d> places;
  for (const CsvRow& row : csv.rows) {
    PathSegment like;
    like.kind = table.named(row, kind, kEveryPathKind, path_kind_name);
    like.gear = table.named(row, gear, std::array{Gear::kForward, Gear::kReverse}, gear_name);
    like.implement_down = table.named(row, implement, std::array{true, false}, state);
    like.manoeuvre = table.count(row, manoeuvre);
    const int number = table.count(row, segment);
    const int last = static_cast<int>(path.segments.size()) - 1;
    if (number == last + 1) {
      path.segments.push_back(like);
    } else if (number != last) {
      table.refuse(row, segment, fmt::format("{} or {}: segments count up", last, last + 1));
    }
    PathSegment& open = path.segments.back();
    if (open.kind != like.kind) table.refuse(row, kind, "one kind a segment");
    if (open.gear != like.gear) table.refuse(row, gear, "one gear a segment");
    if (open.implement_down != like.implement_down) {
      table.refuse(row, implement, "up or down for a whole segment");
    }
    places.emplace_back(csv_number(csv, row, x, file), csv_number(csv, row, y, file));
    open.points.push_back({Eigen::Vector2d::Zero(), csv_number(csv, row, heading, file),
                           csv_number(csv, row, curvature, file)});
  }
  if (frame.georeferenced) {
    places = local_from_wgs84(frame, wgs84_from_crs("EPSG:4326", places, file.string()));
  }
  auto place = places.begin();
  for (PathSegment& read : path.segments) {
    for (PathPoint& point : read.points) point.p_W = *place++;
  }
  return path;
}

}  // namespace headland
