#include "evaluate/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>
#include <string>

#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_file.h"
#include "evaluate/comparison_ranks.h"
#include "terrains/grid_map_generator.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ComparedMap small_map(const std::string& name, std::uint64_t seed) {
  ComparedMap map;
  map.name = name;
  map.map = made_up_grid_map({8, 7, 0.12, 2, seed}, "test");
  return map;
}

ComparedPlanner planner_named(const std::string& name, const std::string& label) {
  ComparedPlanner planner;
  planner.label = label;
  planner.name = name;
  planner.parameters =
      resolve_parameters(find_grid_planner(name, "test").parameters, {}, "test", "");
  planner.stop.iterations = 20;
  return planner;
}

Comparison small_comparison() {
  Comparison comparison;
  comparison.file = "test";
  comparison.name = "test";
  comparison.maps = {small_map("one", 1), small_map("two", 2)};
  comparison.planners = {planner_named("grid_tplp", "TPLP"), planner_named("grid_ga", "GA"),
                         planner_named("grid_boustrophedon", "rows")};
  comparison.repeats = 3;
  return comparison;
}

std::string without_seconds(nlohmann::ordered_json json) {
  for (const char* key : {"seconds", "convergence_seconds"}) {
    for (auto& run : json["runs"]) run["figures"].erase(key);
    for (auto& result : json["results"]) result["figures"].erase(key);
  }
  return json.dump();
}

std::string results_with_jobs(const Comparison& comparison, int jobs) {
  const auto runs = run_comparison(comparison, {jobs, {}, {}});
  return without_seconds(comparison_json(comparison, runs, rank_planners(comparison, runs), "0"));
}

TEST(Comparison, IsTheSameWithAnyNumberOfJobs) {
  const Comparison comparison = small_comparison();
  const std::string one = results_with_jobs(comparison, 1);
  EXPECT_EQ(results_with_jobs(comparison, 2), one);
  EXPECT_EQ(results_with_jobs(comparison, 5), one);
}

TEST(Comparison, SeedsDependOnNothingButTheRunsOwnNames) {
  std::set<std::uint64_t> seeds;
  for (const char* map : {"a", "b", "ab"}) {
    for (const char* label : {"b", "ab", "a"}) {
      for (int repeat = 0; repeat < 50; ++repeat) seeds.insert(seed_of_run(1, map, label, repeat));
    }
  }
  EXPECT_EQ(seeds.size(), 3U * 3U * 50U);
  Comparison more = small_comparison();
  const auto before = run_comparison(more, {1, {}, {}});
  more.maps.insert(more.maps.begin(), small_map("zero", 9));
  more.planners.insert(more.planners.begin(), planner_named("grid_dtsa", "DTSA"));
  more.repeats = 4;
  const auto after = run_comparison(more, {1, {}, {}});
  EXPECT_EQ(runs_of(after, 1, 1)[2]->seed, runs_of(before, 0, 0)[2]->seed);
  EXPECT_EQ(runs_of(after, 1, 1)[2]->plan.cells, runs_of(before, 0, 0)[2]->plan.cells);
}

TEST(Comparison, FiguresAreThoseOfThePlan) {
  const Comparison comparison = small_comparison();
  for (const ComparedRun& run : run_comparison(comparison, {2, {}, {}})) {
    ASSERT_EQ(run.state, RunState::kPlanned);
    const std::set<GridCell> distinct(run.plan.cells.begin(), run.plan.cells.end());
    const int cells = free_cell_count(comparison.maps[static_cast<std::size_t>(run.map)].map);
    const auto value = [&](std::string_view key) {
      return find_figure(key, "test", "").value(run);
    };
    EXPECT_EQ(value("coverage_rate"), static_cast<double>(distinct.size()) / cells);
    EXPECT_EQ(value("repeat_rate"),
              static_cast<double>(run.plan.cells.size() - distinct.size()) / cells);
    EXPECT_EQ(value("length_steps"), static_cast<double>(run.plan.cells.size() - 1));
  }
}

TEST(Comparison, ACoverageThatLeavesACellOutShows) {
  ComparedRun run;
  run.free_cells = 10;
  run.plan.counts.distinct_cells = 9;
  EXPECT_EQ(find_figure("coverage_rate", "test", "").value(run), 0.9);
}

TEST(Comparison, SpreadsAreThoseOfTheSample) {
  std::vector<ComparedRun> runs(4);
  const double costs[] = {2.0, 4.0, 4.0, 6.0};
  for (std::size_t i = 0; i < 4; ++i) {
    runs[i].state = RunState::kPlanned;
    runs[i].plan.cost = costs[i];
    runs[i].plan.fitness = 1.0 / costs[i];
  }
  runs.emplace_back().state = RunState::kRefused;
  runs.emplace_back();
  const auto own = runs_of(runs, 0, 0);
  const auto cost = spread_of(find_figure("cost", "test", ""), own);
  ASSERT_TRUE(cost);
  EXPECT_EQ(cost->mean, 4.0);
  EXPECT_DOUBLE_EQ(cost->deviation, std::sqrt(8.0 / 3.0));
  EXPECT_EQ(cost->best, 2.0);
  EXPECT_EQ(cost->worst, 6.0);
  EXPECT_EQ(spread_of(find_figure("fitness", "test", ""), own)->best, 0.5);
  const RunCounts counts = run_counts(own);
  EXPECT_EQ(counts.asked, 6);
  EXPECT_EQ(counts.planned, 4);
  EXPECT_EQ(counts.refused, 1);
  EXPECT_EQ(counts.not_run, 1);
}

