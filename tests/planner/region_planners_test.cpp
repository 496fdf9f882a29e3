// What every planner of regions must do in every scene, and what some are known to reach.
#include "planner/region_planners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "planner/algorithms/region_exact.h"
#include "planner/algorithms/region_iga.h"
#include "planner/algorithms/region_local_search.h"
#include "planner/region_energy.h"
#include "planner/region_generator.h"
#include "planner/worked_parts.h"
#include "tests/planner/made_up_cost.h"
#include "tests/planner/waves.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kLengthRounding_m = 1e-6;  // of sums of lengths of some 10 km in another order

RegionProblem made_up_problem(int parts, std::uint64_t seed, PartSweeps sweeps = PartSweeps::kOwn) {
  constexpr double kWidth_m = 40.0;
  const Field field = made_up_region({parts, -1, 3e5, seed}, "test");
  return region_problem(worked_parts(region_parts(from_field(field), {}), kWidth_m, sweeps), {},
                        {});
}

// Parts with one to four variants anywhere.
RegionProblem any_problem(int most_parts) {
  RegionProblem problem;
  const auto any_point = [] {
    return Eigen::Vector2d(*rc::gen::inRange(0, 1000) / 10.0, *rc::gen::inRange(0, 1000) / 10.0);
  };
  const int parts = *rc::gen::inRange(1, most_parts + 1);
  for (int part = 0; part < parts; ++part) {
    auto& variants = problem.parts.emplace_back();
    const int count = *rc::gen::inRange(1, 5);
    for (int i = 0; i < count; ++i) {
      variants.push_back({any_point(), any_point(), *rc::gen::inRange(0, 500) / 10.0});
    }
  }
  if (*rc::gen::arbitrary<bool>()) problem.start_W = any_point();
  if (*rc::gen::arbitrary<bool>()) problem.end_W = any_point();
  return problem;
}

RegionRequest region_request(const RegionProblem& problem, std::string_view planner) {
  RegionRequest request;
  request.problem = problem;
  request.parameters =
      resolve_parameters(find_region_planner(planner, "test").parameters, {}, "test", "planner");
  return request;
}

RegionPlan planned(const RegionProblem& problem, std::string_view planner) {
  return find_region_planner(planner, "test").plan(region_request(problem, planner));
}

bool visits_every_part_once(const RegionProblem& problem, const RegionPlan& plan) {
  std::vector<int> parts;
  for (const RegionVisit visit : plan.visits) {
    parts.push_back(visit.part);
    const std::size_t variants = problem.parts[static_cast<std::size_t>(visit.part)].size();
    if (visit.variant < 0 || static_cast<std::size_t>(visit.variant) >= variants) return false;
  }
  std::ranges::sort(parts);
  std::vector<int> all(problem.parts.size());
  std::iota(all.begin(), all.end(), 0);
  return parts == all;
}

class EveryRegionPlanner : public testing::TestWithParam<std::size_t> {
 protected:
  const RegionPlannerEntry& planner_ = region_planners()[GetParam()];
  bool searches_ = planner_.name != "region_exact" && planner_.name != "region_enumeration";

  // The three scenes of the paper, a fixed end alone, one part, and sweeps in any direction.
  std::vector<RegionProblem> scenes() const {
    std::vector<RegionProblem> scenes(4, made_up_problem(5, 1));
    scenes[1].start_W = scenes[2].start_W = Eigen::Vector2d(-300, -300);
    scenes[2].end_W = scenes[3].end_W = Eigen::Vector2d(400, 500);
    scenes.push_back(made_up_problem(1, 1));
    scenes.push_back(made_up_problem(4, 2, PartSweeps::kAny));
    return scenes;
  }
  RegionRequest request(const RegionProblem& problem) const {
    RegionRequest request = region_request(problem, planner_.name);
    request.stop.iterations = 5;
    return request;
  }
};

