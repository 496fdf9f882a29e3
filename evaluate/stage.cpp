#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "evaluate/scenario.h"
#include "planner/planned_vehicle.h"
#include "terrains/geo_frame.h"
#include "terrains/grid_map_file.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_check.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

// A start or end that no planner could keep is refused where it stands.
void check_grid_ends(const Scenario& scenario, const GridMap& map) {
  const std::string source = scenario.file.string();
  const GridPlanning& planning = *scenario.planner.grid;
  const GridGraph graph =
      grid_graph(map, scenario.field.grid_map.empty() ? source : scenario.field.grid_map.string());
  for (const auto& [given, where] :
       {std::pair{planning.start, "planner.start"}, std::pair{planning.end, "planner.end"}}) {
    if (const auto cell = cell_of(given, map)) node_at(map, graph, *cell, source, where);
  }
}

void load_grid(const Scenario& scenario, Stage& stage) {
  const FieldSource& field = scenario.field;
  stage.grid = field.grid_map.empty() ? take_grid_of(stage.field, scenario.working_width_m,
                                                     scenario.planner.grid->direction_deg,
                                                     scenario.file.string(), stage.notes)
                                      : read_grid_map(field.grid_map, field.cell_m);
  if (std::abs(stage.grid->cell_m - scenario.working_width_m) > kSamePlace_m) {
    stage.notes.push_back(fmt::format("grid: cells of {:g} m are worked {:g} m wide",
                                      stage.grid->cell_m, scenario.working_width_m));
  }
  check_grid_ends(scenario, *stage.grid);
}

// Points of the planner's keys, which are in the CRS of the field's others.
std::vector<Eigen::Vector2d> planner_points_W(const Scenario& scenario, const GeoFrame& frame,
                                              const std::vector<Eigen::Vector2d>& given,
                                              const std::string& place) {
  if (given.empty() || !frame.georeferenced) return given;
  const std::string crs = scenario.field.crs.empty() ? "EPSG:4326" : scenario.field.crs;
  return local_from_wgs84(frame, wgs84_from_crs(crs, given, scenario.file.string() + ": " + place));
}

std::optional<std::array<Eigen::Vector2d, 2>> ab_line_W(const Scenario& scenario,
                                                        const GeoFrame& frame) {
  const auto& given = scenario.planner.ab_line;
  if (!given) return given;
  const std::vector<Eigen::Vector2d> points_W = planner_points_W(
      scenario, frame, {given->front(), given->back()}, place_of(scenario.planner, "ab_line"));
  return std::array{points_W.front(), points_W.back()};
}

std::vector<EdgeHeadland> headland_edges_W(const Scenario& scenario, const GeoFrame& frame) {
  std::vector<EdgeHeadland> edges = scenario.planner.headland_edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].at_W) continue;
    edges[i].at_W = planner_points_W(scenario, frame, {*edges[i].at_W},
                                     place_of(scenario.planner, headland_edge_key(i)))
                        .front();
  }
  return edges;
}

}  // namespace

Vehicle vehicle_of(const Scenario& scenario, const std::string& source) {
  Vehicle vehicle = load_vehicle(scenario.vehicle);
  vehicle.implement.working_width_m = scenario.working_width_m;
  check_vehicle(vehicle, source);  // draft goes with the width
  const double empty_soc = vehicle.battery.empty_soc;
  if (scenario.simulation.soc_start <= empty_soc) {
    throw InputError(source, "simulation.soc_start",
                     fmt::format("{:g}", scenario.simulation.soc_start),
                     fmt::format("more than {:g}, at which the battery of {} is empty", empty_soc,
                                 vehicle.name));
  }
  return vehicle;
}

Stage load_stage(const Scenario& scenario) {
  const std::string source = scenario.file.string();
  Stage stage;
  stage.field = read_field(scenario.field, source, &stage.notes);
  // Not after a file: the scenario's has another name among the results.
  stage.field.name = scenario.name;
  if (scenario.planner.grid) load_grid(scenario, stage);
  stage.terrain = read_terrain(scenario.terrain, stage.field, source);
  if (stage.grid) set_heights(*stage.grid, stage.terrain);
  SoilReading soil = read_soil(scenario.soil, stage.field, source);
  stage.soil = std::move(soil.map);
  if (soil.default_ratio > 0.0) {
    stage.notes.push_back(
        fmt::format("soil: {} says nothing about {:.3g} % of the field; {} holds there",
                    soil_text(scenario.soil), 100.0 * soil.default_ratio, scenario.soil.soil.name));
  }
  stage.vehicle = vehicle_of(scenario, source);
  return stage;
}

void plan_by_costs(const std::filesystem::path& file, PlannerChoice& planner) {
  planner.cost_file = file;
  planner.cost_place.clear();
  if (planner.grid && planner.grid->cost.objective == GridObjective::kLength) {
    planner.grid->cost.objective = GridObjective::kMeasured;
  }
}

PlanRequest plan_request(const Scenario& scenario, const Stage& stage) {
  const Vehicle& vehicle = stage.vehicle;
  PlanRequest request;
  request.field = stage.field;
  request.terrain = &stage.terrain;
  set_vehicle(request, vehicle);
  request.clearance_m = scenario.path.clearance_m;
  request.parameters = scenario.planner.parameters;
  request.ab_line_W = ab_line_W(scenario, stage.field.frame);
  request.headland_edges = headland_edges_W(scenario, stage.field.frame);
  request.seed = scenario.seed;
  return request;
}

GridPlanRequest grid_plan_request(const Scenario& scenario, const Stage& stage) {
  const GridPlanning& planning = *scenario.planner.grid;
  GridPlanRequest request;
  request.map = *stage.grid;
  request.start = cell_of(planning.start, *stage.grid);
  request.end = cell_of(planning.end, *stage.grid);
  request.closed = planning.closed;
  request.cost = planning.cost;
  request.stop = planning.stop;
  request.parameters = scenario.planner.parameters;
  request.seed = scenario.seed;
  return request;
}

}  // namespace headland
