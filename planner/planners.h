// The planners: one signature and one literal table.
#pragma once

#include <span>
#include <string>
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
  // Throws InputError(source, "where.name", ...) for resolved parameters that are allowed one by
  // one and not together. The planner itself throws likewise.
  void (*check)(const Parameters&, const std::string& source, const std::string& where);
};

std::span<const PlannerEntry> planners();

// Throws InputError (source, "planner.name") with the nearest name when there is none.
const PlannerEntry& find_planner(std::string_view name, const std::string& source);

}  // namespace headland
