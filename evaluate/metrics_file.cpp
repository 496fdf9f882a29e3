#include "evaluate/metrics_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "evaluate/geojson.h"
#include "evaluate/place_json.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

// Keys of the totals and peaks: one table serves writing and reading.
struct TotalKey {
  const char* key;
  double RunRecord::*value;
};
constexpr TotalKey kTotals[] = {
    {"duration_s", &RunRecord::duration_s},
    {"distance_m", &RunRecord::distance_m},
    {"soc_start", &RunRecord::soc_start},
    {"soc_end", &RunRecord::soc_end},
    {"rested_voltage_start_v", &RunRecord::rested_voltage_start_v},
    {"rested_voltage_end_v", &RunRecord::rested_voltage_end_v},
};

struct PeakKey {
  const char* key;
  Peak Peaks::*value;
};
constexpr PeakKey kPeaks[] = {
    {"slip", &Peaks::slip},
    {"load_transfer_ratio", &Peaks::load_transfer_ratio},
    {"cross_track_working_m", &Peaks::cross_track_working_m},
    {"cross_track_turning_m", &Peaks::cross_track_turning_m},
    {"boundary_overrun_m", &Peaks::boundary_overrun_m},
    {"belly_contact_m", &Peaks::belly_contact_m},
    {"implement_overhang_m", &Peaks::implement_overhang_m},
    {"battery_power_w", &Peaks::battery_power_w},
    {"roll_rad", &Peaks::roll_rad},
    {"pitch_rad", &Peaks::pitch_rad},
    {"min_voltage_v", &Peaks::min_voltage_v},
};

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
  json["soil"] = soil_text(scenario.soil);
  json["vehicle"] = scenario.vehicle;
  json["working_width_m"] = scenario.working_width_m;
  if (scenario.path_file.empty()) {
    json["planner"] = scenario.planner.name;
  } else {
    json["path"] = scenario.path_file.filename().string();
  }
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

Json figures_json(const Metrics& metrics) {
  Json json;
  json["workable_m2"] = metrics.coverage.workable_m2;
  json["covered_m2"] = metrics.coverage.covered_m2;
  json["missed_m2"] = metrics.coverage.missed_m2;
  json["overlap_m2"] = metrics.coverage.overlap_m2;
  json["outside_m2"] = metrics.coverage.outside_m2;
  json["coverage_ratio"] = metrics.coverage_ratio;
  json["overlap_ratio"] = metrics.overlap_ratio;
  json["distance_m"] = metrics.distance_m;
  json["time_s"] = metrics.time_s;
  json["energy_wh"] = metrics.energy_wh;
  json["energy_wh_per_ha"] = metrics.energy_wh_per_ha;
  json["delta_soc"] = metrics.delta_soc;
  json["rested_voltage_drop_v"] = metrics.rested_voltage_drop_v;
  json["worst_slip"] = metrics.worst_slip;
  json["worst_load_transfer"] = metrics.worst_load_transfer;
  json["track_rms_working_m"] = metrics.track_rms_working_m;
  json["track_rms_turning_m"] = metrics.track_rms_turning_m;
  json["ledger_residual_ratio"] = metrics.ledger_residual_ratio;
  json["turns"] = metrics.turns;
  json["u_turns"] = metrics.u_turns;
  return json;
}

Json kinds_json(const Metrics& metrics) {
  Json json;
  for (const PathKind kind : kEveryPathKind) {
    const KindTotals& totals = metrics.by_kind[static_cast<std::size_t>(kind)];
    Json& entry = json[std::string(path_kind_name(kind))];
    entry["count"] = totals.count;
    entry["time_s"] = totals.time_s;
    entry["distance_m"] = totals.distance_m;
    entry["energy"] = energy_json(totals.energy);
  }
  return json;
}

Json totals_json(const RunRecord& run) {
  Json json;
  for (const TotalKey& total : kTotals) json[total.key] = run.*total.value;
  json["motor_clipped_s"] = run.peaks.motor_clipped_s;
  json["belly_contacts"] = run.peaks.belly_contacts;
  json["overrun_in_hole"] = run.peaks.overrun_in_hole;
  json["load_transfer_of_trailer"] = run.peaks.load_transfer_of_trailer;
  return json;
}

Json peaks_json(const Peaks& peaks, const GeoFrame& frame) {
  Json json;
  for (const PeakKey& entry : kPeaks) {
    const Peak& peak = peaks.*entry.value;
    Json& written = json[entry.key];
    written["value"] = peak.value;
    written["time_s"] = peak.time_s;
    add_place(written, frame, peak.p_W);
  }
  return json;
}

// The machine at rest: what its numbers alone say of tipping.
Json stability_json(const Vehicle& vehicle) {
  return {{"side_stability_angle_rad", side_stability_angle_rad(vehicle)},
          {"nose_up_stability_angle_rad", nose_up_stability_angle_rad(vehicle)}};
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

  bool flag() const {
    if (json.is_boolean()) return json.get<bool>();
    throw InputError(file.string(), key, json_text(json), "true or false is needed");
  }

  int count() const {
    const double value = number();
    const bool whole = value >= 0.0 && value == std::floor(value);
    if (whole && value <= std::numeric_limits<int>::max()) return static_cast<int>(value);
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
  json["stability"] = stability_json(report.vehicle);
  json["path"] = path_json(report);
  json["notes"] = report.notes;
  return json;
}

RunRecord read_run_totals(const std::filesystem::path& file) {
  const Json json = parse_json(file);
  const Source top{file, json, ""};
  RunRecord run;
  run.outcome = read_outcome(top.at("outcome").at("name"));
  run.outcome_detail = top.at("outcome").at("detail").word();
  for (const TotalKey& total : kTotals) run.*total.value = top.at("run").at(total.key).number();
  run.peaks.motor_clipped_s = top.at("run").at("motor_clipped_s").number();
  run.peaks.belly_contacts = top.at("run").at("belly_contacts").count();
  run.peaks.overrun_in_hole = top.at("run").at("overrun_in_hole").flag();
  run.peaks.load_transfer_of_trailer = top.at("run").at("load_transfer_of_trailer").flag();
  run.energy = read_energy(top.at("energy"));
  for (const PeakKey& entry : kPeaks) {
    const Source source = top.at("peaks").at(entry.key);
    Peak& peak = run.peaks.*entry.value;
    peak.value = source.at("value").number();
    peak.time_s = source.at("time_s").number();
    peak.p_W = {source.at("x_m").number(), source.at("y_m").number()};
  }
  return run;
}

}  // namespace headland
