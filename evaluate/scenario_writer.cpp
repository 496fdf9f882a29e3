#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "evaluate/scenario.h"
#include "evaluate/scenario_keys.h"
#include "evaluate/scenario_soil.h"

namespace headland {
namespace {

// Shortest text that reads back as the same number; yaml-cpp would write 0.1 with 17 digits.
std::string shown(double value) { return fmt::format("{}", value); }

void emit(YAML::Emitter& out, std::string_view key, const std::string& value) {
  out << YAML::Key << std::string(key) << YAML::Value << value;
}

void emit(YAML::Emitter& out, const Eigen::Vector2d& point) {
  out << YAML::Flow << YAML::BeginSeq << shown(point.x()) << shown(point.y()) << YAML::EndSeq;
}

void emit(YAML::Emitter& out, const Ring& ring) {
  out << YAML::BeginSeq;
  for (const Eigen::Vector2d& point : ring) emit(out, point);
  out << YAML::EndSeq;
}

void emit_numbers(YAML::Emitter& out, const std::string& section, Scenario& scenario) {
  for (const NumberKey& key : number_keys()) {
    if (!key.path.starts_with(section + ".")) continue;
    const std::string_view name = key.path.substr(section.size() + 1);
    if (name.find('.') == std::string_view::npos) emit(out, name, shown(key.value(scenario)));
  }
}

void begin_section(YAML::Emitter& out, const std::string& name) {
  out << YAML::Key << name << YAML::Value << YAML::BeginMap;
}

void emit_numbers_section(YAML::Emitter& out, const std::string& name, Scenario& scenario) {
  begin_section(out, name);
  emit_numbers(out, name, scenario);
  out << YAML::EndMap;
}

void emit_parameters(YAML::Emitter& out, const Parameters& parameters) {
  for (const auto& [name, value] : parameters) {
    const double* number = std::get_if<double>(&value);
    emit(out, name, number != nullptr ? shown(*number) : std::get<std::string>(value));
  }
}

void emit_field(YAML::Emitter& out, const FieldSource& field) {
  begin_section(out, "field");
  if (!field.file.empty()) emit(out, "file", field.file.string());
  if (!field.layer.empty()) emit(out, "layer", field.layer);
  if (!field.part.empty()) emit(out, "part", field.part);
  if (!field.crs.empty()) emit(out, "crs", field.crs);
  if (!field.grid_map.empty()) {
    emit(out, "grid_map", field.grid_map.string());
    emit(out, "cell_m", shown(field.cell_m));
    emit(out, "margin_m", shown(field.margin_m));
  } else if (field.file.empty()) {
    out << YAML::Key << "boundary" << YAML::Value;
    emit(out, field.boundary);
    out << YAML::Key << "holes" << YAML::Value << YAML::BeginSeq;
    for (const Ring& hole : field.holes) emit(out, hole);
    out << YAML::EndSeq;
    if (!field.to_work.empty()) {
      out << YAML::Key << "to_work" << YAML::Value << YAML::BeginSeq;
      for (const Ring& ring : field.to_work) emit(out, ring);
      out << YAML::EndSeq;
    }
  }
  out << YAML::Key << "obstacles" << YAML::Value << YAML::BeginSeq;
  for (const ObstacleSource& obstacle : field.obstacles) {
    out << YAML::Flow << YAML::BeginMap;
    emit(out, "kind", std::string(obstacle_kind_name(obstacle.kind)));
    if (runs_along_line(obstacle.kind)) {
      out << YAML::Key << "line" << YAML::Value;
      emit(out, obstacle.line);
      emit(out, "thickness_m", shown(2.0 * obstacle.radius_m));
    } else {
      out << YAML::Key << "at" << YAML::Value;
      emit(out, obstacle.line.front());
      emit(out, "radius_m", shown(obstacle.radius_m));
    }
    emit(out, "height_m", shown(obstacle.height_m));
    out << YAML::EndMap;
  }
  out << YAML::EndSeq;
  if (field.entry) {
    out << YAML::Key << "entry" << YAML::Value;
    emit(out, *field.entry);
  }
  out << YAML::EndMap;
}

void emit_terrain(YAML::Emitter& out, Scenario& scenario) {
  const TerrainSource& terrain = scenario.terrain;
  begin_section(out, "terrain");
  if (terrain.file.empty()) {
    emit(out, "generator", terrain.generator);
    emit_parameters(out, terrain.parameters);
  } else {
    emit(out, "file", terrain.file.string());
    if (!terrain.crs.empty()) emit(out, "crs", terrain.crs);
  }
  emit_numbers(out, "terrain", scenario);
  begin_section(out, "micro_relief");
  emit_numbers(out, "terrain.micro_relief", scenario);
  out << YAML::EndMap;
  emit(out, "seed", fmt::format("{}", terrain.seed));
  out << YAML::EndMap;
}

void emit_verdict(YAML::Emitter& out, Scenario& scenario) {
  begin_section(out, "verdict");
  for (const LimitKey& key : limit_keys()) {
    const Threshold& limit = key.value(scenario);
    out << YAML::Key << std::string(key.path.substr(key.path.find('.') + 1)) << YAML::Value;
    out << YAML::Flow << YAML::BeginMap;
    emit(out, "warn", shown(limit.warn));
    emit(out, "fail", shown(limit.fail));
    out << YAML::EndMap;
  }
  out << YAML::EndMap;
}

void emit_headland_edges(YAML::Emitter& out, const std::vector<EdgeHeadland>& edges) {
  if (edges.empty()) return;
  out << YAML::Key << "headland_edges" << YAML::Value << YAML::BeginSeq;
  for (const EdgeHeadland& edge : edges) {
    out << YAML::Flow << YAML::BeginMap;
    if (edge.at_W) {
      out << YAML::Key << "at" << YAML::Value;
      emit(out, *edge.at_W);
    }
    if (edge.hole > 0) emit(out, "hole", std::to_string(edge.hole));
    if (edge.edge > 0) emit(out, "edge", std::to_string(edge.edge));
    if (edge.passes) {
      emit(out, "passes", std::to_string(*edge.passes));
    } else {
      emit(out, "width_m", shown(edge.width_m));
    }
    out << YAML::EndMap;
  }
  out << YAML::EndSeq;
}

}  // namespace

std::string scenario_yaml(const Scenario& given) {
  Scenario scenario = given;  // the key table hands out references
  YAML::Emitter out;
  out << YAML::Comment("A scenario with every default written out; keys: docs/scenario.md");
  out << YAML::BeginMap;
  emit(out, "name", scenario.name);
  emit_field(out, scenario.field);
  emit_terrain(out, scenario);
  out << YAML::Key << "soil" << YAML::Value;
  emit_soil(out, scenario.soil);
  emit(out, "vehicle", scenario.vehicle);
  emit_numbers_section(out, "implement", scenario);
  if (scenario.path_file.empty()) {
    begin_section(out, "planner");
    emit(out, "name", scenario.planner.name);
    emit_parameters(out, scenario.planner.parameters);
    if (const auto& line = scenario.planner.ab_line) {
      out << YAML::Key << "ab_line" << YAML::Value << YAML::Flow;
      emit(out, Ring(line->begin(), line->end()));
    }
    emit_headland_edges(out, scenario.planner.headland_edges);
    if (!scenario.planner.predict_file.empty()) {
      emit(out, "predict", scenario.planner.predict_file.string());
    }
    const std::filesystem::path& cost_file = scenario.planner.cost_file;
    if (scenario.planner.grid) {
      emit_grid_planning(out, *scenario.planner.grid, cost_file);
    } else if (!cost_file.empty()) {
      emit(out, "cost", cost_file.string());
    }
    out << YAML::EndMap;
  }
  if (!scenario.path_file.empty() && !scenario.planner.cost_file.empty()) {
    begin_section(out, "planner");
    emit(out, "cost", scenario.planner.cost_file.string());
    out << YAML::EndMap;
  }
  begin_section(out, "path");
  if (!scenario.path_file.empty()) {
    // It may have been given on the command line, from another folder than the results'.
    emit(out, "file", std::filesystem::absolute(scenario.path_file).lexically_normal().string());
  }
  emit_numbers(out, "path", scenario);
  emit(out, "allow_overrun", scenario.path.allow_overrun ? "true" : "false");
  emit(out, "keep_off_worked", scenario.path.keep_off_worked ? "true" : "false");
  emit(out, "continuous_turns", scenario.path.continuous_turns ? "true" : "false");
  out << YAML::EndMap;
  emit_numbers_section(out, "simulation", scenario);
  emit_numbers_section(out, "positioning", scenario);
  emit_numbers_section(out, "coverage", scenario);
  emit_verdict(out, scenario);
  emit(out, "seed", fmt::format("{}", scenario.seed));
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace headland
