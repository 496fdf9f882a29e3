#include "planner/algorithms/grid_jaya.h"

#include "planner/order_transform.h"

namespace headland {
namespace {

// Whether the node at place k is followed by the same one in both orders.
bool shares_pair(const Individual& one, const Individual& other, int k) {
  return k + 1 < static_cast<int>(one.order.size()) &&
         at(one.order, k + 1) == at(other.next, at(one.order, k));
}

}  // namespace

std::span<const ParameterSpec> grid_djaya_parameters() { return transforming_parameters(); }

GridPlan plan_grid_djaya(const GridPlanRequest& request) {
  const TransformingSearch tendency = transforming_search(request.parameters);
  const auto improve = [&tendency](OrderSearch& search, Population& population, int i) {
    Individual& one = at(population, i);
    for (int k = search.places.first; k < search.places.end; ++k) {
      if (draw_unit(search.random) < tendency.st1) {
        learn(search, one, population.front(), k, Keep::kNotWorse);
      }
      if (draw_unit(search.random) < tendency.st2 || shares_pair(one, population.back(), k)) {
        transform(search, one, k, tendency.shares);
      }
    }
  };
  return plan_by_population(
      request, {"grid_djaya", population_of(request.parameters), nearest_cell_order, improve});
}

}  // namespace headland
