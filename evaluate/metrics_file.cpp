#include "evaluate/metrics_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "evaluate/geojson.h"
#include "evaluate/json_text.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

// A number and its key: one literal table serves writing and reading.
template <typename Owner, typename Value>
struct Entry {
  const char* key;
  Value& (*value)(Owner&);
};

constexpr Entry<Metrics, double> kFigures[] = {
    {"workable_m2", [](Metrics& m) -> double& { return m.coverage.workable_m2; }},
    {"covered_m2", [](Metrics& m) -> double& { return m.coverage.covered_m2; }},
    {"missed_m2", [](Metrics& m) -> double& { return m.coverage.missed_m2; }},
    {"overlap_m2", [](Metrics& m) -> double& { return m.coverage.overlap_m2; }},
    {"outside_m2", [](Metrics& m) -> double& { return m.coverage.outside_m2; }},
    {"coverage_ratio", [](Metrics& m) -> double& { return m.coverage_ratio; }},
    {"overlap_ratio", [](Metrics& m) -> double& { return m.overlap_ratio; }},
    {"distance_m", [](Metrics& m) -> double& { return m.distance_m; }},
    {"time_s", [](Metrics& m) -> double& { return m.time_s; }},
    {"energy_wh", [](Metrics& m) -> double& { return m.energy_wh; }},
    {"energy_wh_per_ha", [](Metrics& m) -> double& { return m.energy_wh_per_ha; }},
    {"delta_soc", [](Metrics& m) -> double& { return m.delta_soc; }},
    {"rested_voltage_drop_v", [](Metrics& m) -> double& { return m.rested_voltage_drop_v; }},
    {"worst_slip", [](Metrics& m) -> double& { return m.worst_slip; }},
    {"worst_load_transfer", [](Metrics& m) -> double& { return m.worst_load_transfer; }},
    {"track_rms_working_m", [](Metrics& m) -> double& { return m.track_rms_working_m; }},
    {"track_rms_turning_m", [](Metrics& m) -> double& { return m.track_rms_turning_m; }},
    {"ledger_residual_ratio", [](Metrics& m) -> double& { return m.ledger_residual_ratio; }},
};

constexpr Entry<Metrics, int> kCounts[] = {
    {"turns", [](Metrics& m) -> int& { return m.turns; }},
    {"u_turns", [](Metrics& m) -> int& { return m.u_turns; }},
};

constexpr Entry<RunRecord, double> kTotals[] = {
    {"duration_s", [](RunRecord& r) -> double& { return r.duration_s; }},
    {"distance_m", [](RunRecord& r) -> double& { return r.distance_m; }},
    {"soc_start", [](RunRecord& r) -> double& { return r.soc_start; }},
    {"soc_end", [](RunRecord& r) -> double& { return r.soc_end; }},
    {"rested_voltage_start_v", [](RunRecord& r) -> double& { return r.rested_voltage_start_v; }},
    {"rested_voltage_end_v", [](RunRecord& r) -> double& { return r.rested_voltage_end_v; }},
    {"motor_clipped_s", [](RunRecord& r) -> double& { return r.peaks.motor_clipped_s; }},
};

constexpr Entry<Peaks, Peak> kPeaks[] = {
    {"slip", [](Peaks& p) -> Peak& { return p.slip; }},
    {"load_transfer_ratio", [](Peaks& p) -> Peak& { return p.load_transfer_ratio; }},
    {"cross_track_working_m", [](Peaks& p) -> Peak& { return p.cross_track_working_m; }},
    {"cross_track_turning_m", [](Peaks& p) -> Peak& { return p.cross_track_turning_m; }},
    {"boundary_overrun_m", [](Peaks& p) -> Peak& { return p.boundary_overrun_m; }},
    {"implement_overhang_m", [](Peaks& p) -> Peak& { return p.implement_overhang_m; }},
    {"battery_power_w", [](Peaks& p) -> Peak& { return p.battery_power_w; }},
    {"roll_rad", [](Peaks& p) -> Peak& { return p.roll_rad; }},
    {"pitch_rad", [](Peaks& p) -> Peak& { return p.pitch_rad; }},
    {"min_voltage_v", [](Peaks& p) -> Peak& { return p.min_voltage_v; }},
};

