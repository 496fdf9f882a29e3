// What every grid planner of the table must do on every map, and what some are known to reach.
#include "planner/grid_planners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "planner/grid_prices.h"
#include "terrains/grid_map_file.h"
#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

std::vector<GridMap> conformance_maps() {
  std::vector<GridMap> maps = {drawn_map("."), drawn_map(".."), drawn_map(".....\n"),
                               drawn_map(".#.\n.#.\n...\n"), drawn_map("...\n.#.\n...\n")};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    maps.push_back(made_up_grid_map({11, 9, 0.15, 4, seed}, "test"));
  }
  return maps;
}

// What the cells of a plan come to, counted apart from the planner: turns by the cross product of
// two steps, U-turns by their dot product. Moves that are no steps turn nothing and climb nothing.
struct Recount {
  int steps = 0;
  int repeats = 0;
  int turns = 0;
  int u_turns = 0;
  int row_changes = 0;   // two turns in a row to the same side
  double level_m = 0.0;  // Wang et al. 2025, Eqs (13) to (17)
  double climb_m = 0.0;
};

Recount recounted(const GridMap& map, const std::vector<GridCell>& cells) {
  Recount counted;
  counted.steps = static_cast<int>(cells.size()) - 1;
  counted.repeats =
      static_cast<int>(cells.size() - std::set<GridCell>(cells.begin(), cells.end()).size());
  GridCell before{0, 0};  // the last step; none
  int cross_before = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    GridCell step{cells[i].column - cells[i - 1].column, cells[i].row - cells[i - 1].row};
    const bool is_step = std::abs(step.column) + std::abs(step.row) == 1;
    if (!is_step) step = {0, 0};
    const int cross = before.column * step.row - before.row * step.column;
    const int dot = before.column * step.column + before.row * step.row;
    counted.turns += std::abs(cross);
    counted.u_turns += dot == -1 ? 1 : 0;
    counted.row_changes += cross != 0 && cross == cross_before ? 1 : 0;
    before = step;
    cross_before = cross;
    const auto height_m = [&](GridCell cell) {
      return map.height_m.empty() ? 0.0 : map.height_m[index_of(map, cell)];
    };
    if (!is_step) continue;
    const double rise_m = std::abs(height_m(cells[i]) - height_m(cells[i - 1]));
    const double slope_rad = std::atan2(rise_m, map.cell_m);
    counted.level_m += map.cell_m * std::pow(std::cos(slope_rad), 2);
    counted.climb_m += rise_m * std::sin(slope_rad);
  }
  return counted;
}

double recounted_cost(const GridPlanRequest& request, const Recount& counted,
                      const std::vector<GridCell>& cells) {
  switch (request.cost.objective) {
    case GridObjective::kLength:
      return counted.steps;
    case GridObjective::kWeighted:
      return 0.3 * counted.repeats + 0.2 * counted.turns + 0.5 * counted.u_turns;
    case GridObjective::kTractor: {
      // Wang et al. 2025, 5.4.3: 0.5 kg, friction 0.25; 46.2 V and 50 A for a quarter circle at
      // 0.8 m/s in W h; shares of 0.5, 0.25 and 0.25.
      const double weight_n = 0.5 * 9.8;
      const double turn_s = M_PI * request.map.cell_m / (2.0 * 0.8);
      return 0.5 * 0.25 * weight_n * counted.level_m + 0.25 * weight_n * counted.climb_m +
             0.25 * 46.2 * 50.0 / 3600.0 * turn_s * (counted.turns + 2 * counted.u_turns);
    }
    case GridObjective::kMeasured:
      break;
  }
  const GridPrices prices = grid_prices(*request.cost.measured, request.map.cell_m);
  const GridGraph graph = grid_graph(request.map, "test");
  const auto step_wh = step_prices(*request.cost.measured, graph);
  double sum_wh = prices.cell * free_cell_count(request.map) + prices.corner * counted.turns +
                  prices.u_turn * counted.u_turns +
                  2.0 * std::min(prices.turn - prices.corner, 0.0) * counted.row_changes;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const GridCell step{cells[i].column - cells[i - 1].column, cells[i].row - cells[i - 1].row};
    const auto direction = std::ranges::find(kStep, step);
    if (direction == kStep.end()) continue;
    const int node = graph.node_of[index_of(request.map, cells[i - 1])];
    sum_wh += step_wh[static_cast<std::size_t>(node)]
                     [static_cast<std::size_t>(direction - kStep.begin())];
  }
  return sum_wh;
}