TEST_P(EveryRegionPlanner, VisitsEveryPartOnceAndCountsWhatItDoes) {
  for (const RegionProblem& problem : scenes()) {
    const RegionPlan plan = planner_.plan(request(problem));
    EXPECT_EQ(plan.planner, planner_.name);
    EXPECT_TRUE(visits_every_part_once(problem, plan));
    EXPECT_NEAR(plan.cost, plan_cost(problem, plan.visits), kLengthRounding_m);
    EXPECT_GT(plan.evaluations, 0);
    ASSERT_FALSE(plan.convergence.empty());
    EXPECT_NEAR(plan.convergence.back().cost, plan.cost, kLengthRounding_m);
    for (std::size_t i = 1; i < plan.convergence.size(); ++i) {
      EXPECT_LT(plan.convergence[i].cost, plan.convergence[i - 1].cost);
      EXPECT_GT(plan.convergence[i].iteration, plan.convergence[i - 1].iteration);
    }
    EXPECT_EQ(plan.proven, !searches_);
    if (searches_) {
      EXPECT_EQ(plan.iterations, 5);
    }
  }
}

TEST_P(EveryRegionPlanner, IsTheSameForTheSameSeed) {
  const RegionProblem problem = made_up_problem(5, 3);
  RegionRequest request = region_request(problem, planner_.name);
  request.seed = 7;
  const RegionPlan one = planner_.plan(request);
  const RegionPlan again = planner_.plan(request);
  EXPECT_EQ(one.visits, again.visits);
  EXPECT_EQ(one.evaluations, again.evaluations);
  EXPECT_EQ(one.cost, again.cost);
}

TEST_P(EveryRegionPlanner, EndsAtItsLimits) {
  if (!searches_) return;
  RegionRequest request = region_request(made_up_problem(8, 1), planner_.name);
  request.stop = {std::numeric_limits<int>::max(), 500, 0.0, 0};
  const RegionPlan by_evaluations = planner_.plan(request);
  EXPECT_EQ(by_evaluations.stopped_by, StopReason::kEvaluations);
  EXPECT_GE(by_evaluations.evaluations, 500);
  EXPECT_LE(by_evaluations.evaluations, 500 + 20);  // local search looks every 16 changes
  request.stop = {std::numeric_limits<int>::max(), 0, 0.0, 20};
  const RegionPlan by_stagnation = planner_.plan(request);
  EXPECT_EQ(by_stagnation.stopped_by, StopReason::kStagnation);
  EXPECT_EQ(by_stagnation.iterations, by_stagnation.convergence.back().iteration + 20);
  request.stop = {std::numeric_limits<int>::max(), 0, 0.02, 0};
  EXPECT_EQ(planner_.plan(request).stopped_by, StopReason::kTime);
}

TEST_P(EveryRegionPlanner, HearsThatItIsCancelled) {
  const bool exact = planner_.name == "region_exact";
  RegionRequest request = region_request(made_up_problem(exact ? 12 : 8, 1), planner_.name);
  request.stop.iterations = std::numeric_limits<int>::max();
  int asked = 0;
  request.cancelled = [&] { return ++asked > 2; };
  EXPECT_THROW(planner_.plan(request), Cancelled);
  EXPECT_EQ(asked, 3);
}

TEST_P(EveryRegionPlanner, RefusesWhatIsNoProblem) {
  const auto told = [&](const RegionProblem& problem) {
    return refusal([&] { planner_.plan(region_request(problem, planner_.name)); });
  };
  EXPECT_THAT(told({}), HasSubstr("parts: '0': at least one part"));
  RegionProblem problem = made_up_problem(2, 1);
  problem.parts[1][2].cost = std::nan("");
  EXPECT_THAT(told(problem), HasSubstr("parts[1].cost: 'nan'"));
  problem.parts[1].clear();
  EXPECT_THAT(told(problem), HasSubstr("parts[1]: '0': at least one variant"));
  problem = made_up_problem(2, 1);
  problem.start_W = Eigen::Vector2d(0.0, std::numeric_limits<double>::infinity());
  EXPECT_THAT(told(problem), HasSubstr("start_W: '(0, inf)'"));
  RegionRequest request = region_request(made_up_problem(2, 1), planner_.name);
  request.stop.iterations = 0;
  EXPECT_THAT(refusal([&] { planner_.plan(request); }), HasSubstr("stop.iterations"));
}

