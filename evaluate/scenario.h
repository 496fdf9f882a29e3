// A scenario: everything that names one evaluation, as read from YAML and with every default.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "evaluate/verdict.h"
#include "planner/drivable_path.h"
#include "sim/simulation.h"
#include "terrains/field_source.h"
#include "terrains/parameter.h"
#include "terrains/terrain_source.h"

namespace headland {

struct PlannerChoice {
  std::string name = "boustrophedon";
  Parameters parameters;  // resolved
};

struct Scenario {
  std::filesystem::path file;  // it was read from; relative paths in it start at its folder
  std::string name;
  FieldSource field;
  TerrainSource terrain;
  std::string soil = "firm";
  std::string vehicle;
  double working_width_m = 0.0;  // 0: the vehicle's implement as it is
  PlannerChoice planner;
  PathOptions path;
  SimulationOptions simulation;
  double coverage_cell_m = 0.25;
  VerdictLimits verdict;
  std::uint64_t seed = 1;
};

// Reads and resolves a scenario. Throws InputError with file, line and key for malformed YAML, an
// unknown key (with the nearest known one), a missing one, or a value out of its range.
Scenario read_scenario(const std::filesystem::path& file);

// The scenario with every default written out and file paths made absolute, as YAML.
std::string scenario_yaml(const Scenario& scenario);

// What a scenario describes, loaded.
struct Stage {
  Field field;
  Heightfield terrain;
  Soil soil;
  Vehicle vehicle;
};
Stage load_stage(const Scenario& scenario);

}  // namespace headland
