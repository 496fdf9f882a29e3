#include "planner/algorithms/grid_student_psychology.h"

namespace headland {
namespace {

constexpr int kGroups = 4;

void study(OrderSearch& search, Population& population, int i) {
  const int size = static_cast<int>(population.size());
  const int group = kGroups * i / size;
  for (int k = search.places.first; k < search.places.end; ++k) {
    if (group == 0) {
      learn_from_any(search, population, i, size, k, Keep::kNotWorse);
    } else if (group == 1) {
      learn(search, at(population, i), population.front(), k, Keep::kNotWorse);
    } else if (group == 2) {
      learn_from_any(search, population, i, i, k, Keep::kNotWorse);
    } else {
      perturb_weakly(search, at(population, i), k, Keep::kNotWorse);
    }
  }
}

}  // namespace

std::span<const ParameterSpec> grid_spbo_parameters() { return {&population_spec(), 1}; }

Improve student_psychology() { return study; }

GridPlan plan_grid_spbo(const GridPlanRequest& request) {
  return plan_by_population(
      request, {"grid_spbo", population_of(request.parameters), nearest_cell_order, study});
}

}  // namespace headland