constexpr PathKind kKinds[] = {PathKind::kSwath, PathKind::kHeadlandPass, PathKind::kTurn,
                               PathKind::kUTurn, PathKind::kTransit};

void add_place(Json& json, const GeoFrame& frame, const Eigen::Vector2d& p_W) {
  json["x_m"] = rounded(p_W.x(), 3);
  json["y_m"] = rounded(p_W.y(), 3);
  if (!frame.georeferenced || !p_W.allFinite()) return;
  const Eigen::Vector2d lon_lat_deg = wgs84_from_local(frame, {p_W}).front();
  json["longitude_deg"] = rounded(lon_lat_deg.x(), 8);
  json["latitude_deg"] = rounded(lon_lat_deg.y(), 8);
}

Json energy_json(const EnergyBalance& energy) {
  Json json;
  json["battery_j"] = energy.battery_j;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    json[energy_key(static_cast<EnergyCause>(i))] = energy.cause_j[i];
  }
  return json;
}

Json scenario_json(const RunReport& report) {
  const Scenario& scenario = report.scenario;
  Json json;
  json["name"] = scenario.name;
  json["field_area_m2"] = rounded(field_area_m2(report.field), 1);
  json["terrain"] = scenario.terrain.file.empty() ? scenario.terrain.generator
                                                  : scenario.terrain.file.filename().string();
  json["soil"] = scenario.soil;
  json["vehicle"] = scenario.vehicle;
  json["working_width_m"] = scenario.working_width_m;
  json["planner"] = scenario.planner.name;
  json["rate_hz"] = scenario.simulation.rate_hz;
  json["seed"] = scenario.seed;
  return json;
}

Json verdict_json(const RunReport& report) {
  Json json;
  json["grade"] = grade_name(report.verdict.grade);
  json["reasons"] = Json::array();
  for (const Reason& reason : report.verdict.reasons) {
    Json entry;
    entry["grade"] = grade_name(reason.grade);
    entry["figure"] = reason.figure;
    entry["value"] = reason.value;
    entry["limit"] = reason.limit;
    if (reason.time_s) entry["time_s"] = *reason.time_s;
    if (reason.p_W) add_place(entry, report.field.frame, *reason.p_W);
    entry["text"] = reason.text;
    json["reasons"].push_back(std::move(entry));
  }
  return json;
}

Json figures_json(const Metrics& given) {
  Metrics metrics = given;  // the key table hands out references
  Json json;
  for (const auto& figure : kFigures) json[figure.key] = figure.value(metrics);
  for (const auto& count : kCounts) json[count.key] = count.value(metrics);
  return json;
}

Json kinds_json(const Metrics& metrics) {
  Json json;
  for (const PathKind kind : kKinds) {
    const KindTotals& totals = metrics.by_kind[static_cast<std::size_t>(kind)];
    Json& entry = json[std::string(path_kind_name(kind))];
    entry["count"] = totals.count;
    entry["time_s"] = totals.time_s;
    entry["distance_m"] = totals.distance_m;
    entry["energy"] = energy_json(totals.energy);
  }
  return json;
}

Json totals_json(const RunRecord& given) {
  RunRecord run = given;  // the key table hands out references
  Json json;
  for (const auto& total : kTotals) json[total.key] = total.value(run);
  json["belly_contacts"] = run.peaks.belly_contacts;
  return json;
}

Json peaks_json(const Peaks& given, const GeoFrame& frame) {
  Peaks peaks = given;  // the key table hands out references
  Json json;
  for (const auto& entry : kPeaks) {
    const Peak& peak = entry.value(peaks);
    Json& written = json[entry.key];
    written["value"] = peak.value;
    written["time_s"] = peak.time_s;
    add_place(written, frame, peak.p_W);
  }
  return json;
}

Json path_json(const RunReport& report) {
  Json json;
  json["length_m"] = rounded(length_m(report.path), 3);
  json["violations"] = Json::array();
  for (const PathViolation& violation : report.path.violations) {
    Json entry;
    entry["what"] = violation.what;
    entry["overrun_m"] = violation.overrun_m;
    add_place(entry, report.field.frame, violation.p_W);
    json["violations"].push_back(std::move(entry));
  }
  return json;
}

