#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "evaluate/scenario.h"
#include "evaluate/scenario_keys.h"
#include "evaluate/scenario_parts.h"
#include "evaluate/scenario_soil.h"
#include "evaluate/yaml_parameters.h"
#include "evaluate/yaml_section.h"
#include "planner/grid_drivable.h"
#include "planner/grid_planners.h"
#include "planner/headland_edges.h"
#include "planner/planners.h"
#include "terrains/grid_field.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

void read_numbers(const YamlSection& section, Scenario& scenario) {
  const std::string prefix = section.path + ".";
  for (const NumberKey& key : number_keys()) {
    if (!key.path.starts_with(prefix)) continue;
    const std::string_view name = key.path.substr(prefix.size());
    if (const auto value = read_number(section, name, key.range)) {
      key.value(scenario) = *value;
    }
  }
}

// A section whose keys are all numbers of the table or among `others`, which the caller reads.
std::optional<YamlSection> numbers_section(const YamlSection& top, std::string_view name,
                                           Scenario& scenario) {
  const auto section = read_section(top, name);
  if (section) {
    refuse_unknown_keys(*section, keys_in_section(section->path));
    read_numbers(*section, scenario);
  }
  return section;
}

const GeneratorEntry& find_generator(const YamlSection& section, const std::string& name) {
  std::vector<std::string> known;
  for (const GeneratorEntry& entry : generators()) {
    if (entry.name == name) return entry;
    known.emplace_back(entry.name);
  }
  throw InputError(section.source, place_of(section, "generator"), name,
                   fmt::format("unknown generator; did you mean '{}'? (known: {})",
                               nearest_name(name, known), fmt::join(known, ", ")));
}

}  // namespace

void read_terrain_source(const YamlSection& top, const fs::path& folder, Scenario& scenario) {
  TerrainSource& terrain = scenario.terrain;
  // An absent section is an empty one: flat ground.
  const YamlSection section =
      read_section(top, "terrain")
          .value_or(YamlSection{top.source, "terrain", YAML::Node(YAML::NodeType::Map)});
  terrain.file = read_file_name(section, "file", folder);
  terrain.crs = read_crs(section);
  const auto generator = read_word(section, "generator");
  if (generator && !terrain.file.empty()) {
    throw InputError(top.source, place_of(section, "generator"), *generator,
                     "either terrain.file or terrain.generator, not both");
  }
  std::vector<std::string> known = keys_in_section("terrain");
  if (terrain.file.empty()) {
    const GeneratorEntry& entry = find_generator(section, generator.value_or(terrain.generator));
    terrain.generator = entry.name;
    const std::vector<std::string> own = parameter_names(entry.parameters);
    known.insert(known.end(), own.begin(), own.end());
    refuse_unknown_keys(section, known);
    terrain.parameters = read_parameters(section, entry.parameters);
  } else {
    refuse_unknown_keys(section, known);
  }
  read_numbers(section, scenario);
  terrain.seed = read_whole_number(section, "seed").value_or(scenario.seed);
  numbers_section(section, "micro_relief", scenario);
}

