#include "evaluate/job_spec.h"

#include <fmt/format.h>

#include "evaluate/scenario_parts.h"
#include "evaluate/yaml_section.h"
#include "planner/visit_order.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kOwnKeys = {"name",         "seed",  "crs",   "fields", "roads",
                                           "road_width_m", "order", "start", "end",    "planner"};
const std::vector<std::string> kFieldKeys = {"name", "field", "gates", "planner"};

PlannerChoice planner_of(const YamlSection& section, const YamlSection& top) {
  const YAML::Node mapping = section.node;
  const YamlSection& holder = mapping["planner"].IsDefined() ? section : top;
  PlannerChoice planner = read_planner(holder);
  if (planner.grid) {
    throw InputError(top.source, place_of(holder, "planner"), planner.name,
                     "jobs are planned on fields, not on grid maps");
  }
  return planner;
}

JobField field_of(const YamlSection& entry, const YamlSection& top, const fs::path& folder,
                  std::size_t number) {
  // Its keys are told as a scenario's.
  const YamlSection section{entry.source, "", entry.node};
  refuse_unknown_keys(section, kFieldKeys);
  JobField field;
  field.place = place_of_itself(entry);
  field.source = read_field_source(section, folder);
  if (!field.source.grid_map.empty()) {
    throw InputError(top.source, place_of(section, "field"), "field.grid_map",
                     "jobs are of fields, not of grid maps");
  }
  if (field.source.entry) {
    throw InputError(top.source, field.source.entry_place, "", "the gates say where it is entered");
  }
  const std::string part = field.source.part;
  field.name =
      read_word(section, "name").value_or(part.empty() ? fmt::format("field {}", number) : part);
  field.planner = planner_of(section, top);
  field.gates = read_points(section, "gates").value_or(std::vector<Eigen::Vector2d>{});
  if (field.gates.empty() || field.gates.size() > kMostGates) {
    throw InputError(top.source, place_of(section, "gates"),
                     fmt::format("{} gates", field.gates.size()),
                     fmt::format("from 1 to {} points [x, y] on the boundary", kMostGates));
  }
  return field;
}

void check_fields(const YamlSection& top, const JobSpec& job) {
  if (job.fields.empty() || job.fields.size() > kMostJobFields) {
    throw InputError(top.source, place_of(top, "fields"), fmt::format("{}", job.fields.size()),
                     fmt::format("from 1 to {} fields, each with field and gates", kMostJobFields));
  }
  for (std::size_t i = 0; i < job.fields.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (job.fields[i].name != job.fields[k].name) continue;
      throw InputError(top.source, job.fields[i].place, job.fields[i].name,
                       "two fields have this name; give each its own");
    }
  }
  if (!job.order_given && job.fields.size() > kMostOrdered) {
    throw InputError(
        top.source, place_of(top, "order"), fmt::format("{} fields", job.fields.size()),
        fmt::format("the best order is found for at most {}; give order: given", kMostOrdered));
  }
}

void check_roads(const YamlSection& top, const JobSpec& job) {
  std::size_t points = 0;
  for (const auto& road : job.roads) {
    points += road.size();
    if (road.size() >= 2) continue;
    throw InputError(top.source, place_of(top, "roads"), fmt::format("{} points", road.size()),
                     "a road is a line of at least two points [x, y]");
  }
  if (points <= kMostRoadPoints) return;
  throw InputError(top.source, place_of(top, "roads"), fmt::format("{} points", points),
                   fmt::format("at most {}; leave out roads that lead elsewhere", kMostRoadPoints));
}

}  // namespace

JobSpec read_job(const fs::path& file, std::optional<std::uint64_t> seed) {
  const YamlSection top = read_yaml(file);
  const fs::path folder = fs::absolute(file).parent_path();
  JobSpec job;
  job.common = read_drive(top, seed.value_or(read_whole_number(top, "seed").value_or(1)), kOwnKeys);
  job.common.file = file;
  job.common.name = read_word(top, "name").value_or(file.stem().string());
  job.crs = read_crs(top);
  const auto entries = read_sections(top, "fields");
  for (const YamlSection& entry : entries.value_or(std::vector<YamlSection>{})) {
    job.fields.push_back(field_of(entry, top, folder, job.fields.size() + 1));
  }
  job.roads = read_point_lists(top, "roads").value_or(job.roads);
  job.road_width_m = read_number(top, "road_width_m", {kLeastRoadWidth_m, kMostRoadWidth_m})
                         .value_or(job.road_width_m);
  job.order_given = read_choice(top, "order", false, {{"shortest", false}, {"given", true}});
  job.start = read_point(top, "start");
  job.end = read_point(top, "end");
  check_fields(top, job);
  check_roads(top, job);
  return job;
}

std::vector<std::string> job_key_paths() {
  std::vector<std::string> paths = kOwnKeys;
  for (const std::string& key : kFieldKeys) paths.push_back("fields." + key);
  return paths;
}

}  // namespace headland
