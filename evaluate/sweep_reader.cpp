#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>
#include <utility>

#include "evaluate/scenario_parts.h"
#include "evaluate/scenario_soil.h"
#include "evaluate/sweep.h"
#include "evaluate/sweep_keys.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTopKeys = {"name",       "fields",      "terrains", "soils",
                                           "vehicles",   "planners",    "seeds",    "path",
                                           "simulation", "positioning", "coverage", "verdict"};
const std::vector<std::string> kVehicleKeys = {"vehicle", "implement", "cost"};
const std::vector<std::string> kSeedKeys = {"first", "count"};
// What of a scenario holds for all runs.
constexpr const char* kCommonKeys[] = {"path", "simulation", "positioning", "coverage", "verdict"};

// SQLite's whole numbers end here.
constexpr std::uint64_t kMostSeed = std::numeric_limits<std::int64_t>::max();

YAML::Node value_of(const YamlSection& section, std::string_view key) {
  const YAML::Node mapping = section.node;
  return mapping[std::string(key)];
}

// An entry of the matrix: what stands under its label, or the label itself in a list of words.
struct Entry {
  std::string label;
  YAML::Node value;
};

void check_label(const YamlSection& top, std::string_view key, const std::string& label) {
  constexpr std::size_t kLongest = 80;
  const bool plain = std::ranges::none_of(
      label, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
  if (!label.empty() && label.size() <= kLongest && plain) return;
  throw InputError(top.source, place_of(top, key), label,
                   fmt::format("a label has 1 to {} characters, all printable", kLongest));
}

std::vector<Entry> read_entries(const YamlSection& top, const std::string& key,
                                const std::string& word_for, const char* default_word = nullptr) {
  std::vector<Entry> entries;
  const YAML::Node node = value_of(top, key);
  const std::string wanted = fmt::format("labels with {} each, or a list of words", word_for);
  if (!node.IsDefined() && default_word != nullptr) {
    return {{default_word, YAML::Node(default_word)}};
  }
  if (node.IsDefined() && node.IsMap()) {
    for (const auto& entry : node) entries.push_back({entry.first.as<std::string>(), entry.second});
  } else if (node.IsDefined() && node.IsSequence()) {
    for (const YAML::Node& item : node) {
      if (!item.IsScalar()) throw InputError(top.source, place_of(top, key), "", wanted);
      entries.push_back({item.Scalar(), item});
    }
  }
  if (entries.empty()) throw InputError(top.source, place_of(top, key), "", wanted);
  std::set<std::string> seen;
  for (const Entry& entry : entries) {
    check_label(top, key, entry.label);
    if (seen.insert(entry.label).second) continue;
    throw InputError(top.source, place_of(top, key), entry.label, "the label stands twice");
  }
  return entries;
}

// A scenario with this one section in it; a word stands for a section with `word_key`.
YamlSection section_alone(const YamlSection& top, const std::string& name, const YAML::Node& value,
                          const char* word_key = nullptr) {
  YAML::Node scenario(YAML::NodeType::Map);
  if (word_key != nullptr && value.IsScalar()) {
    YAML::Node section(YAML::NodeType::Map);
    section[word_key] = value;
    scenario[name] = section;
  } else {
    scenario[name] = value;
  }
  return {top.source, "", scenario};
}

// What a default would quietly stand in for.
void require_one_of(const YamlSection& scenario, const std::string& name,
                    const std::vector<std::string>& keys) {
  const auto section = read_section(scenario, name, "a word or a section of keys");
  if (std::ranges::any_of(
          keys, [&](const std::string& key) { return value_of(*section, key).IsDefined(); })) {
    return;
  }
  throw InputError(scenario.source, place_of_itself(*section), "",
                   fmt::format("{} is needed", fmt::join(keys, " or ")));
}

void read_terrains(const YamlSection& top, const fs::path& folder, Sweep& sweep) {
  for (const Entry& entry : read_entries(top, "terrains", "a scenario's terrain", "flat")) {
    const YamlSection alone = section_alone(top, "terrain", entry.value, "generator");
    require_one_of(alone, "terrain", {"generator", "file"});
    Scenario scenario;
    read_terrain_source(alone, folder, scenario);
    const bool own_seed = value_of(*read_section(alone, "terrain"), "seed").IsDefined();
    sweep.terrains.push_back({entry.label, scenario.terrain, own_seed});
  }
}

void read_soils(const YamlSection& top, const fs::path& folder, Sweep& sweep) {
  for (const Entry& entry : read_entries(top, "soils", "a scenario's soil", "firm")) {
    sweep.soils.push_back(
        {entry.label, read_soil_source(section_alone(top, "soil", entry.value), folder)});
  }
}

void read_seeds(const YamlSection& top, Sweep& sweep) {
  const YAML::Node node = value_of(top, "seeds");
  if (!node.IsDefined()) {
    sweep.seeds = {1};
    return;
  }
  if (node.IsMap()) {
    const YamlSection section = *read_section(top, "seeds");
    refuse_unknown_keys(section, kSeedKeys);
    const auto count = read_count(section, "count", 1, static_cast<int>(kMostCells));
    if (!count) {
      throw InputError(top.source, place_of(section, "count"), "", "how many seeds is missing");
    }
    const std::uint64_t first = read_whole_number(section, "first").value_or(1);
    for (int i = 0; i < *count; ++i) sweep.seeds.push_back(first + static_cast<std::uint64_t>(i));
  } else if (node.IsSequence()) {
    for (const YAML::Node& item : node) {
      sweep.seeds.push_back(*read_whole_number(section_alone(top, "seeds", item), "seeds"));
    }
  }
  const std::set<std::uint64_t> distinct(sweep.seeds.begin(), sweep.seeds.end());
  if (!distinct.empty() && distinct.size() == sweep.seeds.size() &&
      *distinct.rbegin() <= kMostSeed) {
    return;
  }
  throw InputError(top.source, place_of(top, "seeds"), "",
                   fmt::format("a list of different whole numbers from 0 to {}, or {{first, "
                               "count}}, is needed",
                               kMostSeed));
}

// The keys of a scenario that are the same for all runs by this vehicle.
YamlSection drive_of(const YamlSection& top, const Entry& vehicle) {
  YAML::Node drive(YAML::NodeType::Map);
  if (vehicle.value.IsMap()) {
    const YamlSection section{top.source, "vehicles", vehicle.value};
    refuse_unknown_keys(section, kVehicleKeys);
    for (const char* key : {"vehicle", "implement"}) {
      const YAML::Node value = value_of(section, key);
      if (value.IsDefined()) drive[key] = value;
    }
  } else {
    drive["vehicle"] = vehicle.value;
  }
  for (const char* key : kCommonKeys) {
    const YAML::Node value = value_of(top, key);
    if (value.IsDefined()) drive[key] = value;
  }
  return {top.source, "", drive};
}

struct FieldEntry {
  YamlSection section;
  FieldSource source;
};

std::vector<FieldEntry> read_fields(const YamlSection& top, const fs::path& folder, Sweep& sweep) {
  std::vector<FieldEntry> fields;
  for (const Entry& entry : read_entries(top, "fields", "a scenario's field")) {
    const YamlSection alone = section_alone(top, "field", entry.value, "file");
    fields.push_back({alone, read_field_source(alone, folder)});
    sweep.fields.push_back(entry.label);
  }
  return fields;
}

std::vector<PlannerChoice> read_planners(const YamlSection& top, Sweep& sweep) {
  std::vector<PlannerChoice> planners;
  for (const Entry& entry : read_entries(top, "planners", "a scenario's planner")) {
    const YamlSection alone = section_alone(top, "planner", entry.value, "name");
    require_one_of(alone, "planner", {"name"});
    planners.push_back(read_planner(alone));
    sweep.planners.push_back(entry.label);
  }
  return planners;
}

void read_matrix(const YamlSection& top, const fs::path& folder, Sweep& sweep) {
  const std::vector<FieldEntry> fields = read_fields(top, folder, sweep);
  const std::vector<PlannerChoice> planners = read_planners(top, sweep);
  std::vector<std::pair<Scenario, Vehicle>> drives;
  for (const Entry& entry : read_entries(top, "vehicles", "a scenario's vehicle")) {
    Scenario drive = read_drive(drive_of(top, entry), 1);
    if (entry.value.IsMap()) {
      drive.planner.cost_file =
          read_file_name({top.source, "vehicles", entry.value}, "cost", folder);
    }
    drives.emplace_back(drive, vehicle_of(drive, top.source));
    sweep.vehicles.push_back(entry.label);
  }
  for (const FieldEntry& field : fields) {
    for (const auto& [drive, vehicle] : drives) {
      for (const PlannerChoice& planner : planners) {
        Scenario& scenario = sweep.scenarios.emplace_back(drive);
        scenario.field = field.source;
        scenario.planner = planner;
        if (planner.cost_file.empty() && !drive.planner.cost_file.empty()) {
          plan_by_costs(drive.planner.cost_file, scenario.planner);
        }
        read_grid_map_numbers(field.section, vehicle, scenario);
      }
    }
  }
}

}  // namespace

Sweep read_sweep(const fs::path& file) { return read_sweep(read_yaml(file)); }

Sweep read_sweep(const YamlSection& top) {
  const fs::path file = top.source;
  refuse_unknown_keys(top, kTopKeys);
  const fs::path folder = fs::absolute(file).parent_path();
  Sweep sweep;
  sweep.file = file;
  sweep.name = read_word(top, "name").value_or(file.stem().string());
  check_label(top, "name", sweep.name);
  read_seeds(top, sweep);
  read_terrains(top, folder, sweep);
  read_soils(top, folder, sweep);
  read_matrix(top, folder, sweep);
  if (cell_count(sweep) <= kMostCells) return sweep;
  throw InputError(file.string(), "", fmt::format("{} runs", cell_count(sweep)),
                   fmt::format("at most {} in one sweep", kMostCells));
}

std::vector<std::string> sweep_key_paths() {
  std::vector<std::string> paths = kTopKeys;
  for (const std::string& key : kVehicleKeys) paths.push_back("vehicles." + key);
  for (const std::string& key : kSeedKeys) paths.push_back("seeds." + key);
  return paths;
}

}  // namespace headland
