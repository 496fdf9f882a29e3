#include "evaluate/comparison_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "evaluate/scenario_grid.h"
#include "evaluate/scenario_parts.h"
#include "planner/grid_graph.h"
#include "terrains/field_source.h"
#include "terrains/grid_field.h"
#include "terrains/grid_map_file.h"
#include "terrains/grid_map_generator.h"
#include "terrains/input_error.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSourceKeys = {"file", "cells", "generator", "field"};
const std::vector<std::string> kMapKeys = {"name",    "file",  "cells",  "generator",
                                           "field",   "count", "cell_m", "heights",
                                           "terrain", "start", "end",    "closed"};
const std::vector<std::string> kGeneratorKeys = {"columns", "rows", "blocked_share", "obstacles",
                                                 "seed"};
const std::vector<std::string> kFieldKeys = {"file", "layer",   "part",
                                             "crs",  "width_m", "direction_deg"};

constexpr NumberRange kCell{kMinGridCell_m, kMaxGridCell_m};

// Keys that belong to one kind of map only.
void refuse_key(const YamlSection& section, std::string_view key, const std::string& whose) {
  if (!has_key(section, key)) return;
  throw InputError(section.source, place_of(section, key), "", "only with " + whose);
}

// Gives the map its ends and refuses what no planner could plan.
void set_ends(const YamlSection& section, const MapDefaults& defaults, ComparedMap& map) {
  const auto own_start = read_corner(section, "start");
  const auto own_end = read_corner(section, "end");
  map.start = cell_of(own_start ? own_start : defaults.start, map.map);
  map.end = cell_of(own_end ? own_end : defaults.end, map.map);
  map.closed = read_flag(section, "closed").value_or(defaults.closed);
  const std::string whose = fmt::format("{} '{}'", place_of_itself(section), map.name);
  const GridGraph graph = grid_graph(map.map, section.source + ": " + whose);
  const auto check = [&](const std::optional<GridCell>& cell, const char* key) {
    if (cell) node_at(map.map, graph, *cell, section.source, fmt::format("{}: {}", whose, key));
  };
  check(map.start, "start");
  check(map.end, "end");
  if (map.closed ? map.end && map.end != map.start
                 : map.start && map.start == map.end && graph.size() > 1) {
    throw InputError(section.source, whose + ": end",
                     fmt::format("{}, {}", map.end->column, map.end->row),
                     map.closed ? "none, or the start: the tour is closed"
                                : "another cell than the start, or `closed: true`");
  }
}

// Heights of the cells' middles: a text of them, or the surface of a terrain as of a scenario.
void take_heights(const YamlSection& section, const fs::path& folder, std::uint64_t seed,
                  ComparedMap& map) {
  const fs::path heights = read_file_name(section, "heights", folder);
  if (!heights.empty()) read_cell_heights(heights, map.map);
  if (!has_key(section, "terrain")) return;
  if (!heights.empty()) {
    throw InputError(section.source, place_of(section, "terrain"), "",
                     "either heights or terrain, not both");
  }
  Scenario ground;
  ground.seed = seed;
  read_terrain_source({section.source, "", section.node}, folder, ground);
  const std::string whose =
      fmt::format("{}: {} '{}'", section.source, place_of(section, "terrain"), map.name);
  set_heights(map.map,
              read_terrain(ground.terrain,
                           map.field ? *map.field : field_of_grid(map.map, 0.0, whose), whose));
}

std::vector<ComparedMap> made_up_maps(const YamlSection& entry, const YamlSection& section,
                                      double cell_m, std::uint64_t seed) {
  refuse_unknown_keys(section, kGeneratorKeys);
  GridMapRecipe recipe;
  recipe.columns = read_count(section, "columns", 1, kMaxGridSide).value_or(recipe.columns);
  recipe.rows = read_count(section, "rows", 1, kMaxGridSide).value_or(recipe.rows);
  recipe.blocked_share =
      read_number(section, "blocked_share", {0.0, kMaxBlockedShare}).value_or(recipe.blocked_share);
  recipe.obstacles =
      read_count(section, "obstacles", 0, kMaxGridSide * kMaxGridSide).value_or(recipe.obstacles);
  recipe.seed = read_whole_number(section, "seed").value_or(seed);
  const std::string name =
      read_word(entry, "name").value_or(fmt::format("{}x{}", recipe.columns, recipe.rows));
  const auto count = read_count(entry, "count", 1, kMostMapsOfARecipe);
  std::vector<ComparedMap> maps;
  for (int i = 0; i < count.value_or(1); ++i, ++recipe.seed) {
    ComparedMap map;
    map.name = count ? fmt::format("{}_{}", name, i + 1) : name;
    map.map = made_up_grid_map(recipe, entry.source + ": " + place_of_itself(section));
    map.map.cell_m = read_number(entry, "cell_m", kCell).value_or(cell_m);
    maps.push_back(std::move(map));
  }
  return maps;
}

