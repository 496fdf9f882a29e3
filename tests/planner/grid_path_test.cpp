#include "planner/grid_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "planner/grid_bound.h"
#include "planner/grid_cost.h"
#include "planner/order_walk.h"
#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

constexpr double kCostRounding = 1e-9;  // of sums of a few hundred shares

// Eq (3) of Wang et al. 2025, as it stands.
std::vector<int> floyd(const GridGraph& graph) {
  const int nodes = graph.size();
  const auto at = [nodes](int i, int j) { return i * nodes + j; };
  std::vector<int> steps(static_cast<std::size_t>(nodes * nodes), nodes);
  for (int i = 0; i < nodes; ++i) {
    steps[at(i, i)] = 0;
    for (const int next : graph.beside[i]) {
      if (next >= 0) steps[at(i, next)] = 1;
    }
  }
  for (int k = 0; k < nodes; ++k) {
    for (int i = 0; i < nodes; ++i) {
      for (int j = 0; j < nodes; ++j) {
        steps[at(i, j)] = std::min(steps[at(i, j)], steps[at(i, k)] + steps[at(k, j)]);
      }
    }
  }
  return steps;
}

TEST(GridDistances, AreThoseOfFloyd) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const GridGraph graph = grid_graph(made_up_grid_map({12, 9, 0.25, 6, seed}, "test"), "test");
    const DistanceTable table = distance_table(graph, "test");
    const std::vector<int> expected = floyd(graph);
    for (int i = 0; i < graph.size(); ++i) {
      for (int j = 0; j < graph.size(); ++j) {
        EXPECT_EQ(table(i, j), expected[static_cast<std::size_t>(i * graph.size() + j)]);
      }
    }
  }
}

TEST(GridDistances, WaysAreShortestAndTheSameBack) {
  const GridGraph graph = grid_graph(made_up_grid_map({12, 9, 0.25, 6, 3}, "test"), "test");
  const DistanceTable table = distance_table(graph, "test");
  BreadthFirst search(graph);
  for (int i = 0; i < graph.size(); ++i) {
    for (int j = 0; j < graph.size(); ++j) {
      std::vector<int> there = {i};
      append_way(graph, table, i, j, there);
      std::vector<int> back = {j};
      append_way(graph, table, j, i, back);
      std::ranges::reverse(back);
      EXPECT_EQ(there, back);
      EXPECT_EQ(there.back(), j);
      EXPECT_EQ(static_cast<int>(there.size()) - 1, table(i, j));
      for (std::size_t k = 1; k < there.size(); ++k) {
        EXPECT_GE(direction_between(graph, there[k - 1], there[k]), 0);
      }
      const auto found = way_to(search, i, {1, 0, 2, 3}, [j](int node) { return node == j; });
      EXPECT_EQ(static_cast<int>(found.size()), table(i, j));
    }
  }
}

TEST(GridDistances, AreRefusedAboveTheirLimit) {
  const GridGraph graph = grid_graph(free_grid_map(201, 100), "map.txt");
  EXPECT_EQ(headland::refusal([&] { distance_table(graph, "map.txt"); }),
            "map.txt: map: '20100 free cells': at most 20000 for this planner, which needs the "
            "distances between all of them; grid_boustrophedon and grid_local_search take more");
}

TEST(GridGraph, RefusesCellsThatAreCutOff) {
  EXPECT_EQ(headland::refusal([] { grid_graph(drawn_map("..#.\n..#.\n"), "map.txt"); }),
            "map.txt: map: '2 of 6 free cells': cannot be reached from the rest, first column 3, "
            "row 0 (from 0 in the south-west); block them or open a way of whole cells");
}

// The map of Wu et al. 2023, Figure 5, drawn by the neighbours that 2.2.1 tells: from the south
// 1 2 3 4 / 5 6 7 8 / 9 10, where 2 is blocked. In its Figure 7, 1 goes to 5 and 7 to 3.
struct PaperMap {
  GridGraph graph;
  DistanceTable table;

  // The paper's numbers, without 2, are the nodes in their order.
  std::vector<int> nodes_of(const std::vector<int>& numbers) const {
    std::vector<int> nodes;
    for (const int number : numbers) nodes.push_back(number == 1 ? 0 : number - 2);
    return nodes;
  }
};

PaperMap paper_map() {
  PaperMap map;
  map.graph = grid_graph(drawn_map("..##\n....\n.#..\n"), "test");
  map.table = distance_table(map.graph, "test");
  return map;
}

TEST(Adjusted, IsThePapersExample) {
  const PaperMap map = paper_map();
  const std::vector<int> path =
      adjusted(map.graph, map.table, map.nodes_of({1, 8, 10, 6, 9, 7, 4, 3, 5}), false);
  EXPECT_EQ(path, map.nodes_of({1, 5, 6, 7, 8, 7, 6, 10, 9, 5, 6, 7, 3, 4}));
}