namespace {

// The vehicle's name; a folder (told by its slash) starts at the scenario's own.
std::string read_vehicle(const YamlSection& top, const fs::path& folder) {
  const auto name = read_word(top, "vehicle");
  const std::vector<std::string> known = vehicle_names();
  const std::string list = fmt::format("{}", fmt::join(known, ", "));
  if (!name) {
    throw InputError(top.source, "vehicle", "", "the key is missing: a folder or one of " + list);
  }
  if (name->find('/') != std::string::npos) {
    const fs::path own = (folder / *name).lexically_normal();
    std::error_code ignored;
    if (fs::exists(own / "vehicle.urdf", ignored)) return own.string();
    throw InputError(top.source, place_of(top, "vehicle"), *name,
                     fmt::format("there is no vehicle.urdf in {}; a vehicle is a folder with one, "
                                 "or one of {}",
                                 own.string(), list));
  }
  if (std::find(known.begin(), known.end(), *name) == known.end()) {
    throw InputError(
        top.source, place_of(top, "vehicle"), *name,
        fmt::format("unknown vehicle; did you mean '{}'? (known: {}; a folder is written with a /)",
                    nearest_name(*name, known), list));
  }
  return *name;
}

constexpr double kWidestHeadland_m = 1000.0;

std::optional<std::array<Eigen::Vector2d, 2>> read_ab_line(const YamlSection& section) {
  const auto points = read_points(section, "ab_line");
  if (!points) return std::nullopt;
  if (points->size() != 2) {
    throw InputError(section.source, place_of(section, "ab_line"),
                     fmt::format("{} point{}", points->size(), points->size() == 1 ? "" : "s"),
                     "two points, A and B");
  }
  for (const Eigen::Vector2d& point : *points) {
    if (point.allFinite()) continue;
    throw InputError(section.source, place_of(section, "ab_line"),
                     fmt::format("{}, {}", point.x(), point.y()), "not a finite coordinate");
  }
  return std::array{points->front(), points->back()};
}

EdgeHeadland read_edge_headland(const YamlSection& section) {
  refuse_unknown_keys(section, {"at", "hole", "edge", "passes", "width_m"});
  EdgeHeadland edge;
  edge.at_W = read_point(section, "at");
  edge.hole = read_count(section, "hole", 1, 100000).value_or(0);
  edge.edge = read_count(section, "edge", 1, 100000).value_or(0);
  const bool by_number = edge.hole > 0 || edge.edge > 0;
  if (edge.at_W.has_value() == by_number) {
    throw InputError(section.source, place_of_itself(section), "",
                     edge.at_W ? "a place (at), or numbers (edge, hole), not both"
                               : "which edge is missing: at: [x, y], edge: N or hole: N");
  }
  if (edge.at_W && !edge.at_W->allFinite()) {
    throw InputError(section.source, place_of(section, "at"),
                     fmt::format("{}, {}", edge.at_W->x(), edge.at_W->y()),
                     "not a finite coordinate");
  }
  edge.passes = read_count(section, "passes", 0, kMostRounds);
  const auto width_m = read_number(section, "width_m", {0.0, kWidestHeadland_m});
  if (edge.passes.has_value() == width_m.has_value()) {
    throw InputError(section.source, place_of_itself(section), "",
                     edge.passes ? "passes or width_m, not both"
                                 : "how wide is missing: passes: N or width_m: W");
  }
  edge.width_m = width_m.value_or(0.0);
  return edge;
}

}  // namespace

namespace {

// A key that is no typing error: another planner on fields has it.
void refuse_of_others(const YamlSection& section, const std::string& planner,
                      const std::vector<std::string>& known) {
  for (const PlannerEntry& other : planners()) {
    for (const ParameterSpec& parameter : other.parameters) {
      const bool own = std::ranges::find(known, parameter.name) != known.end();
      if (own || !has_key(section, parameter.name)) continue;
      throw InputError(section.source, place_of(section, parameter.name), "",
                       fmt::format("a key of planner {}, not of {}", other.name, planner));
    }
  }
}

}  // namespace

std::string place_of(const PlannerChoice& planner, const std::string& key) {
  const auto place = planner.places.find(key);
  return place == planner.places.end() ? "planner." + key : place->second;
}