INSTANTIATE_TEST_SUITE_P(Table, EveryRegionPlanner,
                         testing::Range(std::size_t{0}, region_planners().size()),
                         [](const auto& planner) {
                           return std::string(region_planners()[planner.param].name);
                         });

TEST(RegionLength, IsEquationFive) {
  // Two parts on a line: start 3 m before the first, 4 m between, end 5 m after, ways of 10 and 20.
  RegionProblem problem;
  problem.parts = {{{{3, 0}, {3, 1}, 10.0}}, {{{3, 5}, {3, 0}, 20.0}}};
  const std::vector<RegionVisit> visits = {{0, 0}, {1, 0}};
  EXPECT_DOUBLE_EQ(plan_cost(problem, visits), 34.0);
  problem.start_W = Eigen::Vector2d(0, 0);
  EXPECT_DOUBLE_EQ(plan_cost(problem, visits), 37.0);
  problem.end_W = Eigen::Vector2d(8, 0);
  EXPECT_DOUBLE_EQ(plan_cost(problem, visits), 42.0);
}

// On the flat a plan takes what its metres take: worked, raised between lines, in transit between
// parts. On a slope it matters which way they lead.
TEST(RegionEnergy, TakesMeasuredMetresBySlopeAndDirection) {
  const DriveCost cost = made_up_cost();
  const PartSweep sweep{0.0, {{{0, 0}, {20, 0}}, {{0, 2}, {20, 2}}}};
  const PartSweep above{0.0, {{{50, 0}, {70, 0}}}};
  const std::vector<WorkedPart> parts = {{{}, {sweep}}, {{}, {above}}};
  RegionProblem problem = region_problem(parts, Eigen::Vector2d(0, -10), std::nullopt);
  price_by_energy(parts, cost, nullptr, problem);
  const std::vector<RegionVisit> out = {{0, 0}, {1, 0}};
  const double flat_wh = 10 * 0.3 + 40 * 1.0 + 2 * 0.4 + std::hypot(50.0, 2.0) * 0.3 + 20 * 1.0;
  EXPECT_NEAR(plan_cost(problem, out), flat_wh, 1e-9);
  const Heightfield east_is_up = waves(0.0, 40.0, 0.1);
  price_by_energy(parts, cost, &east_is_up, problem);
  const RegionVariant& up = problem.parts[1][0];
  const RegionVariant& down = problem.parts[1][1];
  EXPECT_NEAR(up.cost, 20 * 1.8, 1e-6);
  EXPECT_NEAR(down.cost, 20 * 0.4, 1e-6);
}

// Every planner takes measured costs, and by them its plan takes no more than the one by length.
// The searches draw at random: they are given what it takes to come to the best of few parts.
TEST_P(EveryRegionPlanner, TakesNoMoreByMeasuredCostsThanByLength) {
  constexpr double kWidth_m = 40.0;
  const DriveCost cost = made_up_cost();
  const Heightfield ground = waves(6.0, 300.0, 0.02);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Field field = made_up_region({4, -1, 4e4, seed}, "test");
    const std::vector<WorkedPart> parts =
        worked_parts(region_parts(from_field(field), {}), kWidth_m, PartSweeps::kOwn);
    RegionProblem by_length = region_problem(parts, {}, {});
    RegionProblem by_energy = by_length;
    price_by_energy(parts, cost, &ground, by_energy);
    RegionRequest request = region_request(by_length, planner_.name);
    request.stop.iterations = 300;
    const RegionPlan shortest = planner_.plan(request);
    request.problem = by_energy;
    const RegionPlan measured = planner_.plan(request);
    EXPECT_LE(measured.cost, plan_cost(by_energy, shortest.visits) + kLengthRounding_m);
    EXPECT_NEAR(measured.cost, plan_cost(by_energy, measured.visits), kLengthRounding_m);
  }
}

