#include "planner/grid_prices.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/grid_path.h"
#include "tests/planner/grid_examples.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

constexpr double kPriceRounding = 1e-9;

GridGraph graph_of(double (*height_m)(int column, int row)) {
  GridMap map = free_grid_map(6, 5);
  map.cell_m = 2.0;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.height_m.push_back(height_m(column, row));
    }
  }
  return grid_graph(map, "test");
}

double price(const GridGraph& graph, const std::vector<int>& path) {
  return count_path(graph, path).step_wh;
}

TEST(GridPricesTest, AreThoseOfTheCellsAndRows) {
  const GridPrices prices = grid_prices(made_up_cost(), 2.0);
  EXPECT_NEAR(prices.step, 0.8, kPriceRounding);
  EXPECT_NEAR(prices.cell, 1.2, kPriceRounding);
  EXPECT_NEAR(prices.turn, 2.2, kPriceRounding);
  EXPECT_NEAR(prices.u_turn, 4.4, kPriceRounding);
  EXPECT_NEAR(prices.level_wh_per_m, 1.0, kPriceRounding);
}

TEST(GridPricesTest, OnLevelGroundEveryStepIsOne) {
  GridGraph graph = graph_of([](int, int) { return 3.0; });
  for (const auto& node : step_prices(made_up_cost(), graph)) {
    for (const double step : node) {
      if (step == 0.0) continue;  // none in that direction
      EXPECT_NEAR(step, 0.8, kPriceRounding);
    }
  }
}

// Steps along the contour of a ramp are cheaper than up and down it, and up and down together cost
// what the two cost, whatever is done about heights.
TEST(GridPricesTest, SlopesAreDirectedAndRoundTripsCostWhatTheyDo) {
  GridGraph graph = graph_of([](int column, int) { return 0.2 * column; });
  const DriveCost cost = made_up_cost();
  graph.step_wh = step_prices(cost, graph);
  const double contour = price(graph, {7, 13});
  const double up = price(graph, {7, 8});
  const double down = price(graph, {8, 7});
  EXPECT_NEAR(contour, 2.0 * (0.4 + cost.working.across_wh_per_m * 0.01), kPriceRounding);
  EXPECT_NEAR(up + down, 2.0 * (2.0 * (0.4 - 1.0) + 1.8 + 0.4), kPriceRounding);
  EXPECT_GT(up + down, 2.0 * contour);
  EXPECT_GE(up, 0.0);
  EXPECT_GE(down, 0.0);
}

// Where going up gently and down steeply costs more than the other way round.
TEST(GridPricesTest, WaysRoundAHillDifferByDirection) {
  GridGraph graph = graph_of(
      [](int column, int) { return column < 4 ? 0.1 * column : 0.3 - 0.3 * (column - 3); });
  graph.step_wh = step_prices(made_up_cost(), graph);
  const std::vector<int> there = {0, 1, 2, 3, 4};
  const std::vector<int> back = {4, 3, 2, 1, 0};
  EXPECT_GT(price(graph, there), price(graph, back) + 0.01);
}

TEST(GridPricesTest, PapersTermsTakeTheirMeasuredValues) {
  GridCost cost;
  cost.measured = made_up_cost();
  GridCounts counts;
  counts.steps = 20;
  counts.repeats = 3;
  counts.turns = 4;
  counts.u_turns = 1;
  counts.distinct_cells = 18;
  counts.level_m = 40.0;
  cost.objective = GridObjective::kWeighted;
  EXPECT_NEAR(cost_of(cost, counts, 2.0), 3 * 0.8 + 4 * 2.2 + 4.4, kPriceRounding);
  cost.objective = GridObjective::kTractor;
  EXPECT_NEAR(cost_of(cost, counts, 2.0), 40.0 + 4 * 2.2 + 2 * 2.2, kPriceRounding);
  cost.objective = GridObjective::kLength;
  EXPECT_NEAR(cost_of(cost, counts, 2.0), 20.0, kPriceRounding);
  cost.objective = GridObjective::kMeasured;
  // By all that was measured two turns into the next row cost less than two corners.
  counts.step_wh = 16.0;
  const double corner = grid_prices(*cost.measured, 2.0).corner;
  EXPECT_GT(corner, 2.2);
  EXPECT_NEAR(cost_of(cost, counts, 2.0), 18 * 1.2 + 16.0 + 4 * corner + 4.4, kPriceRounding);
  counts.row_changes = 2;
  EXPECT_NEAR(cost_of(cost, counts, 2.0), 18 * 1.2 + 16.0 + 2 * (2 * 2.2) + 4.4, kPriceRounding);
}

TEST(GridPricesTest, RowChangesAreTwoTurnsToOneSideAStepApart) {
  const GridGraph graph = grid_graph(free_grid_map(6, 5), "test");
  const auto row_changes = [&](const std::vector<int>& path) {
    return count_path(graph, path).row_changes;
  };
  EXPECT_EQ(row_changes({0, 1, 2, 8, 7, 6}), 1);    // into the next row and back along it
  EXPECT_EQ(row_changes({6, 7, 8, 2, 1, 0}), 1);    // to the right
  EXPECT_EQ(row_changes({0, 1, 2, 8, 9, 10}), 0);   // on in the same direction
  EXPECT_EQ(row_changes({0, 1, 2, 8, 14, 13}), 0);  // two rows on
  EXPECT_EQ(row_changes({0, 1, 7, 6, 12, 13, 19, 18}), 3);
}

// On a ramp the search lays its rows along the contour, whichever way the ramp looks.
TEST(GridPricesTest, RowsFollowTheContour) {
  for (const bool east : {true, false}) {
    GridMap map = free_grid_map(8, 8);
    map.cell_m = 2.0;
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 8; ++column) {
        map.height_m.push_back(0.4 * (east ? column : row));
      }
    }
    GridPlanRequest request = grid_request(map, "grid_local_search");
    request.cost.objective = GridObjective::kMeasured;
    request.cost.measured = made_up_cost();
    request.stop.iterations = 5;
    const GridPlan plan = plan_named("grid_local_search", request);
    int along = 0;
    for (std::size_t i = 1; i < plan.cells.size(); ++i) {
      const bool is_row_step = plan.cells[i].row == plan.cells[i - 1].row;
      along += is_row_step == !east ? 1 : 0;
    }
    EXPECT_GE(along, 50) << east;  // of 63 steps; the least is 7 of the other kind
    EXPECT_EQ(plan.counts.distinct_cells, 64);
  }
}

}  // namespace
}  // namespace headland
