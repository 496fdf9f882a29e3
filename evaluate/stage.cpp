#include <algorithm>

#include "evaluate/scenario.h"
#include "terrains/soil.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {

Stage load_stage(const Scenario& scenario) {
  const std::string source = scenario.file.string();
  Stage stage;
  stage.field = read_field(scenario.field, source);
  // Not after the scenario's file, which has another name among the results.
  if (scenario.field.file.empty()) stage.field.name = scenario.name;
  stage.terrain = read_terrain(scenario.terrain, stage.field, source);
  // read_scenario has found the name in the table.
  stage.soil = *std::find_if(soils().begin(), soils().end(),
                             [&](const Soil& soil) { return soil.name == scenario.soil; });
  stage.vehicle = load_vehicle(scenario.vehicle);
  stage.vehicle.implement.working_width_m = scenario.working_width_m;
  return stage;
}

}  // namespace headland
