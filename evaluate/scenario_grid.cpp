#include "evaluate/scenario_grid.h"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string_view>

#include "evaluate/comparison_planners.h"
#include "evaluate/comparison_reader.h"
#include "terrains/grid_field.h"
#include "terrains/grid_map_from_field.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::array<std::string_view, 7> kKeys = {"start", "end",  "closed", "direction_deg",
                                                   "cost",  "stop", "perturb"};
constexpr int kMostChanges = 1000;

// Shortest text that reads back as the same number.
template <typename Number>
void emit_number(YAML::Emitter& out, const char* key, Number value) {
  out << YAML::Key << key << YAML::Value << fmt::format("{}", value);
}

// What is no limit is left out.
void emit_stop(YAML::Emitter& out, const SearchStop& stop) {
  out << YAML::Key << "stop" << YAML::Value << YAML::BeginMap;
  emit_number(out, "iterations", stop.iterations);
  if (stop.evaluations > 0) emit_number(out, "evaluations", stop.evaluations);
  if (stop.seconds > 0.0) emit_number(out, "seconds", stop.seconds);
  if (stop.stagnation > 0) emit_number(out, "stagnation", stop.stagnation);
  out << YAML::EndMap;
}

}  // namespace

void emit_grid_cost(YAML::Emitter& out, const GridCost& cost, const std::filesystem::path& file) {
  out << YAML::Key << "cost" << YAML::Value << YAML::BeginMap;
  if (!file.empty()) out << YAML::Key << "file" << YAML::Value << file.string();
  out << YAML::Key << "objective" << YAML::Value
      << std::string(grid_objective_name(cost.objective));
  // Measured terms are the file's.
  if (cost.objective == GridObjective::kWeighted && file.empty()) {
    emit_number(out, "repeat", cost.weights.repeat);
    emit_number(out, "turn", cost.weights.turn);
    emit_number(out, "u_turn", cost.weights.u_turn);
  }
  if (cost.objective == GridObjective::kTractor && file.empty()) {
    out << YAML::Key << "tractor" << YAML::Value << YAML::BeginMap;
    for (const TractorKey& key : tractor_energy_keys()) {
      emit_number(out, std::string(key.key).c_str(), cost.tractor.*key.value);
    }
    out << YAML::EndMap;
  }
  out << YAML::EndMap;
}

GridPlanning read_grid_planning(const YamlSection& section) {
  GridPlanning planning;
  planning.start = read_corner(section, "start").value_or(planning.start);
  planning.end = read_corner(section, "end").value_or(planning.end);
  planning.closed = read_flag(section, "closed").value_or(planning.closed);
  planning.direction_deg = read_number(section, "direction_deg", {-360.0, 360.0}).value_or(0.0);
  planning.cost = read_grid_cost(section);
  if (const auto stop = read_section(section, "stop")) planning.stop = read_stop(*stop);
  if (const auto perturb = read_section(section, "perturb")) {
    refuse_unknown_keys(*perturb, {"changes", "seed"});
    planning.perturb.changes = read_count(*perturb, "changes", 0, kMostChanges).value_or(1);
    planning.perturb.seed = read_whole_number(*perturb, "seed").value_or(planning.perturb.seed);
  }
  return planning;
}

void refuse_grid_planning(const YamlSection& section) {
  const YAML::Node mapping = section.node;
  for (const std::string_view key : kKeys) {
    const YAML::Node value = mapping[std::string(key)];
    if (!value.IsDefined() || (key == "cost" && value.IsScalar())) continue;
    throw InputError(section.source, place_of(section, key), "",
                     key == "cost" ? "a file with measured costs is needed; sections are for "
                                     "planners on grid maps, planner.name: grid_..."
                                   : "only of planners on grid maps, planner.name: grid_...");
  }
}

std::filesystem::path read_cost_file(const YamlSection& section,
                                     const std::filesystem::path& folder) {
  const YAML::Node mapping = section.node;
  const YAML::Node cost = mapping["cost"];
  if (!cost.IsDefined()) return {};
  const auto name = cost.IsMap() ? read_word(*read_section(section, "cost"), "file")
                                 : read_word(section, "cost", "a file or a section of keys");
  return name ? (folder / *name).lexically_normal() : std::filesystem::path();
}

void emit_grid_planning(YAML::Emitter& out, const GridPlanning& planning,
                        const std::filesystem::path& cost_file) {
  const auto emit_cell = [&](const char* key, const GivenCell& given) {
    out << YAML::Key << key << YAML::Value;
    if (const auto* cell = std::get_if<GridCell>(&given)) {
      out << YAML::Flow << YAML::BeginSeq << cell->column << cell->row << YAML::EndSeq;
    } else {
      out << given_cell_text(given);
    }
  };
  emit_cell("start", planning.start);
  emit_cell("end", planning.end);
  out << YAML::Key << "closed" << YAML::Value << (planning.closed ? "true" : "false");
  emit_number(out, "direction_deg", planning.direction_deg);
  emit_grid_cost(out, planning.cost, cost_file);
  emit_stop(out, planning.stop);
  if (planning.perturb.changes == 0) return;
  out << YAML::Key << "perturb" << YAML::Value << YAML::BeginMap;
  emit_number(out, "changes", planning.perturb.changes);
  emit_number(out, "seed", planning.perturb.seed);
  out << YAML::EndMap;
}

GridMap take_grid_of(Field& field, double cell_m, double direction_deg, const std::string& source,
                     std::vector<std::string>& notes) {
  const FieldGrid grid =
      grid_of_field(field, cell_m, direction_deg * std::numbers::pi / 180.0, source);
  field.to_work = free_outlines(grid.map);
  notes.push_back(fmt::format(
      "grid: {} cells of {:.4g} m; {:.3g} % of the field lies in cells that are not free and is "
      "not "
      "worked",
      free_cell_count(grid.map), cell_m, 100.0 * grid.left_out_m2 / field_area_m2(field)));
  for (const GridPocket& pocket : grid.pockets) {
    notes.push_back(
        fmt::format("grid: pocket of {} cells at ({:.1f}, {:.1f}) m left out, no cell "
                    "joins it to the others",
                    pocket.cells, pocket.p_W.x(), pocket.p_W.y()));
  }
  return grid.map;
}

}  // namespace headland
