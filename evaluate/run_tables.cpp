#include "evaluate/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "evaluate/number_table.h"

namespace headland {
namespace {

// A column of numbers in [min, max]: one literal table serves writing and reading.
template <typename Row>
struct Column {
  std::string_view name;
  int decimals = 0;
  double& (*value)(Row&) = nullptr;
  double min = -kMostInTable;
  double max = kMostInTable;
};

constexpr Column<RunSample> kRunColumns[] = {
    {"time_s", 4, [](RunSample& s) -> double& { return s.time_s; }, 0.0},
    {"travel_m", 3, [](RunSample& s) -> double& { return s.travel_m; }, 0.0},
    {"x_m", 4, [](RunSample& s) -> double& { return s.p_WB.x(); }},
    {"y_m", 4, [](RunSample& s) -> double& { return s.p_WB.y(); }},
    {"z_m", 4, [](RunSample& s) -> double& { return s.p_WB.z(); }},
    {"yaw_rad", 5, [](RunSample& s) -> double& { return s.yaw_rad; }},
    {"pitch_rad", 5, [](RunSample& s) -> double& { return s.pitch_rad; }},
    {"roll_rad", 5, [](RunSample& s) -> double& { return s.roll_rad; }},
    {"speed_mps", 4, [](RunSample& s) -> double& { return s.speed_mps; }},
    {"steer_rad", 5, [](RunSample& s) -> double& { return s.steer_rad; }},
    {"slip", 4, [](RunSample& s) -> double& { return s.slip; }, 0.0, 1.0},
    {"load_transfer_ratio", 4, [](RunSample& s) -> double& { return s.load_transfer_ratio; }, -1.0,
     1.0},
    {"cross_track_error_m", 4, [](RunSample& s) -> double& { return s.cross_track_error_m; }},
    {"motor_torque_nm", 2, [](RunSample& s) -> double& { return s.motor_torque_nm; }},
    {"motor_power_w", 1, [](RunSample& s) -> double& { return s.motor_power_w; }},
    {"battery_power_w", 1, [](RunSample& s) -> double& { return s.battery_power_w; }},
    {"battery_voltage_v", 3, [](RunSample& s) -> double& { return s.battery_voltage_v; }},
    {"soc", 6, [](RunSample& s) -> double& { return s.soc; }},
    {"draft_n", 1, [](RunSample& s) -> double& { return s.draft_n; }},
    {"hitch_angle_rad", 5, [](RunSample& s) -> double& { return s.hitch_angle_rad; }},
    {"wheel_load_rear_left_n", 1, [](RunSample& s) -> double& { return s.wheel_load_n[0]; }},
    {"wheel_load_rear_right_n", 1, [](RunSample& s) -> double& { return s.wheel_load_n[1]; }},
    {"wheel_load_front_left_n", 1, [](RunSample& s) -> double& { return s.wheel_load_n[2]; }},
    {"wheel_load_front_right_n", 1, [](RunSample& s) -> double& { return s.wheel_load_n[3]; }},
    {"wheel_angle_rear_left_rad", 3, [](RunSample& s) -> double& { return s.wheel_angle_rad[0]; }},
    {"wheel_angle_rear_right_rad", 3, [](RunSample& s) -> double& { return s.wheel_angle_rad[1]; }},
    {"wheel_angle_front_left_rad", 3, [](RunSample& s) -> double& { return s.wheel_angle_rad[2]; }},
    {"wheel_angle_front_right_rad", 3,
     [](RunSample& s) -> double& { return s.wheel_angle_rad[3]; }},
};

constexpr Column<FootprintSample> kFootprintColumns[] = {
    {"left_x_m", 3, [](FootprintSample& s) -> double& { return s.left_W.x(); }},
    {"left_y_m", 3, [](FootprintSample& s) -> double& { return s.left_W.y(); }},
    {"right_x_m", 3, [](FootprintSample& s) -> double& { return s.right_W.x(); }},
    {"right_y_m", 3, [](FootprintSample& s) -> double& { return s.right_W.y(); }},
    {"time_s", 3, [](FootprintSample& s) -> double& { return s.time_s; }, 0.0},
    {"travel_m", 3, [](FootprintSample& s) -> double& { return s.travel_m; }, 0.0},
};

constexpr Column<SegmentRecord> kSegmentColumns[] = {
    {"start_time_s", 4, [](SegmentRecord& s) -> double& { return s.start_time_s; }, 0.0},
    {"duration_s", 4, [](SegmentRecord& s) -> double& { return s.duration_s; }, 0.0},
    {"distance_m", 4, [](SegmentRecord& s) -> double& { return s.distance_m; }, 0.0},
    {"scuffed_m2", 4, [](SegmentRecord& s) -> double& { return s.scuffed_m2; }, 0.0},
    {"peak_power_w", 1, [](SegmentRecord& s) -> double& { return s.peak_power_w; }, 0.0},
    {"battery_j", 3, [](SegmentRecord& s) -> double& { return s.energy.battery_j; }},
};

using Text = fmt::memory_buffer;

void append(Text& text, std::string_view words) { text.append(words); }

void append_number(Text& text, double value, int decimals) {
  fmt::format_to(std::back_inserter(text), "{:.{}f}", value, decimals);
}

template <typename Row>
void append_row(Text& text, std::span<const Column<Row>> columns, Row row) {
  for (const Column<Row>& column : columns) {
    if (&column != columns.data()) text.push_back(',');
    append_number(text, column.value(row), column.decimals);
  }
}

// The step in which a run diverged is no measurement.
template <typename Row>
bool finite(std::span<const Column<Row>> columns, Row row) {
  return std::ranges::all_of(
      columns, [&](const Column<Row>& column) { return std::isfinite(column.value(row)); });
}

template <typename Row>
std::vector<std::string> names_of(std::span<const Column<Row>> columns) {
  std::vector<std::string> names;
  for (const Column<Row>& column : columns) names.emplace_back(column.name);
  return names;
}

std::vector<std::string> energy_keys() {
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    keys.push_back(energy_key(static_cast<EnergyCause>(i)));
  }
  return keys;
}

std::vector<std::string> cat(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

template <typename Row>
std::vector<NumberColumn> number_columns(std::span<const Column<Row>> columns) {
  std::vector<NumberColumn> read;
  for (const Column<Row>& column : columns) {
    read.push_back({std::string(column.name), column.min, column.max});
  }
  return read;
}

const NumberColumn kSegmentIndex{"segment", 0.0, kMostInTable, true};

template <typename Row>
Row row_of(std::span<const Column<Row>> columns, std::span<const double> values) {
  Row row;
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].value(row) = values[i];
  return row;
}

}  // namespace

