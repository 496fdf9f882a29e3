// What grid planners refuse, and when they end.
#include "planner/grid_planners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>

#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

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

TEST(GridGenetic, RefusesMoreElitesThanChromosomes) {
  GridPlanRequest request = grid_request(drawn_map("..."), "grid_iga");
  request.parameters["population"] = 5.0;
  request.parameters["elites"] = 6.0;
  EXPECT_EQ(headland::refusal([&] { plan_named("grid_iga", request); }),
            "grid plan: elites: '6': at most 5, the population");
}

}  // namespace
}  // namespace headland
