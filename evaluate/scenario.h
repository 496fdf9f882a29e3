// A scenario: everything that names one evaluation, as read from YAML and with every default.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/scenario_grid.h"
#include "evaluate/verdict.h"
#include "planner/drivable_path.h"
#include "planner/plan.h"
#include "sim/simulation.h"
#include "terrains/field_source.h"
#include "terrains/parameter.h"
#include "terrains/soil_source.h"
#include "terrains/terrain_source.h"

namespace headland {

struct PlannerChoice {
  std::string name = "boustrophedon";
  Parameters parameters;             // resolved
  std::optional<GridPlanning> grid;  // of planners on grid maps alone
  // A and B of a guidance line, in the CRS of the field's other points; planners on fields alone.
  std::optional<std::array<Eigen::Vector2d, 2>> ab_line;
  std::vector<EdgeHeadland> headland_edges;  // places in the same CRS
  std::filesystem::path cost_file;           // measured costs to plan by; empty: none
  // Measured costs that only tell the path's energy; empty: those planned by, if any.
  std::filesystem::path predict_file;
  std::string cost_place;  // lines and keys of these, for messages; empty: given otherwise
  std::string predict_place;
  // Likewise of what planners may refuse, by key: parameters, ab_line, headland_edges[i].
  std::map<std::string, std::string> places;
};

// Where it stands in the file, or "planner.key" where that says nothing of it.
std::string place_of(const PlannerChoice& planner, const std::string& key);

struct Scenario {
  std::filesystem::path file;  // it was read from; relative paths in it start at its folder
  std::string name;            // default: the file's stem
  FieldSource field;
  TerrainSource terrain;
  SoilSource soil;
  std::string vehicle;           // name of a built-in one or an absolute folder
  double working_width_m = 0.0;  // default: of the vehicle's implement
  PlannerChoice planner;
  PathOptions path;
  std::string continuous_turns_place;  // line and key, for messages
  std::filesystem::path path_file;     // driven instead of a plan; empty: the field is planned
  double path_tolerance_m = 0.3;       // within which a track is smoothed, see make_drivable
  SimulationOptions simulation;
  double coverage_cell_m = 0.25;
  VerdictLimits verdict;
  std::uint64_t seed = 1;
};

// Reads and resolves a scenario: defaults filled in, parameters completed, file paths absolute.
// `seed` replaces the file's own and the terrain's, even where the file names it. Throws
// InputError with file, line and key path for malformed YAML, an unknown key (with the nearest
// known one), a key given twice, a missing one, a value out of its range, an unknown soil, vehicle,
// planner or generator, or a file that is not there. Every key: docs/scenario.md.
Scenario read_scenario(const std::filesystem::path& file,
                       std::optional<std::uint64_t> seed = std::nullopt);

// The scenario without name, field and planner that stands in a section of another file, which is
// told in messages by its line; `beside` are keys of the section that the caller reads. Throws as
// read_scenario.
Scenario read_drive(const YamlSection& section, std::uint64_t seed,
                    const std::vector<std::string>& beside = {});

// Plans by these measured costs: by their objective where the planner has been asked for lengths,
// else with its objective's terms as measured.
void plan_by_costs(const std::filesystem::path& file, PlannerChoice& planner);

// The scenario with every default written out, as YAML. Reading it gives the same scenario.
std::string scenario_yaml(const Scenario& scenario);

// What a scenario describes, loaded.
struct Stage {
  Field field;
  Heightfield terrain;
  SoilMap soil;
  Vehicle vehicle;                 // with the scenario's working width
  std::optional<GridMap> grid;     // of planners on grid maps alone, with the terrain's heights
  std::vector<std::string> notes;  // for people: where a default stands in for data
};

// The scenario's vehicle with its working width. Throws InputError as load_vehicle and
// check_vehicle do, and for a battery that is empty at the start.
Vehicle vehicle_of(const Scenario& scenario, const std::string& source);

// Of planners on grid maps the field's map is read, or made of cells as wide as the working width;
// what of the field is no free cell is not to be worked then. Throws InputError as read_field,
// read_terrain, read_soil, load_vehicle, grid_of_field and grid_graph do, and for
// a start or end that is no free cell.
Stage load_stage(const Scenario& scenario);

// What the scenario asks of its planner. The stage must outlive the request.
PlanRequest plan_request(const Scenario& scenario, const Stage& stage);

// The same of a planner on grid maps.
GridPlanRequest grid_plan_request(const Scenario& scenario, const Stage& stage);

}  // namespace headland