std::string energy_key(EnergyCause cause) {
  std::string key(energy_cause_name(cause));
  std::replace(key.begin(), key.end(), ' ', '_');
  return key + "_j";
}

std::vector<std::string> run_columns() {
  return cat(names_of<RunSample>(kRunColumns), {"segment", "implement_down"});
}

std::string run_csv(const std::vector<RunSample>& samples, const GeoFrame& frame) {
  constexpr int kDegreeDecimals = 9;
  std::vector<Eigen::Vector2d> lon_lat_deg;
  if (frame.georeferenced) {
    for (const RunSample& sample : samples) lon_lat_deg.emplace_back(sample.p_WB.head<2>());
    lon_lat_deg = wgs84_from_local(frame, lon_lat_deg);
  }
  Text text;
  append(text, fmt::format("{}", fmt::join(run_columns(), ",")));
  append(text, frame.georeferenced ? ",longitude_deg,latitude_deg\n" : "\n");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!finite<RunSample>(kRunColumns, samples[i])) continue;
    append_row<RunSample>(text, kRunColumns, samples[i]);
    append(text, fmt::format(",{},{:d}", samples[i].segment, samples[i].implement_down));
    if (frame.georeferenced) {
      text.push_back(',');
      append_number(text, lon_lat_deg[i].x(), kDegreeDecimals);
      text.push_back(',');
      append_number(text, lon_lat_deg[i].y(), kDegreeDecimals);
    }
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

void read_run_csv(const std::filesystem::path& file, std::vector<RunSample>& samples) {
  std::vector<NumberColumn> columns = number_columns<RunSample>(kRunColumns);
  columns.insert(columns.end(), {kSegmentIndex, {"implement_down", 0.0, 1.0, true}});
  read_number_table(file, columns, [&](std::span<const double> values) {
    RunSample& sample = samples.emplace_back(row_of<RunSample>(kRunColumns, values));
    sample.segment = static_cast<int>(values[std::size(kRunColumns)]);
    sample.implement_down = values[std::size(kRunColumns) + 1] != 0.0;
  });
}

