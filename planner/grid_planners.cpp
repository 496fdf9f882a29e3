#include "planner/grid_planners.h"

#include <algorithm>
#include <array>
#include <vector>

#include "planner/algorithms/grid_ant_colony.h"
#include "planner/algorithms/grid_boustrophedon.h"
#include "planner/algorithms/grid_genetic.h"
#include "planner/algorithms/grid_grey_wolf.h"
#include "planner/algorithms/grid_jaya.h"
#include "planner/algorithms/grid_local_search.h"
#include "planner/algorithms/grid_student_psychology.h"
#include "planner/algorithms/grid_tplp.h"
#include "planner/algorithms/grid_tree_seed.h"
#include "terrains/input_error.h"

namespace headland {

std::span<const GridPlannerEntry> grid_planners() {
  static constexpr std::string_view kWu =
      "Wu et al., 'Field complete coverage path planning based on improved genetic algorithm for "
      "transplanting robot', 2023, 10.20944/preprints202305.1306.v1";
  static constexpr std::string_view kWang =
      "Wang et al., 'Complete-coverage path-planning algorithm based on transition probability and "
      "learning perturbation operator', 2025, 10.20944/preprints202504.0101.v1";
  static const std::array kPlanners{
      GridPlannerEntry{"grid_boustrophedon", kWu, plan_grid_boustrophedon, {}},
      GridPlannerEntry{"grid_tplp", kWang, plan_grid_tplp, grid_tplp_parameters(), check_grid_tplp},
      GridPlannerEntry{"grid_iga", kWu, plan_grid_iga, grid_iga_parameters(), check_grid_genetic},
      GridPlannerEntry{"grid_ga", kWu, plan_grid_ga, grid_ga_parameters(), check_grid_genetic},
      GridPlannerEntry{"grid_aco", "Dorigo, Maniezzo, Colorni 1996, as used by Wang et al. 2025",
                       plan_grid_aco, grid_aco_parameters()},
      GridPlannerEntry{"grid_gwo", "Mirjalili et al. 2014, as used by Wang et al. 2025",
                       plan_grid_gwo, grid_gwo_parameters()},
      GridPlannerEntry{"grid_spbo", "Das et al. 2020, as used by Wang et al. 2025", plan_grid_spbo,
                       grid_spbo_parameters()},
      GridPlannerEntry{"grid_djaya", "Gunduz and Aslan 2021, as used by Wang et al. 2025",
                       plan_grid_djaya, grid_djaya_parameters()},
      GridPlannerEntry{"grid_dtsa", "Cinar et al. 2020, as used by Wang et al. 2025",
                       plan_grid_dtsa, grid_dtsa_parameters()},
      GridPlannerEntry{"grid_local_search", "headland", plan_grid_local_search,
                       grid_local_search_parameters()},
  };
  return kPlanners;
}

const GridPlannerEntry& find_grid_planner(std::string_view name, const std::string& source) {
  const std::span<const GridPlannerEntry> all = grid_planners();
  const auto found = std::ranges::find(all, name, &GridPlannerEntry::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const GridPlannerEntry& entry : all) names.emplace_back(entry.name);
  throw InputError(source, "planner.name", std::string(name),
                   "unknown planner; the nearest is " + nearest_name(name, names));
}

}  // namespace headland
