// What a scenario says to planners on grid maps.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <optional>
#include <string>

#include "evaluate/given_cell.h"
#include "evaluate/yaml_section.h"
#include "planner/grid_plan.h"
#include "planner/perturbed_plan.h"
#include "terrains/field.h"

namespace headland {

struct GridPlanning {
  GivenCell start = FreeChoice{};
  GivenCell end = FreeChoice{};
  bool closed = false;
  double direction_deg = 0.0;  // of rows on a field, see grid_of_field
  GridCost cost;
  SearchStop stop;
  Perturbation perturb;  // of the plan made
};

// Of the section `planner`. Throws InputError with line and key path.
GridPlanning read_grid_planning(const YamlSection& section);

// Throws InputError when the section has one of those keys; a cost that names a file is for all
// planners.
void refuse_grid_planning(const YamlSection& section);

// The measured costs that `cost` names, as a word or as the file of a section; empty: none.
// Relative names start at `folder`. Whoever plans will tell when it is not there: the results of a
// run outlive it.
std::filesystem::path read_cost_file(const YamlSection& section,
                                     const std::filesystem::path& folder);

// The section `cost`. `file`: the measured costs, or empty.
void emit_grid_cost(YAML::Emitter& out, const GridCost& cost, const std::filesystem::path& file);

// `cost_file`: the measured costs, or empty.
void emit_grid_planning(YAML::Emitter& out, const GridPlanning& planning,
                        const std::filesystem::path& cost_file);

// The cells of a field, each cell_m wide; free cells become what is to be worked of it. Notes tell
// of pockets that cannot be reached and of the ground left out.
GridMap take_grid_of(Field& field, double cell_m, double direction_deg, const std::string& source,
                     std::vector<std::string>& notes);

}  // namespace headland
