#include "evaluate/report_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "evaluate/geojson.h"
#include "evaluate/packed_bytes.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

struct SeriesColumn {
  const char* name;
  double (*value)(const RunSample&);
};

// What places the machine: taken at one moment of each bucket.
constexpr SeriesColumn kPoses[] = {
    {"time_s", [](const RunSample& s) { return s.time_s; }},
    {"travel_m", [](const RunSample& s) { return s.travel_m; }},
    {"x_m", [](const RunSample& s) { return s.p_WB.x(); }},
    {"y_m", [](const RunSample& s) { return s.p_WB.y(); }},
    {"z_m", [](const RunSample& s) { return s.p_WB.z(); }},
    {"yaw_rad", [](const RunSample& s) { return s.yaw_rad; }},
    {"pitch_rad", [](const RunSample& s) { return s.pitch_rad; }},
    {"roll_rad", [](const RunSample& s) { return s.roll_rad; }},
    {"steer_rad", [](const RunSample& s) { return s.steer_rad; }},
    {"hitch_angle_rad", [](const RunSample& s) { return s.hitch_angle_rad; }},
    {"wheel_angle_rear_left_rad", [](const RunSample& s) { return s.wheel_angle_rad[0]; }},
    {"wheel_angle_rear_right_rad", [](const RunSample& s) { return s.wheel_angle_rad[1]; }},
    {"wheel_angle_front_left_rad", [](const RunSample& s) { return s.wheel_angle_rad[2]; }},
    {"wheel_angle_front_right_rad", [](const RunSample& s) { return s.wheel_angle_rad[3]; }},
    {"segment", [](const RunSample& s) { return static_cast<double>(s.segment); }},
    {"implement_down", [](const RunSample& s) { return s.implement_down ? 1.0 : 0.0; }},
};

// What is judged and charted: both extremes of each bucket.
constexpr SeriesColumn kEnvelopes[] = {
    {"battery_power_w", [](const RunSample& s) { return s.battery_power_w; }},
    {"speed_mps", [](const RunSample& s) { return s.speed_mps; }},
    {"soc", [](const RunSample& s) { return s.soc; }},
    {"battery_voltage_v", [](const RunSample& s) { return s.battery_voltage_v; }},
    {"slip", [](const RunSample& s) { return s.slip; }},
    {"load_transfer_ratio", [](const RunSample& s) { return s.load_transfer_ratio; }},
    {"cross_track_error_m", [](const RunSample& s) { return s.cross_track_error_m; }},
    {"ground_m", [](const RunSample& s) { return s.p_WB.z(); }},
};

std::vector<double> column_of(const std::vector<RunSample>& samples, const SeriesColumn& column) {
  std::vector<double> values(samples.size());
  std::transform(samples.begin(), samples.end(), values.begin(), column.value);
  return values;
}

}  // namespace

std::vector<std::size_t> bucket_starts(std::span<const RunSample> samples, std::size_t most) {
  const std::size_t count = samples.size();
  std::vector<double> turned_rad(count, 0.0);  // until each
  for (std::size_t i = 1; i < count; ++i) {
    const double turn_rad =
        std::remainder(samples[i].yaw_rad - samples[i - 1].yaw_rad, 2.0 * std::numbers::pi);
    turned_rad[i] = turned_rad[i - 1] + (std::isfinite(turn_rad) ? std::abs(turn_rad) : 0.0);
  }
  const auto bucket_of = [&](std::size_t i) {
    if (count <= most) return i;
    const double of_samples = static_cast<double>(i) / static_cast<double>(count - 1);
    const double of_turning =
        turned_rad.back() > 0.0 ? turned_rad[i] / turned_rad.back() : of_samples;
    return static_cast<std::size_t>(0.5 * (of_samples + of_turning) * static_cast<double>(most));
  };
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || i + 1 == count || bucket_of(i) != bucket_of(i - 1)) starts.push_back(i);
  }
  return starts;
}

Envelope envelope_of(std::span<const double> values, std::span<const std::size_t> starts) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Envelope envelope;
  for (std::size_t bucket = 0; bucket < starts.size(); ++bucket) {
    const std::size_t end = bucket + 1 < starts.size() ? starts[bucket + 1] : values.size();
    double low = kInfinity;
    double high = -kInfinity;
    for (std::size_t i = starts[bucket]; i < end; ++i) {
      if (!std::isfinite(values[i])) continue;
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    const bool any = low <= high;
    const float none = std::numeric_limits<float>::quiet_NaN();
    envelope.low.push_back(any ? static_cast<float>(low) : none);
    envelope.high.push_back(any ? static_cast<float>(high) : none);
  }
  return envelope;
}

