#include "planner/perturbed_plan.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"

namespace headland {
namespace {

void expect_complete_path(const GridPlanRequest& request, const GridPlan& plan) {
  const std::set<GridCell> visited(plan.cells.begin(), plan.cells.end());
  EXPECT_EQ(static_cast<int>(visited.size()), free_cell_count(request.map));
  for (const GridCell cell : visited) EXPECT_TRUE(is_free(request.map, cell));
  for (std::size_t i = 1; i < plan.cells.size(); ++i) {
    const GridCell a = plan.cells[i - 1];
    const GridCell b = plan.cells[i];
    EXPECT_EQ(std::abs(a.column - b.column) + std::abs(a.row - b.row), 1);
  }
  EXPECT_EQ(plan.jumps, 0);
  EXPECT_EQ(plan.counts.steps, static_cast<int>(plan.cells.size()) - 1);
}

// Of every planner's plan, with free, given and closed ends.
TEST(PerturbedPlan, IsAnotherCompletePathBetweenTheSameEnds) {
  const GridMap map = made_up_grid_map({9, 8, 0.15, 4, 1}, "test");
  for (const GridPlannerEntry& planner : grid_planners()) {
    GridPlanRequest request = grid_request(map, planner);
    request.stop.iterations = 2;
    for (const bool closed : {false, true}) {
      request.closed = closed;
      const GridPlan plan = planner.plan(request);
      const GridPlan perturbed = perturbed_plan(request, plan, {3, 5});
      SCOPED_TRACE(std::string(planner.name) + (closed ? ", closed" : ""));
      expect_complete_path(request, perturbed);
      EXPECT_NE(perturbed.cells, plan.cells);
      EXPECT_EQ(perturbed.cells, perturbed_plan(request, plan, {3, 5}).cells);
      EXPECT_NE(perturbed.cells, perturbed_plan(request, plan, {3, 6}).cells);
      // Control: no change is none.
      EXPECT_EQ(perturbed_plan(request, plan, {0, 5}).cells, plan.cells);
      if (!closed) continue;
      EXPECT_EQ(perturbed.cells.front(), plan.cells.front());
      EXPECT_EQ(perturbed.cells.back(), plan.cells.front());
    }
  }
}

TEST(PerturbedPlan, KeepsGivenEnds) {
  const GridMap map = drawn_map("......\n.#....\n......\n");
  GridPlanRequest request = grid_request(map, "grid_local_search");
  request.stop.iterations = 3;
  request.start = GridCell{0, 0};
  request.end = GridCell{5, 2};
  const GridPlan plan = plan_named("grid_local_search", request);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const GridPlan perturbed = perturbed_plan(request, plan, {4, seed});
    expect_complete_path(request, perturbed);
    EXPECT_EQ(perturbed.cells.front(), *request.start);
    EXPECT_EQ(perturbed.cells.back(), *request.end);
    EXPECT_GE(perturbed.cost, plan.cost);  // this map's plan is the shortest there is
  }
}

// Where there is nothing to turn round.
TEST(PerturbedPlan, LeavesASingleCell) {
  const GridPlanRequest request = grid_request(drawn_map("."), "grid_boustrophedon");
  const GridPlan plan = plan_named("grid_boustrophedon", request);
  EXPECT_EQ(perturbed_plan(request, plan, {5, 1}).cells, plan.cells);
}

}  // namespace
}  // namespace headland