TEST(RegionEnergy, RefusesMorePartsThanItsTableHolds) {
  RegionProblem problem;
  problem.parts.assign(501, std::vector<RegionVariant>(4));
  EXPECT_THAT(refusal([&] { price_links(made_up_cost(), nullptr, problem); }),
              HasSubstr("parts: '2004 ways to work them': at most 2000 in all"));
}

TEST(RegionExact, FindsWhatEnumerationFindsOnAnyProblem) {
  EXPECT_TRUE(rc::check([] {
    const RegionProblem problem = any_problem(4);
    const RegionPlan exact = planned(problem, "region_exact");
    const RegionPlan all = planned(problem, "region_enumeration");
    double plans = 1.0;
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
      plans *= static_cast<double>((i + 1) * problem.parts[i].size());
    }
    RC_ASSERT(static_cast<double>(all.evaluations) == plans);
    RC_ASSERT(all.proven && exact.proven);
    RC_ASSERT(std::abs(exact.cost - all.cost) < kLengthRounding_m);
  }));
}

TEST(RegionExact, IsNeverBeatenAndLocalSearchReachesIt) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const PartSweeps sweeps : {PartSweeps::kOwn, PartSweeps::kAny}) {
      const RegionProblem problem = made_up_problem(8, seed, sweeps);
      const double optimum_m = planned(problem, "region_exact").cost;
      for (const RegionPlannerEntry& planner : region_planners()) {
        if (planner.name == "region_enumeration") continue;
        RegionRequest request = region_request(problem, planner.name);
        request.stop.iterations = 30;
        const double own_m = planner.plan(request).cost;
        EXPECT_GE(own_m, optimum_m - kLengthRounding_m) << planner.name;
        if (planner.name == "region_local_search") {
          EXPECT_LE(own_m, 1.01 * optimum_m);
        }
      }
    }
  }
}

TEST(RegionExact, MoreDirectionsNeverMakeTheOptimumLonger) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    EXPECT_LE(planned(made_up_problem(8, seed, PartSweeps::kAny), "region_exact").cost,
              planned(made_up_problem(8, seed), "region_exact").cost + kLengthRounding_m);
  }
}

TEST(RegionExact, RefusesWhatNeedsTooMuchMemory) {
  const RegionProblem problem = made_up_problem(40, 1);
  EXPECT_THAT(refusal([&] { planned(problem, "region_exact"); }),
              HasSubstr("region_local_search does without"));
  EXPECT_THAT(refusal([&] { planned(problem, "region_enumeration"); }),
              HasSubstr("region_exact or region_local_search do without"));
}

TEST(ChooseVariants, FindsTheBestOfAllForTheOrder) {
  EXPECT_TRUE(rc::check([] {
    const RegionProblem problem = any_problem(5);
    std::vector<RegionVisit> visits;
    for (int part = 0; part < problem.size(); ++part) visits.push_back({part, 0});
    const int last = problem.size() - 1;
    const int first = *rc::gen::inRange(0, last + 1);
    std::vector<RegionVisit> chosen = visits;
    choose_variants(problem, chosen, first, last);
    for (int place = 0; place < first; ++place) {
      RC_ASSERT(chosen[static_cast<std::size_t>(place)].variant == 0);
    }
    const double chosen_m = plan_cost(problem, chosen);
    // Count through all choices like an odometer.
    for (;;) {
      RC_ASSERT(plan_cost(problem, visits) > chosen_m - kLengthRounding_m);
      int place = first;
      for (; place <= last; ++place) {
        RegionVisit& visit = visits[static_cast<std::size_t>(place)];
        const auto& variants = problem.parts[static_cast<std::size_t>(place)];
        if (++visit.variant < static_cast<int>(variants.size())) break;
        visit.variant = 0;
      }
      if (place > last) break;
    }
  }));
}

