// The planners on grid maps: one signature and one literal table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "planner/grid_plan.h"

namespace headland {

using GridPlanFunction = GridPlan (*)(const GridPlanRequest&);

// To add a planner: a file in algorithms/, a declaration there and a line in grid_planners.cpp. The
// conformance test picks it up.
struct GridPlannerEntry {
  std::string_view name;
  std::string_view source;  // paper, or 'headland'
  GridPlanFunction plan;
  std::span<const ParameterSpec> parameters;
  // Throws InputError(source, "where.name", ...) for resolved parameters that are allowed one by
  // one and not together; null: there are none. The planner itself throws likewise.
  void (*check)(const Parameters&, const std::string& source, const std::string& where) = nullptr;
};

std::span<const GridPlannerEntry> grid_planners();

// Throws InputError (source, "planner.name") with the nearest name when there is none.
const GridPlannerEntry& find_grid_planner(std::string_view name, const std::string& source);

}  // namespace headland
