// What planners that search for a good order of cells begin with, and how they end.
#pragma once

#include <span>
#include <string>

#include "planner/grid_plan.h"
#include "planner/order_cost.h"

namespace headland {

// Its parts point to each other.
struct OrderTask {
  // Throws InputError as grid_problem and distance_table; Cancelled.
  explicit OrderTask(const GridPlanRequest& request);
  OrderTask(const OrderTask&) = delete;
  OrderTask& operator=(const OrderTask&) = delete;

  const GridPlanRequest& request;  // not owned
  GridProblem problem;
  DistanceTable table;
  OrderCost cost;
  SeededRandom random;
  GridSearch search;  // ends when least_steps are reached where length alone counts
};

// The plan of an order.
GridPlan finished_plan(const OrderTask& task, const std::string& planner,
                       std::span<const int> order);

}  // namespace headland
