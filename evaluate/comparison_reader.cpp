#include "evaluate/comparison_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "evaluate/comparison_fields.h"
#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_maps.h"
#include "evaluate/comparison_planners.h"
#include "evaluate/planner_cost.h"
#include "evaluate/scenario_grid.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTopKeys = {"name",   "seed", "repeats", "start", "end",
                                           "closed", "maps", "fields",  "parts", "planners",
                                           "cost",   "stop", "budget",  "tests", "drive"};
const std::vector<std::string> kCostKeys = {"file", "objective", "repeat",
                                            "turn", "u_turn",    "tractor"};
const std::vector<std::string> kTestKeys = {"figure", "blocks", "control", "alpha"};

constexpr std::array kTractorKeys{TractorKey{"mass_kg", &TractorEnergy::mass_kg},
                                  TractorKey{"friction", &TractorEnergy::friction},
                                  TractorKey{"gravity_m_s2", &TractorEnergy::gravity_m_s2},
                                  TractorKey{"turn_speed_m_s", &TractorEnergy::turn_speed_m_s},
                                  TractorKey{"voltage_v", &TractorEnergy::voltage_v},
                                  TractorKey{"turn_current_a", &TractorEnergy::turn_current_a},
                                  TractorKey{"length_weight", &TractorEnergy::length_weight},
                                  TractorKey{"height_weight", &TractorEnergy::height_weight},
                                  TractorKey{"turn_weight", &TractorEnergy::turn_weight}};

std::vector<std::string> tractor_keys() {
  std::vector<std::string> keys(kTractorKeys.size());
  std::transform(kTractorKeys.begin(), kTractorKeys.end(), keys.begin(),
                 [](const TractorKey& key) { return std::string(key.key); });
  return keys;
}

void read_maps(const YamlSection& top, Comparison& comparison) {
  const MapDefaults defaults{read_corner(top, "start"), read_corner(top, "end"),
                             comparison.drive ? comparison.drive->working_width_m : 1.0,
                             read_flag(top, "closed").value_or(false)};
  std::vector<std::string> names;
  for (const YamlSection& section :
       read_sections(top, "maps").value_or(std::vector<YamlSection>{})) {
    for (ComparedMap& map : read_compared_maps(section, defaults, comparison.seed)) {
      names.push_back(map.name);
      comparison.maps.push_back(std::move(map));
    }
  }
  if (names.empty()) {
    throw InputError(top.source, place_of(top, "maps"), "",
                     "a list with at least one map is needed");
  }
  refuse_repeated(top, "maps", "name", names);
}

void read_fields(const YamlSection& top, Comparison& comparison) {
  const FieldDefaults defaults{read_place(top, "start"), read_place(top, "end"),
                               read_parts_options(top, {})};
  std::vector<std::string> names;
  for (const YamlSection& section :
       read_sections(top, "fields").value_or(std::vector<YamlSection>{})) {
    for (ComparedMap& field : read_compared_fields(section, defaults, comparison.seed)) {
      names.push_back(field.name);
      comparison.maps.push_back(std::move(field));
    }
  }
  if (names.empty()) {
    throw InputError(top.source, place_of(top, "fields"), "",
                     "a list with at least one field is needed");
  }
  refuse_repeated(top, "fields", "name", names);
}

void read_tests(const YamlSection& top, Comparison& comparison) {
  const auto section = read_section(top, "tests");
  if (!section) return;
  refuse_unknown_keys(*section, kTestKeys);
  ComparisonTests& tests = comparison.tests;
  tests.figure = read_word(*section, "figure").value_or(tests.figure);
  const FigureOf of = find_figure(tests.figure, top.source, place_of(*section, "figure")).of;
  if (of == FigureOf::kDrive) {
    throw InputError(top.source, place_of(*section, "figure"), tests.figure,
                     "a figure of plans; only the best ones are driven");
  }
  if (of == (is_of_fields(comparison) ? FigureOf::kGridPlan : FigureOf::kRegionPlan)) {
    throw InputError(top.source, place_of(*section, "figure"), tests.figure,
                     is_of_fields(comparison) ? "no figure of plans on fields"
                                              : "no figure of plans on grid maps");
  }
  tests.blocks = read_choice(*section, "blocks", BlockKind::kMaps,
                             {{"maps", BlockKind::kMaps}, {"runs", BlockKind::kRuns}});
  tests.alpha = read_number(*section, "alpha", {0.001, 0.5}).value_or(tests.alpha);
  tests.control = read_word(*section, "control").value_or("");
  if (tests.control.empty()) return;
  std::vector<std::string> labels;
  for (const ComparedPlanner& planner : comparison.planners) labels.push_back(planner.label);
  if (std::find(labels.begin(), labels.end(), tests.control) != labels.end()) return;
  throw InputError(top.source, place_of(*section, "control"), tests.control,
                   fmt::format("none of the planners' labels; did you mean '{}'? (known: {})",
                               nearest_name(tests.control, labels), fmt::join(labels, ", ")));
}

}  // namespace

std::span<const TractorKey> tractor_energy_keys() { return kTractorKeys; }

