#include "evaluate/comparison_planners.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>
#include <span>

#include "evaluate/comparison_reader.h"
#include "evaluate/yaml_parameters.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

const std::vector<std::string> kPlannerKeys = {"name", "label", "stop"};
const std::vector<std::string> kFieldPlannerKeys = {"name", "label", "stop", "sweeps"};
const std::vector<std::string> kStopKeys = {"iterations", "evaluations", "seconds", "stagnation"};
const std::vector<std::string> kBudgetKeys = {"evaluations", "seconds"};

constexpr double kMostSeconds = 86400.0;
constexpr int kNoLimit = std::numeric_limits<int>::max();

SearchStop read_budget(const YamlSection& section, Budget& budget) {
  refuse_unknown_keys(section, kBudgetKeys);
  SearchStop stop;
  stop.iterations = kNoLimit;
  const auto evaluations = read_count(section, "evaluations", 1, kNoLimit);
  const auto seconds = read_number(section, "seconds", {0.001, kMostSeconds});
  if (static_cast<bool>(evaluations) == static_cast<bool>(seconds)) {
    throw InputError(section.source, place_of_itself(section), "",
                     "either budget.evaluations or budget.seconds is needed, and not both");
  }
  budget = evaluations ? Budget::kEvaluations : Budget::kSeconds;
  stop.evaluations = evaluations.value_or(0);
  stop.seconds = seconds.value_or(0.0);
  return stop;
}

// What planners of either kind share.
struct KnownPlanner {
  std::string name;
  std::span<const ParameterSpec> parameters;
  decltype(GridPlannerEntry::check) check = nullptr;
};

template <typename Entries>
std::vector<KnownPlanner> known_planners(const Entries& entries) {
  std::vector<KnownPlanner> known;
  for (const auto& entry : entries) {
    known.push_back({std::string(entry.name), entry.parameters});
    if constexpr (requires { entry.check; }) known.back().check = entry.check;
  }
  return known;
}

// Those of grid maps, or of fields, and how long they search where nothing is said.
struct PlannerKind {
  bool fields = false;
  std::vector<KnownPlanner> planners;
  int iterations = SearchStop{}.iterations;
};

PlannerKind planner_kind(const YamlSection& top) {
  const YAML::Node node = top.node;
  if (!node["fields"].IsDefined()) return {false, known_planners(grid_planners())};
  for (const char* key : {"maps", "drive", "closed"}) {
    if (!node[key].IsDefined()) continue;
    throw InputError(top.source, place_of(top, key), "", "not with fields");
  }
  if (node["cost"].IsDefined() && !node["cost"].IsScalar()) {
    throw InputError(top.source, place_of(top, "cost"), "",
                     "with fields only a file of measured costs, or nothing: length");
  }
  return {true, known_planners(region_planners()), RegionRequest{}.stop.iterations};
}

ComparedPlanner read_compared_planner(const YamlSection& section, const PlannerKind& kind,
                                      const SearchStop& stop, Budget budget) {
  const auto name = read_word(section, "name");
  if (!name) {
    throw InputError(section.source, place_of(section, "name"), "",
                     fmt::format("the key is missing: a {} planner (headland list planners)",
                                 kind.fields ? "region" : "grid"));
  }
  std::vector<std::string> names;
  for (const KnownPlanner& planner : kind.planners) names.push_back(planner.name);
  const KnownPlanner& found = kind.planners[place_in(section, "name", *name, "planner", names)];
  std::vector<std::string> known = kind.fields ? kFieldPlannerKeys : kPlannerKeys;
  const std::vector<std::string> own = parameter_names(found.parameters);
  known.insert(known.end(), own.begin(), own.end());
  refuse_unknown_keys(section, known);
  ComparedPlanner planner;
  planner.name = *name;
  planner.label = read_word(section, "label").value_or(*name);
  planner.parameters = read_parameters(section, found.parameters);
  if (found.check != nullptr) {
    found.check(planner.parameters, section.source, place_of_itself(section));
  }
  planner.stop = stop;
  if (kind.fields) {
    planner.sweeps = read_choice(section, "sweeps", PartSweeps::kOwn,
                                 {{"own", PartSweeps::kOwn}, {"any", PartSweeps::kAny}});
  }
  if (const auto own_stop = read_section(section, "stop")) {
    if (budget != Budget::kNone) {
      throw InputError(section.source, place_of(section, "stop"), "",
                       "not with budget, which is the same for all");
    }
    planner.stop = read_stop(*own_stop, kind.iterations);
  }
  return planner;
}

}  // namespace

void read_compared_planners(const YamlSection& top, Comparison& comparison) {
  const PlannerKind kind = planner_kind(top);
  SearchStop stop;
  stop.iterations = kind.iterations;
  if (const auto section = read_section(top, "stop")) stop = read_stop(*section, kind.iterations);
  if (const auto section = read_section(top, "budget")) {
    if (read_section(top, "stop")) {
      throw InputError(top.source, place_of(top, "budget"), "", "either budget or stop, not both");
    }
    stop = read_budget(*section, comparison.budget);
  }
  std::vector<std::string> labels;
  for (const YamlSection& section :
       read_sections(top, "planners").value_or(std::vector<YamlSection>{})) {
    comparison.planners.push_back(read_compared_planner(section, kind, stop, comparison.budget));
    labels.push_back(comparison.planners.back().label);
  }
  if (labels.empty()) {
    throw InputError(top.source, place_of(top, "planners"), "",
                     "a list with at least one planner is needed");
  }
  refuse_repeated(top, "planners", "label", labels);
}

SearchStop read_stop(const YamlSection& section, int default_iterations) {
  refuse_unknown_keys(section, kStopKeys);
  SearchStop stop;
  const auto count = [&](std::string_view key) { return read_count(section, key, 1, kNoLimit); };
  const auto iterations = count("iterations");
  stop.evaluations = count("evaluations").value_or(0);
  stop.seconds = read_number(section, "seconds", {0.001, kMostSeconds}).value_or(0.0);
  stop.stagnation = count("stagnation").value_or(0);
  const bool otherwise = stop.evaluations > 0 || stop.seconds > 0.0;
  stop.iterations = iterations.value_or(otherwise ? kNoLimit : default_iterations);
  return stop;
}

std::vector<std::string> compared_planner_key_paths() {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) paths.push_back(prefix + key);
  };
  add("planners.", kFieldPlannerKeys);
  add("stop.", kStopKeys);
  add("budget.", kBudgetKeys);
  return paths;
}

// Names are told apart where they are read and in the files that carry them.
void refuse_repeated(const YamlSection& top, std::string_view list, const std::string& key,
                     const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    constexpr std::size_t kLongest = 80;
    const bool plain = std::ranges::none_of(
        name, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
    if (name.size() > kLongest || !plain) {
      throw InputError(top.source, place_of(top, list), name,
                       fmt::format("a {} has at most {} characters, all printable", key, kLongest));
    }
    if (name_in_files(name).find_first_not_of("._") == std::string::npos) {
      throw InputError(top.source, place_of(top, list), name,
                       fmt::format("a {} with a letter or a digit is needed", key));
    }
    if (seen.insert(name_in_files(name)).second) continue;
    throw InputError(top.source, place_of(top, list), name,
                     fmt::format("the {} stands twice; in files, what is not a letter, digit, '-' "
                                 "or '.' counts as '_'",
                                 key));
  }
}

}  // namespace headland