ComparedMap map_of_field(const YamlSection& entry, const YamlSection& section,
                         const fs::path& folder) {
  refuse_unknown_keys(section, kFieldKeys);
  FieldSource source;
  source.file = read_file_name(section, "file", folder);
  source.layer = read_word(section, "layer").value_or("");
  source.part = read_word(section, "part").value_or("");
  source.crs = read_crs(section);
  const auto width_m = read_number(section, "width_m", kCell);
  if (source.file.empty() || !width_m) {
    throw InputError(section.source, place_of(section, source.file.empty() ? "file" : "width_m"),
                     "", "the key is missing: a field's file and the working width are needed");
  }
  const double direction_deg = read_number(section, "direction_deg", {-360.0, 360.0}).value_or(0.0);
  ComparedMap map;
  map.name = read_word(entry, "name").value_or(source.file.stem().string());
  map.field = read_field(source, entry.source);
  map.map = take_grid_of(*map.field, *width_m, direction_deg,
                         entry.source + ": " + place_of_itself(section), map.notes);
  return map;
}

ComparedMap map_of_file(const YamlSection& entry, std::string_view key, const fs::path& folder,
                        double default_cell_m) {
  const fs::path file = read_file_name(entry, key, folder);
  const double cell_m = read_number(entry, "cell_m", kCell).value_or(default_cell_m);
  ComparedMap map;
  map.name = read_word(entry, "name").value_or(file.stem().string());
  map.map = key == "file" ? read_grid_map(file, cell_m) : read_cell_list(file, cell_m);
  return map;
}

std::vector<ComparedMap> maps_of(const YamlSection& section, const fs::path& folder, double cell_m,
                                 std::uint64_t seed) {
  const auto generator = read_section(section, "generator");
  const auto field = read_section(section, "field", "a section with file and width_m");
  if (!generator) refuse_key(section, "count", "a generator");
  if (field) refuse_key(section, "cell_m", "other maps: a field's cells are field.width_m wide");
  if (generator) return made_up_maps(section, *generator, cell_m, seed);
  if (field) return {map_of_field(section, *field, folder)};
  return {map_of_file(section, has_key(section, "file") ? "file" : "cells", folder, cell_m)};
}

}  // namespace

std::vector<ComparedMap> read_compared_maps(const YamlSection& section, const MapDefaults& defaults,
                                            std::uint64_t seed) {
  refuse_unknown_keys(section, kMapKeys);
  const auto sources = std::count_if(kSourceKeys.begin(), kSourceKeys.end(),
                                     [&](const auto& key) { return has_key(section, key); });
  if (sources != 1) {
    throw InputError(section.source, place_of_itself(section), "",
                     fmt::format("one of {} is needed, and no two", fmt::join(kSourceKeys, ", ")));
  }
  const fs::path folder = fs::absolute(section.source).parent_path();
  std::vector<ComparedMap> maps = maps_of(section, folder, defaults.cell_m, seed);
  for (ComparedMap& map : maps) {
    set_ends(section, defaults, map);
    take_heights(section, folder, seed, map);
  }
  return maps;
}

std::vector<std::string> compared_map_key_paths() {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>& keys) {
    std::transform(keys.begin(), keys.end(), std::back_inserter(paths),
                   [&](const std::string& key) { return prefix + key; });
  };
  add("maps.", kMapKeys);
  add("maps.generator.", kGeneratorKeys);
  add("maps.field.", kFieldKeys);
  return paths;
}

}  // namespace headland
