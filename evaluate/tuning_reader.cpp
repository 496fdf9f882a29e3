#include <fmt/format.h>

#include <algorithm>

#include "evaluate/comparison_planners.h"
#include "evaluate/run_key.h"
#include "evaluate/scenario_parts.h"
#include "evaluate/tuning.h"
#include "evaluate/yaml_section.h"
#include "planner/grid_planners.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTuningKeys = {
    "name",     "seed",    "vehicle",    "implement",   "costs",   "training",
    "held_out", "planner", "forms",      "plans",       "search",  "bootstrap",
    "shuffles", "path",    "simulation", "positioning", "coverage"};
const std::vector<std::string> kSetKeys = {"fields", "terrains", "soils", "seeds"};
const std::vector<std::string> kPlanKeys = {"planners", "variations", "iterations", "perturbed"};
const std::vector<std::string> kSearchKeys = {"evaluations"};
constexpr const char* kSharedKeys[] = {"path", "simulation", "positioning", "coverage"};

constexpr int kMostVariations = 1000;
constexpr int kMostPerturbed = 10'000;
constexpr int kMostIterations = 1'000'000;
constexpr int kMostEvaluations = 10'000;
constexpr int kLeastDraws = 100;
constexpr int kMostDraws = 100'000;
constexpr int kMostShuffles = 100;

YAML::Node node_of(const YamlSection& section, const char* key) {
  const YAML::Node mapping = section.node;
  return mapping[key];
}

// The set as a sweep's file has it, with what holds for both sets.
Sweep read_set(const YamlSection& top, const char* name) {
  const auto section = read_section(top, name, "fields, terrains, soils and seeds");
  if (!section) {
    throw InputError(top.source, place_of(top, name), "",
                     "missing: weights are fitted on the fields of training and proven on those of "
                     "held_out");
  }
  refuse_unknown_keys(*section, kSetKeys);
  if (!node_of(*section, "fields").IsDefined()) {
    throw InputError(top.source, place_of(*section, "fields"), "",
                     "labels with a scenario's field");
  }
  YAML::Node sweep(YAML::NodeType::Map);
  for (const std::string& key : kSetKeys) {
    const YAML::Node value = node_of(*section, key.c_str());
    if (value.IsDefined()) sweep[key] = value;
  }
  for (const char* key : kSharedKeys) {
    const YAML::Node value = node_of(top, key);
    if (value.IsDefined()) sweep[key] = value;
  }
  YAML::Node vehicle(YAML::NodeType::Map);
  for (const char* key : {"vehicle", "implement"}) {
    const YAML::Node value = node_of(top, key);
    if (value.IsDefined()) vehicle[key] = value;
  }
  sweep["name"] = name;
  sweep["vehicles"]["vehicle"] = vehicle;
  sweep["planners"].push_back("grid_boustrophedon");
  return read_sweep(YamlSection{top.source, name, sweep});
}

void refuse_shared_fields(const YamlSection& top, const Tuning& tuning) {
  ContentDigests digests;
  const auto key = [&](const Sweep& set, std::size_t field) {
    Scenario scenario = tuning.training.scenarios.front();
    scenario.field = set.scenarios[field].field;
    return run_key(scenario, digests);
  };
  for (std::size_t i = 0; i < tuning.training.fields.size(); ++i) {
    for (std::size_t j = 0; j < tuning.held_out.fields.size(); ++j) {
      if (key(tuning.training, i) != key(tuning.held_out, j)) continue;
      const YamlSection held_out = read_section(top, "held_out").value();
      throw InputError(top.source, place_of(held_out, "fields"), tuning.held_out.fields[j],
                       fmt::format("fields that are not in training are needed; this is its {}",
                                   tuning.training.fields[i]));
    }
  }
}

void read_forms(const YamlSection& top, Tuning& tuning) {
  const std::vector<std::string> words = {"weighted", "tractor", "length", "measured"};
  const std::vector<GridObjective> forms = {GridObjective::kWeighted, GridObjective::kTractor,
                                            GridObjective::kLength, GridObjective::kMeasured};
  const YAML::Node given = node_of(top, "forms");
  if (!given.IsDefined()) {
    tuning.forms = forms;
    return;
  }
  if (given.IsSequence()) {
    for (const YAML::Node& item : given) {
      const auto found =
          std::find(words.begin(), words.end(), item.IsScalar() ? item.Scalar() : "");
      if (found == words.end()) {
        throw InputError(top.source, place_of(top, "forms"), item.IsScalar() ? item.Scalar() : "",
                         fmt::format("one of {}", fmt::join(words, ", ")));
      }
      const GridObjective form = forms[static_cast<std::size_t>(found - words.begin())];
      if (std::find(tuning.forms.begin(), tuning.forms.end(), form) == tuning.forms.end()) {
        tuning.forms.push_back(form);
      }
    }
  }
  if (!tuning.forms.empty()) return;
  throw InputError(top.source, place_of(top, "forms"), "",
                   fmt::format("a list of some of {}", fmt::join(words, ", ")));
}