GridCost read_grid_cost(const YamlSection& top) {
  GridCost cost;
  const YAML::Node given = top.node;
  if (given["cost"].IsDefined() && given["cost"].IsScalar()) {
    cost.objective = GridObjective::kMeasured;  // by the file of that name
    return cost;
  }
  const auto section = read_section(top, "cost");
  if (!section) return cost;
  refuse_unknown_keys(*section, kCostKeys);
  const YAML::Node keys = section->node;
  const bool measured = keys["file"].IsDefined();
  if (measured && !keys["objective"].IsDefined()) cost.objective = GridObjective::kMeasured;
  if (keys["objective"].IsDefined()) {
    cost.objective = read_choice(*section, "objective", GridObjective::kLength,
                                 {{"length", GridObjective::kLength},
                                  {"weighted", GridObjective::kWeighted},
                                  {"tractor", GridObjective::kTractor},
                                  {"measured", GridObjective::kMeasured}});
  }
  if (cost.objective == GridObjective::kMeasured && !measured) {
    throw InputError(top.source, place_of(*section, "objective"), "measured",
                     "needs cost.file, measured costs as headland measure writes them");
  }
  const auto only_of = [&](std::string_view key, GridObjective objective, const char* word) {
    const YAML::Node node = section->node;
    if (!node[std::string(key)].IsDefined()) return;
    if (measured) {
      throw InputError(top.source, place_of(*section, key), "",
                       "not with cost.file, which has the measured values of the terms");
    }
    if (cost.objective == objective) return;
    throw InputError(top.source, place_of(*section, key), "",
                     fmt::format("only with cost.objective: {}", word));
  };
  constexpr NumberRange kWeight{0.0, 1e6};
  for (const auto& [key, weight] : {std::pair{"repeat", &cost.weights.repeat},
                                    {"turn", &cost.weights.turn},
                                    {"u_turn", &cost.weights.u_turn}}) {
    only_of(key, GridObjective::kWeighted, "weighted");
    *weight = read_number(*section, key, kWeight).value_or(*weight);
  }
  only_of("tractor", GridObjective::kTractor, "tractor");
  if (const auto tractor = read_section(*section, "tractor")) {
    refuse_unknown_keys(*tractor, tractor_keys());
    for (const TractorKey& key : kTractorKeys) {
      double& value = cost.tractor.*key.value;
      value = read_number(*tractor, key.key, {0.0, 1e6}).value_or(value);
    }
  }
  if (!measured) {
    check_grid_cost(cost, top.source, place_of_itself(*section));
  }
  return cost;
}

void take_measured_costs(const fs::path& file, Comparison& comparison) {
  std::vector<std::string> notes;
  const Vehicle vehicle = comparison.drive ? vehicle_of(*comparison.drive, comparison.file.string())
                                           : load_vehicle(read_cost_table(file).vehicle);
  const std::string soil = comparison.drive ? soil_text(comparison.drive->soil) : "";
  comparison.cost_file = file;
  comparison.cost.measured = read_drive_cost(file, vehicle, soil, notes);
  for (ComparedMap& map : comparison.maps) {
    if (map.region) map.region->cost = comparison.cost.measured;
  }
  if (comparison.drive) comparison.notes = notes;
}

Comparison read_comparison(const fs::path& file, std::optional<std::uint64_t> seed) {
  const YamlSection top = read_yaml(file);
  refuse_unknown_keys(top, kTopKeys);
  Comparison comparison;
  comparison.file = file;
  comparison.name = read_word(top, "name").value_or(file.stem().string());
  comparison.seed = read_whole_number(top, "seed").value_or(comparison.seed);
  comparison.seed = seed.value_or(comparison.seed);
  comparison.repeats = read_count(top, "repeats", 1, kMostRepeats).value_or(comparison.repeats);
  comparison.cost = read_grid_cost(top);
  if (const auto drive = read_section(top, "drive")) {
    comparison.drive = read_drive(*drive, comparison.seed);
  }
  read_compared_planners(top, comparison);
  const YAML::Node node = top.node;
  if (node["fields"].IsDefined()) {
    read_fields(top, comparison);
  } else {
    if (node["parts"].IsDefined()) {
      throw InputError(top.source, place_of(top, "parts"), "", "only with fields");
    }
    read_maps(top, comparison);
  }
  const fs::path costs = read_cost_file(top, fs::absolute(file).parent_path());
  if (!costs.empty() && !fs::exists(costs)) {
    throw InputError(top.source, place_of(top, "cost"), costs.string(), "no such file");
  }
  if (!costs.empty()) take_measured_costs(costs, comparison);
  read_tests(top, comparison);
  return comparison;
}

std::vector<std::string> comparison_key_paths() {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) paths.push_back(prefix + key);
  };
  add("", kTopKeys);
  add("cost.", kCostKeys);
  add("cost.tractor.", tractor_keys());
  add("tests.", kTestKeys);
  for (const auto& more :
       {compared_planner_key_paths(), compared_map_key_paths(), compared_field_key_paths()}) {
    paths.insert(paths.end(), more.begin(), more.end());
  }
  return paths;
}

std::string name_in_files(std::string_view name) {
  std::string text;
  for (const char letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '-' || letter == '.';
    text += plain ? letter : '_';
  }
  return text;
}

}  // namespace headland
