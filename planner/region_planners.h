// The planners that order the parts of a region: one signature and one literal table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "planner/region_plan.h"

namespace headland {

using RegionPlanFunction = RegionPlan (*)(const RegionRequest&);

// To add a planner: a file in algorithms/, a declaration there and a line in region_planners.cpp.
// The conformance test picks it up.
struct RegionPlannerEntry {
  std::string_view name;
  std::string_view source;  // paper, or 'headland'
  RegionPlanFunction plan;
  std::span<const ParameterSpec> parameters;
  // Throws InputError(source, "where.name", ...) for resolved parameters that are allowed one by
  // one and not together. The planner itself throws likewise.
  void (*check)(const Parameters&, const std::string& source, const std::string& where) = nullptr;
};

std::span<const RegionPlannerEntry> region_planners();

// Throws InputError (source, "planner.name") with the nearest name when there is none.
const RegionPlannerEntry& find_region_planner(std::string_view name, const std::string& source);

}  // namespace headland