// A parsed file and the way to a value in it, for messages.
struct Source {
  const std::filesystem::path& file;
  const Json& json;
  std::string key;

  Source at(const std::string& name) const {
    const std::string path = key.empty() ? name : key + "." + name;
    if (!json.is_object() || !json.contains(name)) {
      throw InputError(file.string(), path, "", "the key is missing");
    }
    return {file, json.at(name), path};
  }

  double number() const {
    if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (json.is_number()) return json.get<double>();
    throw InputError(file.string(), key, json_text(json), "a number is needed");
  }

  int count() const {
    const double value = number();
    if (value >= 0.0 && value <= std::numeric_limits<int>::max()) return static_cast<int>(value);
    throw InputError(file.string(), key, json_text(json), "a count from 0 is needed");
  }

  std::string word() const {
    if (json.is_string()) return json.get<std::string>();
    throw InputError(file.string(), key, json_text(json), "a word is needed");
  }
};

EnergyBalance read_energy(const Source& source) {
  EnergyBalance energy;
  energy.battery_j = source.at("battery_j").number();
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    energy.cause_j[i] = source.at(energy_key(static_cast<EnergyCause>(i))).number();
  }
  return energy;
}

Outcome read_outcome(const Source& source) {
  const std::string name = source.word();
  for (int i = 0; i <= static_cast<int>(Outcome::kInterrupted); ++i) {
    if (outcome_name(static_cast<Outcome>(i)) == name) return static_cast<Outcome>(i);
  }
  throw InputError(source.file.string(), source.key, name, "unknown outcome");
}

}  // namespace

Json metrics_json(const RunReport& report, const std::string& version) {
  Json json;
  json["headland"] = {{"version", version}};
  json["scenario"] = scenario_json(report);
  json["frame"] = frame_json(report.field.frame);
  json["outcome"] = {{"name", outcome_name(report.run.outcome)},
                     {"detail", report.run.outcome_detail}};
  json["verdict"] = verdict_json(report);
  json["figures"] = figures_json(report.metrics);
  json["by_kind"] = kinds_json(report.metrics);
  json["run"] = totals_json(report.run);
  json["energy"] = energy_json(report.run.energy);
  json["peaks"] = peaks_json(report.run.peaks, report.field.frame);
  json["path"] = path_json(report);
  return json;
}

RunRecord read_run_totals(const std::filesystem::path& file) {
  const Json json = parse_json(file);
  const Source top{file, json, ""};
  RunRecord run;
  run.outcome = read_outcome(top.at("outcome").at("name"));
  run.outcome_detail = top.at("outcome").at("detail").word();
  for (const auto& total : kTotals) total.value(run) = top.at("run").at(total.key).number();
  run.peaks.belly_contacts = top.at("run").at("belly_contacts").count();
  run.energy = read_energy(top.at("energy"));
  for (const auto& entry : kPeaks) {
    const Source source = top.at("peaks").at(entry.key);
    Peak& peak = entry.value(run.peaks);
    peak.value = source.at("value").number();
    peak.time_s = source.at("time_s").number();
    peak.p_W = {source.at("x_m").number(), source.at("y_m").number()};
  }
  return run;
}

Metrics read_metrics(const std::filesystem::path& file) {
  const Json json = parse_json(file);
  const Source top{file, json, ""};
  Metrics metrics;
  const Source figures = top.at("figures");
  for (const auto& figure : kFigures) figure.value(metrics) = figures.at(figure.key).number();
  for (const auto& count : kCounts) count.value(metrics) = figures.at(count.key).count();
  for (const PathKind kind : kKinds) {
    const Source source = top.at("by_kind").at(std::string(path_kind_name(kind)));
    KindTotals& totals = metrics.by_kind[static_cast<std::size_t>(kind)];
    totals.count = source.at("count").count();
    totals.time_s = source.at("time_s").number();
    totals.distance_m = source.at("distance_m").number();
    totals.energy = read_energy(source.at("energy"));
  }
  return metrics;
}

}  // namespace headland