PlannerChoice read_planner(const YamlSection& top) {
  PlannerChoice choice;
  const YamlSection section =
      read_section(top, "planner")
          .value_or(YamlSection{top.source, "planner", YAML::Node(YAML::NodeType::Map)});
  choice.name = read_word(section, "name").value_or(choice.name);
  std::vector<std::string> names;
  std::span<const ParameterSpec> parameters;
  decltype(GridPlannerEntry::check) check = nullptr;
  for (const PlannerEntry& entry : planners()) {
    names.emplace_back(entry.name);
    if (entry.name != choice.name) continue;
    parameters = entry.parameters;
    check = entry.check;
  }
  for (const GridPlannerEntry& entry : grid_planners()) {
    names.emplace_back(entry.name);
    if (entry.name != choice.name) continue;
    parameters = entry.parameters;
    check = entry.check;
    choice.grid.emplace();
  }
  if (std::find(names.begin(), names.end(), choice.name) == names.end()) {
    throw InputError(top.source, place_of(section, "name"), choice.name,
                     fmt::format("unknown planner; the nearest is {} (known: {})",
                                 nearest_name(choice.name, names), fmt::join(names, ", ")));
  }
  std::vector<std::string> known = keys_in_section("planner");
  const std::vector<std::string> own = parameter_names(parameters);
  known.insert(known.end(), own.begin(), own.end());
  refuse_of_others(section, choice.name, known);
  refuse_unknown_keys(section, known);
  choice.parameters = read_parameters(section, parameters);
  if (check != nullptr) check(choice.parameters, top.source, place_of_itself(section));
  const fs::path folder = fs::absolute(top.source).parent_path();
  choice.cost_file = read_cost_file(section, folder);
  if (!choice.cost_file.empty()) choice.cost_place = place_of(section, "cost");
  if (const auto predict = read_word(section, "predict", "a file")) {
    choice.predict_file = (folder / *predict).lexically_normal();
    choice.predict_place = place_of(section, "predict");
  }
  choice.ab_line = read_ab_line(section);
  for (const std::string& key : known) {
    if (has_key(section, key)) choice.places[key] = place_of(section, key);
  }
  for (const YamlSection& edge :
       read_sections(section, "headland_edges").value_or(std::vector<YamlSection>{})) {
    choice.places[headland_edge_key(choice.headland_edges.size())] = place_of_itself(edge);
    choice.headland_edges.push_back(read_edge_headland(edge));
  }
  if (choice.grid) {
    if (choice.ab_line) {
      throw InputError(top.source, place_of(section, "ab_line"), "",
                       "only of planners on fields; cells have planner.direction_deg");
    }
    if (!choice.headland_edges.empty()) {
      throw InputError(top.source, place_of(section, "headland_edges"), "",
                       "only of planners on fields; plans on cells have no headland");
    }
    choice.grid = read_grid_planning(section);
  } else {
    refuse_grid_planning(section);
  }
  return choice;
}