std::vector<RunSample> read_run_csv(const std::filesystem::path& file) {
  std::vector<RunSample> samples;
  read_run_csv(file, samples);
  return samples;
}

std::string footprint_csv(const std::vector<FootprintSample>& footprints) {
  Text text;
  append(text, fmt::format("{},starts_strip\n",
                           fmt::join(names_of<FootprintSample>(kFootprintColumns), ",")));
  for (const FootprintSample& footprint : footprints) {
    if (!finite<FootprintSample>(kFootprintColumns, footprint)) continue;
    append_row<FootprintSample>(text, kFootprintColumns, footprint);
    append(text, footprint.starts_strip ? ",1\n" : ",0\n");
  }
  return fmt::to_string(text);
}

void read_footprint_csv(const std::filesystem::path& file,
                        std::vector<FootprintSample>& footprints) {
  std::vector<NumberColumn> columns = number_columns<FootprintSample>(kFootprintColumns);
  columns.push_back({"starts_strip", 0.0, 1.0, true});
  read_number_table(file, columns, [&](std::span<const double> values) {
    footprints.push_back(row_of<FootprintSample>(kFootprintColumns, values));
    footprints.back().starts_strip = values.back() != 0.0;
  });
}

std::vector<FootprintSample> read_footprint_csv(const std::filesystem::path& file) {
  std::vector<FootprintSample> footprints;
  read_footprint_csv(file, footprints);
  return footprints;
}

std::string segments_csv(const Path& path, const std::vector<SegmentRecord>& segments) {
  constexpr int kEnergyDecimals = 3;
  constexpr int kErrorDecimals = 6;
  Text text;
  append(text, fmt::format("segment,manoeuvre,kind,gear,implement,{},{},track_rms_m,slip_mean\n",
                           fmt::join(names_of<SegmentRecord>(kSegmentColumns), ","),
                           fmt::join(energy_keys(), ",")));
  for (const SegmentRecord& record : segments) {
    const PathSegment& segment = path.segments[static_cast<std::size_t>(record.segment)];
    append(text, fmt::format("{},{},{},{},{},", record.segment, segment.manoeuvre,
                             path_kind_name(segment.kind), gear_name(segment.gear),
                             segment.implement_down ? "down" : "up"));
    append_row<SegmentRecord>(text, kSegmentColumns, record);
    for (const double cause_j : record.energy.cause_j) {
      text.push_back(',');
      append_number(text, cause_j, kEnergyDecimals);
    }
    const double way_m = record.distance_m > 0.0 ? record.distance_m : 1.0;
    text.push_back(',');
    append_number(text, std::sqrt(record.cross_track_sum_m3 / way_m), kErrorDecimals);
    text.push_back(',');
    append_number(text, record.slip_sum_m / way_m, kErrorDecimals);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

void read_segments_csv(const std::filesystem::path& file, bool diverged,
                       std::vector<SegmentRecord>& segments) {
  std::vector<NumberColumn> columns = number_columns<SegmentRecord>(kSegmentColumns);
  for (const std::string& key : energy_keys()) columns.push_back({key});
  columns.push_back(kSegmentIndex);
  columns.push_back({"track_rms_m", 0.0, kMostInTable});
  columns.push_back({"slip_mean", 0.0, 1.0});
  for (NumberColumn& column : columns) column.any = diverged && !column.whole;
  read_number_table(file, columns, [&](std::span<const double> values) {
    SegmentRecord& record = segments.emplace_back(row_of<SegmentRecord>(kSegmentColumns, values));
    std::copy_n(values.begin() + std::size(kSegmentColumns), kEnergyCauses,
                record.energy.cause_j.begin());
    const auto last = values.last<3>();
    record.segment = static_cast<int>(last[0]);
    record.cross_track_sum_m3 = last[1] * last[1] * record.distance_m;
    record.slip_sum_m = last[2] * record.distance_m;
  });
}

std::vector<SegmentRecord> read_segments_csv(const std::filesystem::path& file, bool diverged) {
  std::vector<SegmentRecord> segments;
  read_segments_csv(file, diverged, segments);
  return segments;
}

}  // namespace headland
