// What every grid planner of the table must do on every map, and what some are known to reach.
#include "planner/grid_planners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "planner/grid_bound.h"
#include "planner/grid_prices.h"
#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"
#include "tests/planner/made_up_cost.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kSumRounding = 1e-7;  // of sums of a few hundred shares and their changes

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

class GridRefusals : public testing::TestWithParam<std::size_t> {
 protected:
  const GridPlannerEntry& planner_ = grid_planners()[GetParam()];
  std::string said(const GridPlanRequest& request) const {
    return headland::refusal([&] { planner_.plan(request); });
  }
};

TEST_P(GridRefusals, WhatCannotBePlanned) {
  EXPECT_THAT(said(grid_request(drawn_map(".#.\n.#.\n"), planner_)),
              HasSubstr("grid plan: map: '2 of 4 free cells': cannot be reached from the rest"));
  GridPlanRequest request = grid_request(drawn_map("..\n.#\n"), planner_);
  request.start = GridCell{1, 0};
  EXPECT_EQ(said(request), "grid plan: start: '1, 0': a free cell; this one is blocked");
  request.start = GridCell{2, 0};
  EXPECT_EQ(said(request),
            "grid plan: start: '2, 0': a cell of the map: column 0 to 1, row 0 to 1");
  request.start = GridCell{0, 0};
  request.end = GridCell{0, 1};
  request.closed = true;
  EXPECT_EQ(said(request), "grid plan: end: '0, 1': the start, 0, 0, or none: the tour is closed");
  request.start = request.end = std::nullopt;
  request.closed = false;
  request.stop.iterations = 0;
  EXPECT_EQ(said(request), "grid plan: stop.iterations: '0': a whole number from 1 up");
  request.stop = {};
  request.cost.weights.repeat = -1.0;
  EXPECT_THAT(said(request), HasSubstr("cost.repeat: '-1'"));
  request.cost = {};
  request.map.height_m = {1.0};
  EXPECT_THAT(said(request), HasSubstr("heights: '1': 4 values"));
  request.map = free_grid_map(0, 0);
  EXPECT_THAT(said(request), HasSubstr("1 to 1000 columns and rows"));
}

TEST_P(GridRefusals, UselessParameters) {
  GridPlanRequest request = grid_request(drawn_map("...\n...\n"), planner_);
  request.cost.weights = {0.0, 0.0, 0.0};
  EXPECT_THAT(said(request), HasSubstr("all are zero"));
  for (const ParameterSpec& spec : planner_.parameters) {
    if (spec.name != "population") continue;
    EXPECT_THAT(
        headland::refusal([&] {
          resolve_parameters(planner_.parameters, {{"population", 1.0}}, "spec.yaml", "planner");
        }),
        HasSubstr("spec.yaml: planner.population: '1'"));
  }
}

TEST_P(GridRefusals, AsksOftenWhetherToEnd) {
  constexpr double kLongest_s = 0.4;  // 0.2 wanted; machines that test are slow
  GridPlanRequest request = grid_request(free_grid_map(60, 60), planner_);
  // Processor time: what else the machine does makes no planner slow to ask.
  const auto now_s = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double begun_s = now_s();
  double before_s = begun_s;
  double longest_s = 0.0;
  request.cancelled = [&] {
    const double asked_s = now_s();
    longest_s = std::max(longest_s, asked_s - before_s);
    before_s = asked_s;
    return asked_s - begun_s > 0.1;
  };
  try {
    planner_.plan(request);
  } catch (const Cancelled&) {
  }
  EXPECT_LT(longest_s, kLongest_s);
}

TEST_P(GridRefusals, EndsWhenAsked) {
  GridPlanRequest request = grid_request(example_map("field_B"), planner_);
  int asked = 0;
  request.cancelled = [&] { return ++asked > 3; };
  EXPECT_THROW(planner_.plan(request), Cancelled);
  EXPECT_EQ(asked, 4);
}

