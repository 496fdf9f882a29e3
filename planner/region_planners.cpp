#include "planner/region_planners.h"

#include <algorithm>
#include <array>
#include <vector>

#include "planner/algorithms/region_de.h"
#include "planner/algorithms/region_enumeration.h"
#include "planner/algorithms/region_exact.h"
#include "planner/algorithms/region_ga.h"
#include "planner/algorithms/region_iga.h"
#include "planner/algorithms/region_local_search.h"
#include "planner/algorithms/region_pso.h"
#include "planner/algorithms/region_shade.h"
#include "terrains/input_error.h"

namespace headland {

std::span<const RegionPlannerEntry> region_planners() {
  static constexpr std::string_view kIga =
      "IGA-CPP, 'improved genetic algorithm based on bi-level "
      "co-evolution for coverage path planning'";
  static const std::array kPlanners{
      RegionPlannerEntry{"region_iga", kIga, plan_region_iga, region_iga_parameters(),
                         check_region_iga},
      RegionPlannerEntry{"region_ga", "genetic algorithm, as used for IGA-CPP", plan_region_ga,
                         region_ga_parameters()},
      RegionPlannerEntry{"region_pso", "Shi and Eberhart 1998, as used for IGA-CPP",
                         plan_region_pso, region_pso_parameters()},
      RegionPlannerEntry{"region_de", "Storn and Price 1997, as used for IGA-CPP", plan_region_de,
                         region_de_parameters()},
      RegionPlannerEntry{"region_shade", "Tanabe and Fukunaga 2013, as used for IGA-CPP",
                         plan_region_shade, region_shade_parameters()},
      RegionPlannerEntry{"region_enumeration", kIga, plan_region_enumeration, {}},
      RegionPlannerEntry{"region_exact", "Held and Karp 1962", plan_region_exact, {}},
      RegionPlannerEntry{"region_local_search", "headland", plan_region_local_search,
                         region_local_search_parameters()},
  };
  return kPlanners;
}

const RegionPlannerEntry& find_region_planner(std::string_view name, const std::string& source) {
  const std::span<const RegionPlannerEntry> all = region_planners();
  const auto found = std::ranges::find(all, name, &RegionPlannerEntry::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const RegionPlannerEntry& entry : all) names.emplace_back(entry.name);
  throw InputError(source, "planner.name", std::string(name),
                   "unknown planner; the nearest is " + nearest_name(name, names));
}

}  // namespace headland