TEST(Adjusted, KeepsTheEndWhenAsked) {
  const PaperMap map = paper_map();
  const std::vector<int> order = map.nodes_of({1, 8, 10, 6, 9, 7, 4, 3, 5});
  EXPECT_EQ(adjusted(map.graph, map.table, order, true).back(), order.back());
  EXPECT_NE(adjusted(map.graph, map.table, order, false).back(), order.back());
}

TEST(Expanded, IsAsLongAsItsWays) {
  const PaperMap map = paper_map();
  const std::vector<int> order = map.nodes_of({1, 8, 10, 6, 9, 7, 4, 3, 5});
  int steps = 0;
  for (std::size_t i = 1; i < order.size(); ++i) steps += map.table(order[i - 1], order[i]);
  EXPECT_EQ(count_path(map.graph, expanded(order_cost(map.graph, map.table, {}), order)).steps,
            steps);
}

// Cells by letters of a drawn path, walked from the south-west of a 3 x 3 map.
GridCounts walked(const std::string& moves) {
  const GridGraph graph = grid_graph(free_grid_map(3, 3), "test");
  std::vector<int> path = {0};
  for (const char move : moves) {
    path.push_back(graph.beside[path.back()][std::string("LURD").find(move)]);
  }
  return count_path(graph, path);
}

TEST(CountPath, CountsTurnsAndUTurns) {
  const GridCounts straight = walked("RR");
  EXPECT_EQ(straight.steps, 2);
  EXPECT_EQ(straight.turns + straight.u_turns + straight.repeats, 0);
  const GridCounts rows = walked("RRULLURR");
  EXPECT_EQ(rows.turns, 4);
  EXPECT_EQ(rows.u_turns, 0);
  EXPECT_EQ(rows.distinct_cells, 9);
  const GridCounts back = walked("RL");
  EXPECT_EQ(back.u_turns, 1);
  EXPECT_EQ(back.turns, 0);
  EXPECT_EQ(back.repeats, 1);
  // From up to left and from left to down, codes 2, 1 and 1, 4: turns by a right angle both.
  const GridCounts around = walked("RULD");
  EXPECT_EQ(around.turns, 3);
  EXPECT_EQ(around.u_turns, 0);
  EXPECT_EQ(around.repeats, 1);
}

TEST(CountPath, MeasuresSlopes) {
  GridMap map = free_grid_map(3, 1);
  map.cell_m = 4.0;
  map.height_m = {0.0, 3.0, 0.0};
  const GridCounts counts = count_path(grid_graph(map, "test"), {0, 1, 2});
  // A 3-4-5 triangle up and down: cos^2 = 16/25, |dh| sin = 3 * 3/5.
  EXPECT_NEAR(counts.level_m, 2.0 * 4.0 * 16.0 / 25.0, kCostRounding);
  EXPECT_NEAR(counts.climb_m, 2.0 * 3.0 * 3.0 / 5.0, kCostRounding);
}

TEST(GridCostOf, IsThatOfThePapers) {
  GridCounts counts;
  counts.steps = 265;
  counts.turns = 22;
  counts.level_m = 265.0;
  GridCost cost;
  EXPECT_EQ(cost_of(cost, counts, 1.0), 265.0);
  cost.objective = GridObjective::kWeighted;
  // Wu et al., Figure 15: field A ends at 0.22727.
  EXPECT_NEAR(fitness_of(cost_of(cost, counts, 1.0)), 0.22727, 5e-6);
  cost.objective = GridObjective::kTractor;
  // Wang et al., Eqs (12) and (17) to (19) on flat ground, by hand.
  const double rolling = 0.25 * 0.5 * 9.8 * 265.0;
  const double turn = 46.2 * (50.0 / 3600.0) * std::numbers::pi / (2.0 * 0.8);
  EXPECT_NEAR(cost_of(cost, counts, 1.0), 0.5 * rolling + 0.25 * turn * 22.0, kCostRounding);
  EXPECT_NEAR(turn, 1.26, 0.005);
  EXPECT_EQ(fitness_of(0.0), 1.0 / kLeastCost);
}

TEST(GridCostOf, RefusesWeightsThatWeighNothing) {
  const auto said = [](const GridCost& cost) {
    return headland::refusal([&] { check_grid_cost(cost, "spec.yaml", "cost"); });
  };
  GridCost cost;
  EXPECT_EQ(said(cost), "accepted");
  cost.weights.turn = -0.1;
  EXPECT_EQ(said(cost), "spec.yaml: cost.turn: '-0.1': a weight, a finite number from 0 up");
  cost.weights = {0.0, 0.0, 0.0};
  EXPECT_EQ(said(cost),
            "spec.yaml: cost.repeat: '0': more than 0, or turn or u_turn is: "
            "all are zero");
  cost = {};
  cost.tractor.turn_weight = std::nan("");
  EXPECT_EQ(said(cost),
            "spec.yaml: cost.tractor.turn_weight: 'nan': a weight, a finite number from 0 up");
  cost = {};
  cost.tractor.turn_speed_m_s = 0.0;
  EXPECT_EQ(said(cost), "spec.yaml: cost.tractor.turn_speed_m_s: '0': a positive number");
}

}  // namespace
}  // namespace headland