namespace {

void read_verdict(const YamlSection& top, Scenario& scenario) {
  const auto verdict = read_section(top, "verdict");
  if (!verdict) return;
  refuse_unknown_keys(*verdict, keys_in_section("verdict"));
  for (const LimitKey& key : limit_keys()) {
    const std::string name(key.path.substr(verdict->path.size() + 1));
    const auto section = read_section(*verdict, name, "a section {warn: .., fail: ..}");
    if (!section) continue;
    refuse_unknown_keys(*section, {"warn", "fail"});
    Threshold& limit = key.value(scenario);
    limit.warn = read_number(*section, "warn", {0.0, key.max}).value_or(limit.warn);
    limit.fail = read_number(*section, "fail", {0.0, key.max}).value_or(limit.fail);
    if (key.more_is_better ? limit.warn < limit.fail : limit.warn > limit.fail) {
      throw InputError(top.source, place_of(*verdict, name),
                       fmt::format("warn {}, fail {}", limit.warn, limit.fail),
                       key.more_is_better ? "fail must not be above warn: more is better here"
                                          : "fail must not be below warn: less is better here");
    }
  }
}

// A field or a terrain given in place of the scenario that names it.
void refuse_binary(const fs::path& file) {
  if (read_text(file).find('\0') == std::string::npos) return;
  throw InputError(file.string(), "", "",
                   "this is a binary file, not a scenario (YAML); name it in one as field.file or "
                   "terrain.file");
}

void refuse_geojson(const YamlSection& top) {
  const YAML::Node mapping = top.node;
  const bool geojson = mapping["type"].IsDefined() &&
                       (mapping["features"].IsDefined() || mapping["geometry"].IsDefined() ||
                        mapping["coordinates"].IsDefined());
  if (!geojson) return;
  throw InputError(top.source, "", "",
                   "this is GeoJSON, not a scenario (YAML); name it in one as field.file");
}

// All that a scenario says but for its name, field and planner. `seed` replaces the terrain's too.
Vehicle read_drive_keys(const YamlSection& top, const fs::path& folder,
                        std::optional<std::uint64_t> seed, Scenario& scenario) {
  read_terrain_source(top, folder, scenario);
  if (seed) scenario.seed = scenario.terrain.seed = *seed;
  scenario.soil = read_soil_source(top, folder);
  scenario.vehicle = read_vehicle(top, folder);
  Vehicle vehicle = load_vehicle(scenario.vehicle);
  scenario.working_width_m = vehicle.implement.working_width_m;
  numbers_section(top, "implement", scenario);
  if (const auto path = numbers_section(top, "path", scenario)) {
    scenario.path.allow_overrun =
        read_flag(*path, "allow_overrun").value_or(scenario.path.allow_overrun);
    scenario.path.keep_off_worked =
        read_flag(*path, "keep_off_worked").value_or(scenario.path.keep_off_worked);
    scenario.path.continuous_turns =
        read_flag(*path, "continuous_turns").value_or(scenario.path.continuous_turns);
    if (scenario.path.continuous_turns) {
      scenario.continuous_turns_place = place_of(*path, "continuous_turns");
    }
    // Whoever drives it will tell when it is gone: the results of a run outlive its track.
    if (const auto name = read_word(*path, "file")) {
      scenario.path_file = (folder / *name).lexically_normal();
    }
  }
  if (const auto simulation = numbers_section(top, "simulation", scenario)) {
    if (scenario.simulation.record_hz > scenario.simulation.rate_hz) {
      throw InputError(
          top.source, place_of(*simulation, "record_hz"),
          fmt::format("{}", scenario.simulation.record_hz),
          fmt::format("must not be above simulation.rate_hz, {}", scenario.simulation.rate_hz));
    }
  }
  numbers_section(top, "positioning", scenario);
  scenario.simulation.positioning.seed = scenario.seed;
  numbers_section(top, "coverage", scenario);
  read_verdict(top, scenario);
  return vehicle;
}

}  // namespace

Scenario read_scenario(const fs::path& file, std::optional<std::uint64_t> seed) {
  refuse_binary(file);
  const YamlSection top = read_yaml(file);
  refuse_geojson(top);
  refuse_unknown_keys(top, keys_in_section(""));
  const fs::path folder = fs::absolute(file).parent_path();

  Scenario scenario;
  scenario.file = file;
  scenario.name = read_word(top, "name").value_or(file.stem().string());
  scenario.seed = read_whole_number(top, "seed").value_or(scenario.seed);
  scenario.field = read_field_source(top, folder);
  const Vehicle vehicle = read_drive_keys(top, folder, seed, scenario);
  scenario.planner = read_planner(top);
  read_grid_map_numbers(top, vehicle, scenario);
  return scenario;
}

Scenario read_drive(const YamlSection& section, std::uint64_t seed,
                    const std::vector<std::string>& beside) {
  // Its keys are those of a scenario.
  const YamlSection top{section.source, "", section.node};
  std::vector<std::string> known = keys_in_section("");
  std::erase_if(known, [](const std::string& key) {
    return key == "name" || key == "seed" || key == "field" || key == "planner";
  });
  known.insert(known.end(), beside.begin(), beside.end());
  refuse_unknown_keys(top, known);
  const fs::path file(section.source);
  Scenario scenario;
  scenario.file = file;
  scenario.seed = seed;
  read_drive_keys(top, fs::absolute(file).parent_path(), std::nullopt, scenario);
  if (scenario.path_file.empty()) return scenario;
  throw InputError(section.source, place_of_itself(section), "path.file",
                   "plans are driven here, no track");
}

}  // namespace headland