TEST_P(GridRefusals, ParametersOutOfRange) {
  for (const ParameterSpec& spec : planner_.parameters) {
    const std::string name(spec.name);
    EXPECT_THAT(
        headland::refusal([&] {
          resolve_parameters(planner_.parameters, {{name, spec.max + 1.0}}, "spec.yaml", "planner");
        }),
        HasSubstr("planner." + name));
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, GridRefusals,
                         testing::Range(std::size_t{0}, grid_planners().size()),
                         [](const testing::TestParamInfo<std::size_t>& planner) {
                           return std::string(grid_planners()[planner.param].name);
                         });

class GridStops : public testing::TestWithParam<std::size_t> {
 protected:
  const GridPlannerEntry& planner_ = grid_planners()[GetParam()];
  GridPlanRequest request_ = grid_request(example_map("field_D"), planner_);

  GridPlan stopped_at(SearchStop stop) {
    request_.stop = stop;
    return planner_.plan(request_);
  }
  // Those that build but one plan stop at no limit.
  bool builds_one_ = planner_.name == "grid_boustrophedon";

  void SetUp() override {
    request_.cost.objective = GridObjective::kWeighted;
    for (const char* const size : {"population", "ants"}) {
      if (request_.parameters.contains(size)) request_.parameters[size] = 10.0;
    }
  }
};

TEST_P(GridStops, AtTheFirstLimit) {
  GridPlan plan = stopped_at({.iterations = 2, .evaluations = 0, .seconds = 0.0, .stagnation = 0});
  if (builds_one_) {
    EXPECT_EQ(plan.stopped_by, StopReason::kNothingBetter);
    EXPECT_EQ(plan.evaluations, 1);
    return;
  }
  EXPECT_EQ(plan.stopped_by, StopReason::kIterations);
  EXPECT_EQ(plan.iterations, 2);
  for (const std::int64_t most : {500, 5000}) {
    plan = stopped_at({.iterations = 100000, .evaluations = most, .seconds = 0.0, .stagnation = 0});
    EXPECT_EQ(plan.stopped_by, StopReason::kEvaluations);
    // At most one individual's places, each by two operators, are looked at beyond the limit.
    EXPECT_LE(plan.evaluations, most + 2 * free_cell_count(request_.map));
    EXPECT_GE(plan.evaluations, most);
  }
  plan = stopped_at({.iterations = 100000, .evaluations = 0, .seconds = 0.0, .stagnation = 1});
  EXPECT_EQ(plan.stopped_by, StopReason::kStagnation);
  EXPECT_EQ(plan.iterations, plan.convergence.back().iteration + 1);
  plan = stopped_at({.iterations = 1000000, .evaluations = 0, .seconds = 0.02, .stagnation = 0});
  EXPECT_EQ(plan.stopped_by, StopReason::kTime);
}

INSTANTIATE_TEST_SUITE_P(Grids, GridStops, testing::Range(std::size_t{0}, grid_planners().size()),
                         [](const testing::TestParamInfo<std::size_t>& planner) {
                           return std::string(grid_planners()[planner.param].name);
                         });

TEST(GridLocalSearch, KeepsToItsLimitOfEvaluations) {
  GridPlanRequest request = grid_request(example_map("field_B"), "grid_local_search");
  request.stop = {.iterations = 100000, .evaluations = 3000, .seconds = 0.0, .stagnation = 0};
  // The last kick is looked at whatever the limit says.
  EXPECT_LE(plan_named("grid_local_search", request).evaluations, 3001);
}

TEST(PlanSearch, TheShareThatIsOverIsThatOfTheNearestLimit) {
  PlanSearch search;
  search.stop = {.iterations = 100, .evaluations = 1000, .seconds = 0.0, .stagnation = 5};
  EXPECT_EQ(share_over(search), 0.0);
  search.iteration = 11;
  search.evaluations = 50;
  EXPECT_EQ(share_over(search), 0.1);
  search.evaluations = 600;
  EXPECT_EQ(share_over(search), 0.6);
  search.evaluations = 2000;
  EXPECT_EQ(share_over(search), 1.0);
  search.stop.evaluations = 0;
  search.stop.seconds = 1e-9;
  EXPECT_EQ(share_over(search), 1.0);
}

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

TEST(GridGenetic, RefusesMoreElitesThanChromosomes) {
  GridPlanRequest request = grid_request(drawn_map("..."), "grid_iga");
  request.parameters["population"] = 5.0;
  request.parameters["elites"] = 6.0;
  EXPECT_EQ(headland::refusal([&] { plan_named("grid_iga", request); }),
            "grid plan: elites: '6': at most 5, the population");
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
