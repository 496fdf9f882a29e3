// Parts of scenarios as other files take them, too.
#pragma once

#include <filesystem>

#include "evaluate/scenario.h"
#include "evaluate/yaml_section.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Each reads the section of its name in `top`; relative file names start at `folder`. Throw
// InputError as read_scenario.
FieldSource read_field_source(const YamlSection& top, const std::filesystem::path& folder);
// With the scenario's seed where the section has none.
void read_terrain_source(const YamlSection& top, const std::filesystem::path& folder,
                         Scenario& scenario);
PlannerChoice read_planner(const YamlSection& top);

// The numbers of a field that is a grid map: what they are by default follows from the vehicle and
// from the scenario's path and planner.
void read_grid_map_numbers(const YamlSection& top, const Vehicle& vehicle, Scenario& scenario);

}  // namespace headland
