#include "planner/perturbed_plan.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "planner/order_task.h"

namespace headland {

GridPlan perturbed_plan(const GridPlanRequest& request, const GridPlan& plan,
                        const Perturbation& perturbation) {
  if (perturbation.changes == 0) return plan;
  const OrderTask task(request, Tables::kLocalWhereLarge);
  const FreePlaces places = free_places(task.problem);
  const int free = places.end - places.first;
  if (free < 2) return plan;
  std::vector<int> order = first_visits(task, plan.cells);
  SeededRandom random(perturbation.seed);
  for (int change = 0; change < perturbation.changes; ++change) {
    const int one = draw_below(random, free);
    const int step = 1 + draw_below(random, free - 1);
    const int other = (one + step) % free;
    const auto begin = order.begin() + places.first;
    std::reverse(begin + std::min(one, other), begin + std::max(one, other) + 1);
  }
  const GridPlan made = finished_plan(task, plan.planner, order);
  GridPlan perturbed = plan;
  perturbed.cells = made.cells;
  perturbed.jumps = made.jumps;
  perturbed.counts = made.counts;
  perturbed.cost = made.cost;
  perturbed.fitness = made.fitness;
  return perturbed;
}

}  // namespace headland
