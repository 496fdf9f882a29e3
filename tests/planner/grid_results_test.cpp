// What grid planners are known to reach on some maps.
#include "planner/grid_planners.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "planner/grid_bound.h"
#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"

namespace headland {
namespace {

// Wu et al. 2023, Table 1 (repeats there in m2 of 4 m2 cells).
TEST(GridBoustrophedon, GivesThePapersTable) {
  using Row = std::tuple<const char*, int, int, int>;
  for (const auto& [name, repeats, turns, u_turns] :
       {Row{"field_A", 0, 22, 0}, Row{"field_B", 8, 32, 1}, Row{"field_C", 4, 26, 4},
        Row{"field_D", 9, 34, 5}}) {
    const GridPlanRequest request = grid_request(example_map(name), "grid_boustrophedon");
    const GridCounts counts = plan_named("grid_boustrophedon", request).counts;
    EXPECT_EQ(std::tie(counts.repeats, counts.turns, counts.u_turns),
              std::tie(repeats, turns, u_turns))
        << name;
  }
}

TEST(GridBoustrophedon, TakesMapsOfAMillionCells) {
  const GridPlanRequest request = grid_request(free_grid_map(1000, 1000), "grid_boustrophedon");
  const GridPlan plan = plan_named("grid_boustrophedon", request);
  EXPECT_EQ(plan.counts.repeats, 0);
  EXPECT_EQ(plan.counts.turns, 2 * 999);
}

// The shortest path that visits every cell of a map of up to 16, by breadth-first search over
// (cells visited, where).
int shortest_by_brute_force(const GridProblem& problem) {
  if (problem.graph.size() == 1) return 0;
  const int nodes = problem.graph.size();
  const auto state = [nodes](std::uint32_t visited, int node) {
    return static_cast<std::size_t>(visited) * static_cast<std::size_t>(nodes) +
           static_cast<std::size_t>(node);
  };
  const std::uint32_t all = (1U << nodes) - 1U;
  std::vector<int> steps(state(all, nodes - 1) + 1, -1);
  std::vector<std::pair<std::uint32_t, int>> queue;
  for (int node = 0; node < nodes; ++node) {
    if (problem.start >= 0 && node != problem.start) continue;
    steps[state(1U << node, node)] = 0;
    queue.emplace_back(1U << node, node);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const auto [visited, node] = queue[i];
    if (visited == all && (problem.end < 0 || node == problem.end)) {
      return steps[state(visited, node)];
    }
    for (const int next : problem.graph.beside[node]) {
      if (next < 0) continue;
      const std::uint32_t more = visited | (1U << next);
      if (steps[state(more, next)] >= 0) continue;
      steps[state(more, next)] = steps[state(visited, node)] + 1;
      queue.emplace_back(more, next);
    }
  }
  return -1;
}

TEST(GridPlans, AreNotShorterThanTheShortest) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    GridPlanRequest request;
    request.map = made_up_grid_map({4, 4, 0.2, 2, seed}, "test");
    if (seed % 2 == 0) request.start = GridCell{0, 3};
    if (seed % 3 == 0) request.end = GridCell{3, 0};
    request.closed = seed % 4 == 0 && !request.end;
    request.stop.iterations = 40;
    const int shortest = shortest_by_brute_force(grid_problem(request));
    EXPECT_LE(least_steps(grid_problem(request)), shortest);
    for (const GridPlannerEntry& planner : grid_planners()) {
      if (planner.name == "grid_ga") continue;
      request.parameters = resolve_parameters(planner.parameters, {}, "test", "");
      const int steps = planner.plan(request).counts.steps;
      EXPECT_GE(steps, shortest) << planner.name;
      if (planner.name == "grid_local_search" || planner.name == "grid_tplp") {
        EXPECT_EQ(steps, shortest) << planner.name << ", seed " << seed;
      }
    }
  }
}

// On maps by Table 7 of Wang et al. 2025; 358 is the proven optimum with these ends.
TEST(GridPlans, LocalSearchSolvesEnvironmentOne) {
  GridPlanRequest request = grid_request(example_map("env_I"), "grid_local_search");
  request.start = GridCell{0, 19};
  request.end = GridCell{19, 0};
  request.stop.iterations = 50;
  const GridPlan plan = plan_named("grid_local_search", request);
  EXPECT_EQ(plan.counts.steps, 358);
  EXPECT_EQ(plan.stopped_by, StopReason::kNothingBetter);
}

// Wu et al. 2023 with the weights 0.3 / 0.2 / 0.5: the optimum of both fields, proven by an integer
// program.
TEST(GridPlans, LocalSearchReachesProvenOptimaOfFields) {
  for (const char* const name : {"field_A", "field_B"}) {
    GridPlanRequest request = grid_request(example_map(name), "grid_local_search");
    request.cost.objective = GridObjective::kWeighted;
    request.stop.iterations = 4;
    EXPECT_NEAR(plan_named("grid_local_search", request).cost, 4.4, kSumRounding) << name;
  }
}

// More cells than tables of all distances are made for.
TEST(GridPlans, LocalSearchTakesLargeMaps) {
  GridPlanRequest request;
  request.map = made_up_grid_map({160, 150, 0.1, 40, 5}, "test");
  request.start = GridCell{0, 149};
  ASSERT_GT(free_cell_count(request.map), kMaxTableNodes);
  request.stop.iterations = 1;
  request.stop.evaluations = 100000;
  for (const bool closed : {false, true}) {
    request.closed = closed;
    const int by_rows = plan_named("grid_boustrophedon", request).counts.steps;
    request.parameters =
        resolve_parameters(find_grid_planner("grid_local_search", "test").parameters, {}, "", "");
    const GridPlan plan = plan_named("grid_local_search", request);
    EXPECT_EQ(plan.jumps, 0);
    EXPECT_EQ(plan.counts.distinct_cells, free_cell_count(request.map));
    EXPECT_EQ(plan.cells.front(), *request.start);
    EXPECT_EQ(plan.cells.back() == plan.cells.front(), closed);
    EXPECT_LT(plan.counts.steps, by_rows);
    EXPECT_EQ(plan.convergence.back().cost, plan.cost);
    request.parameters.clear();
  }
}

// 358 is the proven optimum; on IV, of 1310 steps at least, the paper prints 1330.2 on its own map,
// and 20 seeds come to 1317.9 with a standard deviation of about 2.
TEST(GridPlans, TplpSolvesEnvironmentOne) {
  GridPlanRequest request = grid_request(example_map("env_I"), "grid_tplp");
  request.start = GridCell{0, 19};
  request.end = GridCell{19, 0};
  EXPECT_EQ(plan_named("grid_tplp", request).counts.steps, 358);
}

TEST(GridPlans, TplpComesNearTheLeastOfEnvironmentFour) {
  GridPlanRequest request = grid_request(example_map("env_IV"), "grid_tplp");
  request.start = GridCell{0, request.map.rows - 1};
  request.end = GridCell{request.map.columns - 1, 0};
  const int steps = plan_named("grid_tplp", request).counts.steps;
  EXPECT_GE(steps, 1310);
  EXPECT_LE(steps, 1325);
}

}  // namespace
}  // namespace headland