// Planner, objective.
using GridCase = std::tuple<std::size_t, GridObjective>;

class EveryGridPlanner : public testing::TestWithParam<GridCase> {
 protected:
  const GridPlannerEntry& planner_ = grid_planners()[std::get<0>(GetParam())];
  // The one that drives chromosomes as they are: its moves are not all steps.
  const bool jumps_ = planner_.name == "grid_ga";

  // Every map, with both ends free, both given, and closed, from a cell given and from any.
  std::vector<GridPlanRequest> requests() const {
    std::vector<GridPlanRequest> requests;
    for (const GridMap& map : conformance_maps()) {
      GridPlanRequest request = grid_request(map, planner_);
      request.stop.iterations = 2;
      request.stop.evaluations = 10000;
      request.cost.objective = std::get<1>(GetParam());
      if (request.cost.objective == GridObjective::kMeasured) {
        request.cost.measured = made_up_cost();
      }
      if (request.cost.objective == GridObjective::kMeasured ||
          request.cost.objective == GridObjective::kTractor) {
        for (std::size_t i = 0; i < map.blocked.size(); ++i) {
          request.map.height_m.push_back(0.2 * std::sin(static_cast<double>(i)));
        }
      }
      requests.push_back(request);
      request.start = GridCell{0, map.rows - 1};
      request.end = GridCell{map.columns - 1, 0};
      requests.push_back(request);
      request.end = request.start;
      requests.push_back(request);
      request.start = request.end = std::nullopt;
      request.closed = true;
      requests.push_back(request);
    }
    // One end alone.
    GridPlanRequest request = requests.back();
    request.closed = false;
    request.end = GridCell{request.map.columns - 1, 0};
    requests.push_back(request);
    return requests;
  }
};

TEST_P(EveryGridPlanner, VisitsEveryFreeCellByStepsAndKeepsItsEnds) {
  for (const GridPlanRequest& request : requests()) {
    SCOPED_TRACE(grid_map_text(request.map));
    const GridPlan plan = planner_.plan(request);
    EXPECT_EQ(plan.planner, planner_.name);
    ASSERT_FALSE(plan.cells.empty());
    for (const GridCell cell : plan.cells) EXPECT_TRUE(is_free(request.map, cell));
    const std::set<GridCell> distinct(plan.cells.begin(), plan.cells.end());
    EXPECT_EQ(static_cast<int>(distinct.size()), free_cell_count(request.map));
    int jumps = 0;
    for (std::size_t i = 1; i < plan.cells.size(); ++i) {
      const int away = std::abs(plan.cells[i].column - plan.cells[i - 1].column) +
                       std::abs(plan.cells[i].row - plan.cells[i - 1].row);
      jumps += away == 1 ? 0 : 1;
    }
    EXPECT_EQ(plan.jumps, jumps);
    if (!jumps_) {
      EXPECT_EQ(jumps, 0);
    }
    if (request.start) {
      EXPECT_EQ(plan.cells.front(), *request.start);
    }
    if (request.end) {
      EXPECT_EQ(plan.cells.back(), *request.end);
    }
    if (request.closed) {
      EXPECT_EQ(plan.cells.back(), plan.cells.front());
    }
  }
}

TEST_P(EveryGridPlanner, CostsWhatItSays) {
  for (const GridPlanRequest& request : requests()) {
    SCOPED_TRACE(grid_map_text(request.map));
    const GridPlan plan = planner_.plan(request);
    const Recount counted = recounted(request.map, plan.cells);
    EXPECT_EQ(plan.counts.steps, counted.steps);
    EXPECT_EQ(plan.counts.repeats, counted.repeats);
    EXPECT_EQ(plan.counts.turns, counted.turns);
    EXPECT_EQ(plan.counts.u_turns, counted.u_turns);
    EXPECT_NEAR(plan.cost, recounted_cost(request, counted, plan.cells),
                kSumRounding * (1.0 + plan.cost));
    ASSERT_FALSE(plan.convergence.empty());
    for (std::size_t i = 1; i < plan.convergence.size(); ++i) {
      EXPECT_LT(plan.convergence[i].cost, plan.convergence[i - 1].cost);
      EXPECT_GT(plan.convergence[i].iteration, plan.convergence[i - 1].iteration);
    }
    if (!jumps_) {
      EXPECT_NEAR(plan.convergence.back().cost, plan.cost, kSumRounding);
    }
    EXPECT_LE(plan.iterations, request.stop.iterations);
  }
}

