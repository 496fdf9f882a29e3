#include "planner/planners.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "planner/algorithms/boustrophedon.h"
#include "planner/algorithms/decomposed.h"
#include "planner/swath_plan.h"
#include "terrains/input_error.h"

namespace headland {

std::span<const PlannerEntry> planners() {
  static const std::array kPlanners{
      PlannerEntry{"boustrophedon",
                   "Choset, 'Coverage of known spaces: the boustrophedon cellular decomposition', "
                   "Autonomous Robots 9, 2000",
                   plan_boustrophedon, boustrophedon_parameters(), check_boustrophedon},
      PlannerEntry{"decomposed",
                   "IGA-CPP's decomposition, Held and Karp 1962, and headland's own order of parts",
                   plan_decomposed, decomposed_parameters(), check_swath_parameters},
  };
  return kPlanners;
}

const PlannerEntry& find_planner(std::string_view name, const std::string& source) {
  const std::span<const PlannerEntry> all = planners();
  const auto found = std::ranges::find(all, name, &PlannerEntry::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const PlannerEntry& entry : all) names.emplace_back(entry.name);
  throw InputError(source, "planner.name", std::string(name),
                   "unknown planner; the nearest is " + nearest_name(name, names));
}

}  // namespace headland