void read_training_plans(const YamlSection& top, Tuning& tuning) {
  for (const GridPlannerEntry& entry : grid_planners()) {
    tuning.plan_planners.emplace_back(entry.name);
  }
  const auto section = read_section(top, "plans");
  if (!section) return;
  refuse_unknown_keys(*section, kPlanKeys);
  tuning.variations =
      read_count(*section, "variations", 1, kMostVariations).value_or(tuning.variations);
  tuning.plan_iterations =
      read_count(*section, "iterations", 1, kMostIterations).value_or(tuning.plan_iterations);
  tuning.perturbed =
      read_count(*section, "perturbed", 0, kMostPerturbed).value_or(tuning.perturbed);
  const YAML::Node given = node_of(*section, "planners");
  if (!given.IsDefined()) return;
  tuning.plan_planners.clear();
  std::vector<std::string> names;
  for (const GridPlannerEntry& entry : grid_planners()) names.emplace_back(entry.name);
  if (given.IsSequence()) {
    for (const YAML::Node& item : given) {
      const std::string name = item.IsScalar() ? item.Scalar() : "";
      place_in(*section, "planners", name, "planner", names);
      tuning.plan_planners.push_back(name);
    }
  }
  std::vector<std::string> sorted = tuning.plan_planners;
  std::sort(sorted.begin(), sorted.end());
  const bool twice = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  if (!tuning.plan_planners.empty() && !twice) return;
  throw InputError(top.source, place_of(*section, "planners"), "",
                   "a list of different planners on grid maps");
}

void read_planner_to_tune(const YamlSection& top, Tuning& tuning) {
  tuning.planner.name = "grid_local_search";
  if (node_of(top, "planner").IsDefined()) {
    tuning.planner = read_planner(top);
  } else {
    const GridPlannerEntry& entry = find_grid_planner(tuning.planner.name, top.source);
    tuning.planner.parameters = resolve_parameters(entry.parameters, {}, top.source, "planner");
    tuning.planner.grid.emplace();
  }
  if (tuning.planner.grid) {
    const YAML::Node planner = node_of(top, "planner");
    if (!planner.IsDefined()) return;
    for (const char* key : {"cost", "predict"}) {
      if (!planner[key].IsDefined()) continue;
      const YamlSection section = read_section(top, "planner").value();
      throw InputError(top.source, place_of(section, key), "",
                       "not here: costs are tuned and measured, or those of the key costs");
    }
    return;
  }
  throw InputError(top.source, place_of(top, "planner"), tuning.planner.name,
                   "a planner on grid maps is needed: others have no weights");
}

}  // namespace

Tuning read_tuning(const fs::path& file) {
  const YamlSection top = read_yaml(file);
  refuse_unknown_keys(top, kTuningKeys);
  Tuning tuning;
  tuning.file = file;
  tuning.name = read_word(top, "name").value_or(file.stem().string());
  tuning.seed = read_whole_number(top, "seed").value_or(tuning.seed);
  if (!node_of(top, "vehicle").IsDefined()) {
    throw InputError(top.source, place_of(top, "vehicle"), "", "missing: a scenario's vehicle");
  }
  tuning.costs = read_file_name(top, "costs", fs::absolute(file).parent_path());
  read_planner_to_tune(top, tuning);
  read_forms(top, tuning);
  read_training_plans(top, tuning);
  if (const auto search = read_section(top, "search")) {
    refuse_unknown_keys(*search, kSearchKeys);
    tuning.evaluations = read_count(*search, "evaluations", 0, kMostEvaluations).value_or(0);
  }
  tuning.bootstrap_draws =
      read_count(top, "bootstrap", kLeastDraws, kMostDraws).value_or(tuning.bootstrap_draws);
  tuning.shuffles = read_count(top, "shuffles", 0, kMostShuffles).value_or(tuning.shuffles);
  tuning.training = read_set(top, "training");
  tuning.held_out = read_set(top, "held_out");
  refuse_shared_fields(top, tuning);
  tuning.training_place = place_of(top, "training");
  return tuning;
}

std::vector<std::string> tuning_key_paths() {
  std::vector<std::string> paths = kTuningKeys;
  for (const char* set : {"training.", "held_out."}) {
    for (const std::string& key : kSetKeys) paths.push_back(set + key);
  }
  for (const std::string& key : kPlanKeys) paths.push_back("plans." + key);
  for (const std::string& key : kSearchKeys) paths.push_back("search." + key);
  return paths;
}

}  // namespace headland