Json envelope_json(const Envelope& envelope) {
  Json json;
  json["low"] = packed_floats(envelope.low);
  const bool same = std::equal(envelope.low.begin(), envelope.low.end(), envelope.high.begin(),
                               [](float a, float b) { return a == b || (a != a && b != b); });
  if (!same) json["high"] = packed_floats(envelope.high);
  return json;
}

Json series_json(const std::vector<RunSample>& samples, std::span<const double> wh_per_m) {
  const std::vector<std::size_t> starts = bucket_starts(samples, kMostReportBuckets);
  Json json;
  json["count"] = starts.size();
  json["samples"] = samples.size();
  for (const SeriesColumn& column : kPoses) {
    std::vector<float> values;
    values.reserve(starts.size());
    for (const std::size_t i : starts) {
      values.push_back(static_cast<float>(column.value(samples[i])));
    }
    json["poses"][column.name] = packed_floats(values);
  }
  for (const SeriesColumn& column : kEnvelopes) {
    json["envelopes"][column.name] = envelope_json(envelope_of(column_of(samples, column), starts));
  }
  if (!wh_per_m.empty()) {
    json["envelopes"]["energy_wh_per_m"] = envelope_json(envelope_of(wh_per_m, starts));
  }
  return json;
}

Json footprints_json(const std::vector<FootprintSample>& footprints) {
  const double travel_m = footprints.empty() ? 0.0 : footprints.back().travel_m;
  const double spacing_m = std::max(0.5, travel_m / static_cast<double>(kMostReportBuckets));
  std::array<std::vector<float>, 6> columns;
  const auto keep = [&](const FootprintSample& f) {
    const std::array<double, 6> row = {f.left_W.x(),  f.left_W.y(), f.right_W.x(),
                                       f.right_W.y(), f.time_s,     f.starts_strip ? 1.0 : 0.0};
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(static_cast<float>(row[k]));
  };
  double kept_m = 0.0;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const bool last = i + 1 == footprints.size() || footprints[i + 1].starts_strip;
    if (!last && !footprints[i].starts_strip && footprints[i].travel_m - kept_m < spacing_m) {
      continue;
    }
    kept_m = footprints[i].travel_m;
    keep(footprints[i]);
  }
  constexpr const char* kNames[] = {"left_x_m",  "left_y_m", "right_x_m",
                                    "right_y_m", "time_s",   "starts_strip"};
  Json json;
  for (std::size_t k = 0; k < columns.size(); ++k) json[kNames[k]] = packed_floats(columns[k]);
  return json;
}

Json tracking_histogram_json(const std::vector<RunSample>& samples) {
  constexpr int kBins = 40;
  constexpr double kSteps_m[] = {0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0};
  double worst_m = 0.0;
  for (const RunSample& sample : samples) {
    if (std::isfinite(sample.cross_track_error_m)) {
      worst_m = std::max(worst_m, std::abs(sample.cross_track_error_m));
    }
  }
  const double* step = std::find_if(std::begin(kSteps_m), std::end(kSteps_m) - 1,
                                    [&](double s_m) { return 0.5 * kBins * s_m >= worst_m; });
  std::array<std::vector<double>, 2> way_m;
  for (std::vector<double>& ways : way_m) ways.assign(kBins, 0.0);
  double all_m = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double error_m = samples[i].cross_track_error_m;
    const double way = samples[i].travel_m - samples[i - 1].travel_m;
    if (!std::isfinite(error_m) || !(way > 0.0)) continue;
    const double bin = std::clamp(std::floor(error_m / *step + 0.5 * kBins), 0.0, kBins - 1.0);
    way_m[samples[i].implement_down ? 0 : 1][static_cast<std::size_t>(bin)] += way;
    all_m += way;
  }
  Json json;
  for (int k = 0; k <= kBins; ++k) json["edges_m"].push_back(rounded((k - 0.5 * kBins) * *step, 6));
  for (const std::size_t raised : {0U, 1U}) {
    Json& shares = json[raised == 0 ? "working" : "turning"] = Json::array();
    for (const double m : way_m[raised]) {
      shares.push_back(all_m > 0.0 ? rounded(100.0 * m / all_m, 4) : 0.0);
    }
  }
  return json;
}

}  // namespace headland