TEST(Comparison, WhatAPlannerRefusesIsCountedAndTheOthersGoOn) {
  Comparison comparison = small_comparison();
  comparison.maps[1].map = free_grid_map(200, 150);  // more cells than a table may have
  comparison.planners.erase(comparison.planners.begin() + 1);
  const auto runs = run_comparison(comparison, {2, {}, {}});
  for (const ComparedRun* run : runs_of(runs, 1, 0)) {
    EXPECT_EQ(run->state, RunState::kRefused);
    EXPECT_THAT(run->refusal, HasSubstr("20000"));
  }
  EXPECT_EQ(run_counts(runs_of(runs, 1, 1)).planned, 3);
  EXPECT_EQ(run_counts(runs_of(runs, 0, 0)).planned, 3);
  const ComparisonRanks ranks = rank_planners(comparison, runs);
  EXPECT_EQ(ranks.failures, 3);
  EXPECT_EQ(ranks.blocks[1][0], std::numeric_limits<double>::infinity());
  EXPECT_THAT(comparison_runs_csv(comparison, runs), HasSubstr(",refused,,"));
  const auto json = comparison_json(comparison, runs, ranks, "0");
  EXPECT_EQ(json["results"][2]["runs"]["refused"], 3);
  EXPECT_FALSE(json["results"][2].contains("figures"));
}

TEST(Comparison, AnEarlyEndKeepsWhatIsDoneAndLeavesBlocksOut) {
  Comparison comparison = small_comparison();
  std::atomic<int> finished = 0;
  const ParallelOptions options{1, [&](int done, int) { finished = done; },
                                [&] { return finished >= 8; }};
  const auto runs = run_comparison(comparison, options);
  int planned = 0;
  for (const ComparedRun& run : runs) planned += run.state == RunState::kPlanned ? 1 : 0;
  EXPECT_EQ(planned, 8);
  // Repeat by repeat: every planner has its first on every map.
  for (int m = 0; m < 2; ++m) {
    for (int p = 0; p < 3; ++p) EXPECT_GE(run_counts(runs_of(runs, m, p)).planned, 1);
  }
  EXPECT_EQ(rank_planners(comparison, runs).blocks_left_out, 2);
  comparison.tests.blocks = BlockKind::kRuns;
  EXPECT_EQ(rank_planners(comparison, runs).blocks.size(), 2U);
}

// Runs with costs that are made up, planned on `maps` maps.
std::vector<ComparedRun> made_up_runs(Comparison& comparison, int maps, int repeats,
                                      double (*cost)(int map, int planner, int repeat)) {
  comparison.maps.assign(static_cast<std::size_t>(maps), small_map("map", 1));
  comparison.repeats = repeats;
  std::vector<ComparedRun> runs;
  for (int m = 0; m < maps; ++m) {
    for (int p = 0; p < static_cast<int>(comparison.planners.size()); ++p) {
      for (int r = 0; r < repeats; ++r) {
        ComparedRun& run = runs.emplace_back();
        run.map = m;
        run.planner = p;
        run.repeat = r;
        run.state = RunState::kPlanned;
        run.plan.cost = cost(m, p, r);
      }
    }
  }
  return runs;
}

TEST(ComparisonRanks, EqualPlannersAreNotToldApart) {
  Comparison comparison = small_comparison();
  // The same sum in another order: 0.1 + 0.2 + 0.3 and 0.3 + 0.2 + 0.1 differ in their last bit.
  const auto runs = made_up_runs(comparison, 10, 2, [](int m, int p, int) {
    return p == 0 ? m + (0.1 + 0.2 + 0.3) : m + (0.3 + 0.2 + 0.1);
  });
  const ComparisonRanks ranks = rank_planners(comparison, runs);
  EXPECT_THAT(ranks.average_ranks, ElementsAre(2.0, 2.0, 2.0));
  EXPECT_EQ(ranks.friedman->f_p, 1.0);
  for (const PlannerPair& pair : ranks.pairs) EXPECT_EQ(pair.holm_p, 1.0);
}

TEST(ComparisonRanks, AClearlyWorsePlannerIsFoundAgainstTheControl) {
  Comparison comparison = small_comparison();
  comparison.tests.control = "rows";
  const auto runs = made_up_runs(comparison, 10, 2, [](int m, int p, int r) {
    return m + (p == 1 ? 5.0 : (m * 7 + p * 3 + r) % 5 * 0.1);
  });
  const ComparisonRanks ranks = rank_planners(comparison, runs);
  EXPECT_LT(ranks.friedman->f_p, 0.01);
  ASSERT_EQ(ranks.pairs.size(), 2U);
  EXPECT_EQ(ranks.pairs[1].second, 1);
  EXPECT_LT(ranks.pairs[1].holm_p, 0.05);
  EXPECT_EQ(ranks.pairs[1].test.wins, 10);
  EXPECT_GT(ranks.average_ranks[1] - ranks.average_ranks[2], ranks.distance);
  EXPECT_GT(ranks.distance, 0.0);
  EXPECT_THAT(ranks.notes, IsEmpty());
}

