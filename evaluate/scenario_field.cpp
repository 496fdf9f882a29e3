#include <fmt/format.h>

#include "evaluate/scenario.h"
#include "evaluate/scenario_keys.h"
#include "evaluate/scenario_parts.h"
#include "evaluate/yaml_section.h"
#include "planner/grid_drivable.h"
#include "terrains/grid_field.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

ObstacleKind read_obstacle_kind(const YamlSection& section) {
  const std::string name = read_word(section, "kind").value_or("tree");
  std::vector<std::string> known;
  for (const ObstacleKind kind : kEveryObstacleKind) {
    if (obstacle_kind_name(kind) == name) return kind;
    known.emplace_back(obstacle_kind_name(kind));
  }
  throw InputError(section.source, place_of(section, "kind"), name,
                   fmt::format("unknown obstacle; known: {}", fmt::join(known, ", ")));
}

// Refuses the keys of what stands otherwise, and asks for the one that says where it stands.
void require_place(const YamlSection& section, std::string_view needed, const std::string& form,
                   std::initializer_list<std::string_view> foreign, const std::string& whose) {
  for (const std::string_view key : foreign) {
    const YAML::Node node = section.node;
    if (!node[std::string(key)].IsDefined()) continue;
    throw InputError(section.source, place_of(section, key), "", "only of " + whose);
  }
  const YAML::Node node = section.node;
  if (node[std::string(needed)].IsDefined()) return;
  throw InputError(section.source, place_of(section, needed), "", "the key is missing: " + form);
}

ObstacleSource read_obstacle(const YamlSection& section) {
  refuse_unknown_keys(section, keys_in_section(section.path));
  ObstacleSource obstacle = default_obstacle(read_obstacle_kind(section));
  obstacle.place = place_of_itself(section);
  if (runs_along_line(obstacle.kind)) {
    require_place(section, "line", "[[x, y], [x, y], ...]", {"at", "radius_m"},
                  "trees, poles and rocks");
    obstacle.line = read_points(section, "line").value();
    obstacle.radius_m =
        0.5 * read_number(section, "thickness_m", {kMinThickness_m, kMaxThickness_m})
                  .value_or(2.0 * obstacle.radius_m);
  } else {
    require_place(section, "at", "[x, y]", {"line", "thickness_m"}, "walls and fences");
    obstacle.line = {read_point(section, "at").value()};
    obstacle.radius_m = read_number(section, "radius_m", {kMinObstacle_m, kMaxObstacleRadius_m})
                            .value_or(obstacle.radius_m);
  }
  obstacle.height_m = read_number(section, "height_m", {kMinObstacle_m, kMaxObstacleHeight_m})
                          .value_or(obstacle.height_m);
  return obstacle;
}

// All of a grid map's field but its entry is in the map.
void refuse_beside_grid_map(const YamlSection& section, const FieldSource& field) {
  const YAML::Node mapping = section.node;
  for (const std::string_view key :
       {"file", "boundary", "layer", "part", "crs", "holes", "to_work", "obstacles"}) {
    const bool given = mapping[std::string(key)].IsDefined();
    if (!given || (key == "obstacles" && field.obstacles.empty())) continue;
    throw InputError(section.source, place_of(section, key), "",
                     "not with field.grid_map: blocked cells are what is in the way");
  }
}

}  // namespace

void read_grid_map_numbers(const YamlSection& top, const Vehicle& vehicle, Scenario& scenario) {
  if (scenario.field.grid_map.empty()) return;
  const YamlSection section = read_section(top, "field").value();
  scenario.field.cell_m = read_number(section, "cell_m", {kMinGridCell_m, kMaxGridCell_m})
                              .value_or(scenario.working_width_m);
  const double margin_m = scenario.planner.grid ? grid_margin_m(vehicle, scenario.path) : 0.0;
  scenario.field.margin_m =
      read_number(section, "margin_m", {0.0, kMaxGridMargin_m}).value_or(margin_m);
}

FieldSource read_field_source(const YamlSection& top, const std::filesystem::path& folder) {
  const auto section = read_section(top, "field");
  if (!section) {
    throw InputError(top.source, "field", "", "the section is missing: a file or a boundary");
  }
  refuse_unknown_keys(*section, keys_in_section("field"));
  FieldSource field;
  field.file = read_file_name(*section, "file", folder);
  field.layer = read_word(*section, "layer").value_or("");
  field.part = read_word(*section, "part").value_or("");
  field.crs = read_crs(*section);
  field.boundary = read_points(*section, "boundary").value_or(Ring{});
  field.holes = read_point_lists(*section, "holes").value_or(std::vector<Ring>{});
  field.to_work = read_point_lists(*section, "to_work").value_or(std::vector<Ring>{});
  field.entry = read_point(*section, "entry");
  field.entry_place = place_of(*section, "entry");
  for (const YamlSection& obstacle :
       read_sections(*section, "obstacles").value_or(std::vector<YamlSection>{})) {
    field.obstacles.push_back(read_obstacle(obstacle));
  }
  const bool inline_boundary = static_cast<bool>(read_points(*section, "boundary"));
  field.grid_map = read_file_name(*section, "grid_map", folder);
  if (!field.grid_map.empty()) {
    refuse_beside_grid_map(*section, field);
    return field;
  }
  for (const std::string_view key : {"cell_m", "margin_m"}) {
    if (!read_word(*section, key)) continue;
    throw InputError(top.source, place_of(*section, key), "", "only with field.grid_map");
  }
  if (field.file.empty() != inline_boundary) {
    throw InputError(top.source, place_of(*section, inline_boundary ? "boundary" : "file"), "",
                     "one of field.file, field.boundary and field.grid_map is needed, and no two");
  }
  for (const std::string_view key : {"layer", "part"}) {
    if (inline_boundary && read_word(*section, key)) {
      throw InputError(top.source, place_of(*section, key), "", "only with field.file");
    }
  }
  if (!field.file.empty() && !field.holes.empty()) {
    throw InputError(top.source, place_of(*section, "holes"), "",
                     "only with field.boundary: the holes of a field.file are those in the file");
  }
  if (!field.file.empty() && !field.to_work.empty()) {
    throw InputError(top.source, place_of(*section, "to_work"), "", "only with field.boundary");
  }
  return field;
}

}  // namespace headland
