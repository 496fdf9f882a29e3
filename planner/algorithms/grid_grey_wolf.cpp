#include "planner/algorithms/grid_grey_wolf.h"

#include <cmath>

#include "planner/order_population.h"

namespace headland {
namespace {

constexpr int kLeaders = 3;

void hunt(OrderSearch& search, Population& population, int i) {
  const double a = 2.0 * (1.0 - share_over(search.search));
  for (int k = search.places.first; k < search.places.end; ++k) {
    if (std::abs(a * (2.0 * draw_unit(search.random) - 1.0)) < 1.0) {
      learn_from_any(search, population, i, kLeaders, k, Keep::kNotWorse);
    } else {
      perturb_weakly(search, at(population, i), k, Keep::kNotWorse);
    }
  }
}

}  // namespace

std::span<const ParameterSpec> grid_gwo_parameters() { return {&population_spec(), 1}; }

GridPlan plan_grid_gwo(const GridPlanRequest& request) {
  return plan_by_population(
      request, {"grid_gwo", population_of(request.parameters), nearest_cell_order, hunt});
}

}  // namespace headland
