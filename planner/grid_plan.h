// A plan on a grid map: a path of steps that visits every free cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planner/grid_cost.h"
#include "planner/grid_distances.h"
#include "planner/plan_search.h"
#include "planner/seeded_random.h"
#include "terrains/grid_map.h"
#include "terrains/parameter.h"

namespace headland {

struct GridPlanRequest {
  GridMap map;
  std::optional<GridCell> start;  // where the path begins; none: the planner chooses
  std::optional<GridCell> end;    // likewise; the start: a closed tour
  bool closed = false;            // ends where it begins; neither end given: in node 0 of the graph
  GridCost cost;
  SearchStop stop;
  Parameters parameters;  // resolved against the planner's specs
  std::uint64_t seed = 1;
  CancelAsked cancelled;  // ends planning with Cancelled
};

struct GridPlan {
  std::string planner;
  std::vector<GridCell> cells;  // neighbours follow each other, unless `jumps` says otherwise
  int jumps = 0;                // moves to a cell that is none of the neighbours
  GridCounts counts;
  double cost = 0.0;  // by the request's cost, counted on `cells`
  double fitness = 0.0;
  std::vector<ConvergencePoint> convergence;
  int iterations = 0;
  std::int64_t evaluations = 0;
  StopReason stopped_by = StopReason::kIterations;
};

// Extra visits / free cells, Crr of Wang et al. 2025, Eq (11).
double repeat_rate(const GridPlan& plan);

// What planners work on.
struct GridProblem {
  GridGraph graph;
  int start = -1;  // node; -1: free
  int end = -1;
  bool closed = false;  // start and end are the same of several nodes
};

// Throws InputError as grid_graph, check_grid_cost and check_stop, for a start or end that is
// no free cell, and for different ones of a closed tour.
GridProblem grid_problem(const GridPlanRequest& request);

// A search that runs by the request's limits.
PlanSearch begun_search(const GridPlanRequest& request);

// The plan of a path of nodes; counts and cost are taken from the path anew.
GridPlan finished_plan(const GridPlanRequest& request, const GridProblem& problem,
                       const std::string& planner, const std::vector<int>& path,
                       const PlanSearch& search);

// What messages about a request name as its source.
inline const std::string kGridPlanSource = "grid plan";

// The start; when it is free, any node but the end.
int first_node(const GridProblem& problem, SeededRandom& random);

// A random order of all nodes with the start first and the end last, as far as they are given; a
// closed tour's start is both.
std::vector<int> random_order(const GridProblem& problem, SeededRandom& random);

// The places of an order that may change: [first, end).
struct FreePlaces {
  int first = 0;
  int end = 0;
};
FreePlaces free_places(const GridProblem& problem);

}  // namespace headland
