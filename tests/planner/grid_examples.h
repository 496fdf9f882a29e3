// Grid maps and requests that the planner's tests share.
#pragma once

#include <string>
#include <vector>

#include "planner/grid_planners.h"
#include "terrains/grid_map_file.h"

namespace headland {

// Of sums of a few hundred shares and their changes.
inline constexpr double kSumRounding = 1e-7;

inline GridMap drawn_map(const std::string& text) { return parse_grid_map(text, 1.0, "drawn"); }

inline GridMap example_map(const std::string& name) {
  return read_grid_map(std::string(HEADLAND_SOURCE_DIR "/examples/maps/") + name + ".txt", 1.0);
}

// Every parameter of the planner at its default.
inline GridPlanRequest grid_request(const GridMap& map, const GridPlannerEntry& planner) {
  GridPlanRequest request;
  request.map = map;
  request.parameters = resolve_parameters(planner.parameters, {}, "test", "");
  return request;
}

inline GridPlanRequest grid_request(const GridMap& map, const std::string& planner) {
  return grid_request(map, find_grid_planner(planner, "test"));
}

inline GridPlan plan_named(const std::string& planner, const GridPlanRequest& request) {
  return find_grid_planner(planner, "test").plan(request);
}

}  // namespace headland
