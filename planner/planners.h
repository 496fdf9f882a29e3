// The planners: one signature and one literal table.
#pragma once

#include <span>
#include <string_view>

#include "planner/plan.h"

namespace headland {

using PlanFunction = Plan (*)(const PlanRequest&);

// To add a planner: a file in algorithms/, a declaration there and a line in planners.cpp. The
// conformance test, the command line and the docs table pick it up.
struct PlannerEntry {
  std::string_view name;
  std::string_view source;  // paper, book or 'headland'
  PlanFunction plan;
  std::span<const ParameterSpec> parameters;
};

std::span<const PlannerEntry> planners();

// Throws InputError (source, "planner.name") with the nearest name when there is none.
const PlannerEntry& find_planner(std::string_view name, const std::string& source);

}  // namespace headland
