#include "planner/algorithms/grid_tree_seed.h"

#include "planner/order_transform.h"

namespace headland {

std::span<const ParameterSpec> grid_dtsa_parameters() { return transforming_parameters(); }

GridPlan plan_grid_dtsa(const GridPlanRequest& request) {
  const TransformingSearch tendency = transforming_search(request.parameters);
  const auto improve = [&tendency](OrderSearch& search, Population& population, int i) {
    const int size = static_cast<int>(population.size());
    Individual& one = at(population, i);
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (draw_unit(search.random) < tendency.st1) {
        learn(search, one, population.front(), k, Keep::kNotWorse);
      } else {
        learn_from_any(search, population, i, size, k, Keep::kNotWorse);
      }
      if (draw_unit(search.random) < tendency.st2) transform(search, one, k, tendency.shares);
    }
  };
  return plan_by_population(
      request, {"grid_dtsa", population_of(request.parameters), nearest_cell_order, improve});
}

}  // namespace headland