TEST(ComparisonRanks, TooFewBlocksAreSaidInsteadOfP) {
  Comparison comparison = small_comparison();
  const auto cost = [](int m, int p, int r) { return 10.0 * p + m + 0.1 * r; };
  const auto few = made_up_runs(comparison, 4, 5, cost);
  const ComparisonRanks by_map = rank_planners(comparison, few);
  EXPECT_FALSE(by_map.friedman);
  EXPECT_TRUE(by_map.pairs_too_few);
  ASSERT_EQ(by_map.notes.size(), 2U);
  EXPECT_THAT(by_map.notes[0], HasSubstr("4 maps are too few for a p value, at least 5"));
  EXPECT_THAT(by_map.notes[0], HasSubstr("tests.blocks: runs"));
  // Three pairs: 3 * 2 / 2^n < 0.05 from n = 7 on.
  EXPECT_THAT(by_map.notes[1], HasSubstr("at least 7 are needed"));
  const auto json = comparison_json(comparison, few, by_map, "0");
  EXPECT_FALSE(json["ranks"].contains("friedman"));
  EXPECT_TRUE(json["ranks"]["wilcoxon"][0]["p"].is_null());
  comparison.tests.blocks = BlockKind::kRuns;
  const ComparisonRanks by_run = rank_planners(comparison, few);
  EXPECT_EQ(by_run.blocks.size(), 20U);
  EXPECT_TRUE(by_run.friedman);
  EXPECT_THAT(by_run.notes, IsEmpty());
  // At the very number that the note names they suffice.
  comparison.tests.blocks = BlockKind::kMaps;
  const auto enough = made_up_runs(comparison, 7, 1, cost);
  const ComparisonRanks seven = rank_planners(comparison, enough);
  EXPECT_FALSE(seven.pairs_too_few);
  EXPECT_LT(seven.pairs[0].holm_p, 0.05);
}

TEST(ComparisonRanks, TellWhoOverranTheBudget) {
  Comparison comparison = small_comparison();
  comparison.budget = Budget::kEvaluations;
  for (ComparedPlanner& planner : comparison.planners) planner.stop.evaluations = 1000;
  auto runs = made_up_runs(comparison, 7, 1, [](int m, int p, int) { return p * 1.0 + m; });
  for (ComparedRun& run : runs) run.plan.evaluations = 1040;
  EXPECT_THAT(rank_planners(comparison, runs).notes, IsEmpty());
  runs.front().plan.evaluations = 2500;
  const auto notes = rank_planners(comparison, runs).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("overran the budget on map: up to 2500 evaluations of 1000"));
}

TEST(ComparisonRanks, PlansWithJumpsRankLastHoweverCheap) {
  Comparison comparison = small_comparison();
  auto runs = made_up_runs(comparison, 6, 2, [](int m, int p, int) { return p * 1.0 + m; });
  for (ComparedRun& run : runs) run.plan.jumps = run.planner == 0 && run.repeat == 1 ? 1 : 0;
  const ComparisonRanks ranks = rank_planners(comparison, runs);
  EXPECT_THAT(ranks.average_ranks, ElementsAre(3.0, 1.0, 2.0));
  EXPECT_EQ(ranks.failures, 6);
}

TEST(ComparisonRanks, MoreIsBetterOfFitness) {
  Comparison comparison = small_comparison();
  comparison.tests.figure = "fitness";
  auto runs = made_up_runs(comparison, 6, 1, [](int, int p, int) { return p + 1.0; });
  for (ComparedRun& run : runs) run.plan.fitness = 1.0 / run.plan.cost;
  EXPECT_THAT(rank_planners(comparison, runs).average_ranks, ElementsAre(1.0, 2.0, 3.0));
}

TEST(Comparison, TheBestPlanIsTheCheapestThatCanBeDriven) {
  Comparison comparison = small_comparison();
  auto runs = made_up_runs(comparison, 1, 3, [](int, int, int r) { return 3.0 - r; });
  runs[2].plan.jumps = 4;
  EXPECT_EQ(best_run(runs_of(runs, 0, 0))->repeat, 1);
  EXPECT_EQ(best_run({}), nullptr);
}

TEST(Comparison, CsvQuotesWhatNamesHold) {
  Comparison comparison = small_comparison();
  comparison.planners[0].label = "TPLP, \"fixed\"";
  const auto runs = made_up_runs(comparison, 1, 1, [](int, int, int) { return 1.0; });
  EXPECT_THAT(comparison_runs_csv(comparison, runs), HasSubstr("\nmap,\"TPLP, \"\"fixed\"\"\",0,"));
}

}  // namespace
}  // namespace headland