TEST_P(EveryGridPlanner, FollowsFromTheSeed) {
  for (GridPlanRequest request : requests()) {
    request.seed = 9;
    const GridPlan one = planner_.plan(request);
    const GridPlan other = planner_.plan(request);
    EXPECT_EQ(one.cells, other.cells);
    EXPECT_EQ(one.evaluations, other.evaluations);
  }
}

// Every word that a parameter may have, one at a time: each is another way of searching.
TEST(GridPlannerOptions, PlanWholeMaps) {
  for (const GridPlannerEntry& planner : grid_planners()) {
    for (const ParameterSpec& spec : planner.parameters) {
      for (const std::string_view option : spec.choices) {
        SCOPED_TRACE(std::string(planner.name) + " " + std::string(spec.name) + " " +
                     std::string(option));
        GridPlanRequest request =
            grid_request(made_up_grid_map({7, 6, 0.15, 2, 3}, "test"), planner);
        request.cost.objective = GridObjective::kWeighted;
        request.stop.iterations = 5;
        request.parameters[std::string(spec.name)] = std::string(option);
        const GridPlan plan = planner.plan(request);
        const Recount counted = recounted(request.map, plan.cells);
        EXPECT_EQ(std::set<GridCell>(plan.cells.begin(), plan.cells.end()).size(),
                  static_cast<std::size_t>(free_cell_count(request.map)));
        EXPECT_EQ(plan.jumps, 0);
        EXPECT_NEAR(plan.cost, recounted_cost(request, counted, plan.cells), kSumRounding);
        EXPECT_NEAR(plan.convergence.back().cost, plan.cost, kSumRounding);
        EXPECT_EQ(planner.plan(request).cells, plan.cells);
      }
    }
  }
}

// Every planner takes measured costs, and by them its plan takes no more than the one by length.
// Searches draw at random: on few cells they are given what it takes to come near their best.
// Rows up and down are the same by any costs.
TEST_P(EveryGridPlanner, TakesNoMoreByMeasuredCostsThanByLength) {
  if (std::get<1>(GetParam()) != GridObjective::kMeasured || jumps_) return;
  GridPlanRequest request =
      grid_request(parse_grid_map(".....\n.....\n..#..\n.....\n", 2.0, "test"), planner_);
  for (int i = 0; i < 20; ++i) request.map.height_m.push_back(0.2 * std::sin(i));
  request.stop.iterations = 60;
  const GridPlan shortest = planner_.plan(request);
  request.cost.objective = GridObjective::kMeasured;
  request.cost.measured = made_up_cost();
  const GridPlan measured = planner_.plan(request);
  EXPECT_LE(measured.cost,
            recounted_cost(request, recounted(request.map, shortest.cells), shortest.cells) + 1e-9);
}

std::string grid_case_name(const testing::TestParamInfo<GridCase>& info) {
  const auto& [planner, objective] = info.param;
  const std::string name(grid_planners()[planner].name);
  switch (objective) {
    case GridObjective::kLength:
      return name + "_length";
    case GridObjective::kWeighted:
      return name + "_weighted";
    case GridObjective::kTractor:
      return name + "_tractor";
    case GridObjective::kMeasured:
      break;
  }
  return name + "_measured";
}

INSTANTIATE_TEST_SUITE_P(
    Grids, EveryGridPlanner,
    testing::Combine(testing::Range(std::size_t{0}, grid_planners().size()),
                     testing::Values(GridObjective::kLength, GridObjective::kWeighted,
                                     GridObjective::kTractor, GridObjective::kMeasured)),
    grid_case_name);

}  // namespace
}  // namespace headland
