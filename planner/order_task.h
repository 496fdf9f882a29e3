// What planners that search for a good order of cells begin with, and how they end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "planner/grid_plan.h"
#include "planner/order_cost.h"

namespace headland {

// Which distances a search needs.
enum class Tables { kAllPairs, kLocalWhereLarge };

// Its parts point to each other.
struct OrderTask {
  // Throws InputError as grid_problem and, unless the search gets along without, distance_table;
  // Cancelled.
  explicit OrderTask(const GridPlanRequest& request, Tables tables = Tables::kAllPairs);
  OrderTask(const OrderTask&) = delete;
  OrderTask& operator=(const OrderTask&) = delete;

  const GridPlanRequest& request;  // not owned
  GridProblem problem;
  DistanceTable table;  // local_distances where large and the search gets along with them
  OrderCost cost;
  SeededRandom random;
  PlanSearch search;  // where length alone counts it ends at least_steps, unless the map is large
};

// The order in which a path over all cells comes to them first, with the task's start and end in
// their places.
std::vector<int> first_visits(const OrderTask& task, std::span<const GridCell> cells);

// The plan of an order.
GridPlan finished_plan(const OrderTask& task, const std::string& planner,
                       std::span<const int> order);

}  // namespace headland
