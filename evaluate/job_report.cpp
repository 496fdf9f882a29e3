#include "evaluate/job_plan.h"
#include "planner/worked_rows.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const JobPartRun& run) {
  constexpr double kJoulesPerWh = 3600.0;
  return {{"time_s", run.time_s},
          {"distance_m", run.distance_m},
          {"battery_wh", run.battery_j / kJoulesPerWh}};
}

void add(const JobPartRun& part, JobPartRun& sum) {
  sum.time_s += part.time_s;
  sum.distance_m += part.distance_m;
  sum.battery_j += part.battery_j;
}

}  // namespace

std::vector<JobPartRun> runs_of_parts(const JobPlan& job, const RunRecord& run) {
  std::vector<JobPartRun> parts(job.parts.size());
  for (const SegmentRecord& segment : run.segments) {
    const auto number = static_cast<std::size_t>(segment.segment);
    for (std::size_t i = 0; i < job.parts.size(); ++i) {
      const JobPart& part = job.parts[i];
      if (number < part.first_segment || number >= part.first_segment + part.segments) continue;
      add({segment.duration_s, segment.distance_m, segment.energy.battery_j}, parts[i]);
    }
  }
  return parts;
}

Json job_json(const JobPlan& job, const std::vector<JobPartRun>& runs, const std::string& version) {
  Json json{{"headland", {{"file", "job"}, {"version", version}}}, {"name", job.scenario.name}};
  json["parts"] = Json::array();
  double lengths_m[2] = {0.0, 0.0};
  double times_s[2] = {0.0, 0.0};
  JobPartRun driven[2];
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const JobPart& part = job.parts[i];
    Json entry;
    if (part.transit) {
      entry = {{"kind", "transit"}, {"from", part.from}, {"to", part.to}};
    } else {
      entry = {{"kind", "field"},
               {"name", part.name},
               {"area_m2", part.area_m2},
               {"passes", part.passes}};
    }
    entry["length_m"] = part.length_m;
    entry["expected_time_s"] = part.expected_time_s;
    entry["first_segment"] = part.first_segment;
    entry["segments"] = part.segments;
    if (!runs.empty()) entry["driven"] = run_json(runs[i]);
    json["parts"].push_back(std::move(entry));
    const std::size_t kind = part.transit ? 1 : 0;
    lengths_m[kind] += part.length_m;
    times_s[kind] += part.expected_time_s;
    area_m2 += part.area_m2;
    if (!runs.empty()) add(runs[i], driven[kind]);
  }
  json["totals"]["area_m2"] = area_m2;
  json["totals"]["road_length_m"] = job.road_length_m;
  for (const std::size_t kind : {0, 1}) {
    Json sum{{"length_m", lengths_m[kind]}, {"expected_time_s", times_s[kind]}};
    if (!runs.empty()) sum["driven"] = run_json(driven[kind]);
    json["totals"][kind == 0 ? "fields" : "transits"] = std::move(sum);
  }
  json["left_out_m2"] = left_out_m2(job.path);
  json["over_worked_rows_m"] =
      driven_over_worked(job.stage.field, job.stage.vehicle, job.path).length_m;
  json["abrupt_turns"] = job.path.abrupt_turns;
  json["abrupt_joints"] = job.path.abrupt_joints;
  json["violations"] = job.path.violations.size();
  json["notes"] = job.stage.notes;
  return json;
}

}  // namespace headland