TEST(RegionGenes, RepairRanksWhatIsNoOrder) {
  // Of 3 1 3 1 the ones come first, in their order, then the threes.
  RegionGenes genes = {3, 1, 3, 1, 4, 2, 2, 1};
  repair(genes);
  EXPECT_THAT(genes, testing::ElementsAre(3, 1, 4, 2, 4, 2, 2, 1));
  const RegionGenes repaired = genes;
  repair(genes);
  EXPECT_EQ(genes, repaired);
}

TEST(RegionGenes, AreOrderAndVariantsByPlace) {
  // The paper's example: order 2 3 5 6 4 1 with paths 1 3 1 2 3 2.
  const RegionProblem problem = made_up_problem(6, 1);
  const std::vector<RegionVisit> visits = visits_of(problem, {2, 3, 5, 6, 4, 1, 1, 3, 1, 2, 3, 2});
  const std::vector<RegionVisit> expected = {{1, 0}, {2, 2}, {4, 0}, {5, 1}, {3, 2}, {0, 1}};
  EXPECT_EQ(visits, expected);
}

TEST(RegionGenes, PartsWithFewerVariantsTakeTheirShareOfTheRange) {
  RegionProblem problem = made_up_problem(2, 1);
  problem.parts[0].resize(2);
  const auto variant = [&](double gene) { return visits_of(problem, {1, 2, gene, 1})[0].variant; };
  EXPECT_EQ(variant(1), 0);
  EXPECT_EQ(variant(2), 0);
  EXPECT_EQ(variant(3), 1);
  EXPECT_EQ(variant(4), 1);
}

TEST(RegionIga, MutatesAsEquationsOneAndTwoSay) {
  // round(rand 3) + 1: 1 and 4 are half as likely as 2 and 3.
  RegionRequest request = region_request(made_up_problem(6, 1), "region_iga");
  RegionTask task(request);
  constexpr int kDraws = 60000;
  std::map<double, int> counts;
  for (int i = 0; i < kDraws; ++i) ++counts[mutated_gene(task, 6, 0.0, 1.0)];
  // Shares differ from their expectation by four deviations of a binomial count at most.
  const double tolerance = 4.0 * std::sqrt(kDraws * 0.25);
  EXPECT_NEAR(counts[1], kDraws / 6.0, tolerance);
  EXPECT_NEAR(counts[2], kDraws / 3.0, tolerance);
  EXPECT_NEAR(counts[3], kDraws / 3.0, tolerance);
  EXPECT_NEAR(counts[4], kDraws / 6.0, tolerance);
  int kept = 0;
  for (int i = 0; i < kDraws; ++i) kept += mutated_gene(task, 0, 0.0, 0.3) == 0.0 ? 1 : 0;
  EXPECT_NEAR(kept, 0.7 * kDraws, tolerance);
}

TEST(RegionIga, ItsPopulationShrinksAsEquationSixSays) {
  RegionRequest request = region_request(made_up_problem(6, 1), "region_iga");
  request.stop.iterations = 10;
  // 96 to begin with, then in iteration g + 1 round(96 - 92 g / 10).
  std::int64_t evaluations = 96;
  for (int g = 0; g < 10; ++g) evaluations += std::lround(96.0 - 92.0 * g / 10.0);
  EXPECT_EQ(find_region_planner("region_iga", "test").plan(request).evaluations, evaluations);
  request.parameters["least_population"] = 97.0;
  EXPECT_THAT(refusal([&] { find_region_planner("region_iga", "test").plan(request); }),
              HasSubstr("least_population: '97': at most 96"));
}

TEST(RegionPlanners, AreFoundByNameAndTheNearestIsTold) {
  EXPECT_EQ(find_region_planner("region_iga", "x").name, "region_iga");
  EXPECT_THAT(refusal([] { find_region_planner("region_igo", "spec.yaml"); }),
              HasSubstr("the nearest is region_iga"));
}

}  // namespace
}  // namespace headland
