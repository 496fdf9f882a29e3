#include "evaluate/energy_fit.h"
#include "evaluate/adapted_weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "evaluate/method_savings.h"
#include "evaluate/weight_search.h"
#include "planner/seeded_random.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Fits of a few terms by normal equations lose half of the digits.
constexpr double kFitError = 1e-7;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(NonnegativeFitTest, IsLeastSquaresWhereThoseArePositive) {
  SeededRandom random(1);
  Eigen::MatrixXd terms(30, 4);
  for (double& entry : terms.reshaped()) entry = draw_unit(random);
  const Eigen::Vector4d truth(2.0, 0.5, 3.0, 1.0);
  EXPECT_LT((nonnegative_fit(terms, terms * truth) - truth).norm(), kFitError);
}

// Lawson and Hanson's condition of the optimum: the gradient is 0 where a coefficient is above 0,
// and nowhere would a coefficient at 0 gain by growing.
TEST(NonnegativeFitTest, MeetsTheConditionsOfTheOptimum) {
  SeededRandom random(2);
  int at_zero = 0;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::MatrixXd terms(12, 5);
    for (double& entry : terms.reshaped()) entry = draw_unit(random) - 0.5;
    Eigen::VectorXd values(12);
    for (double& value : values) value = draw_unit(random) - 0.5;
    const Eigen::VectorXd fit = nonnegative_fit(terms, values);
    const Eigen::VectorXd gain = terms.transpose() * (values - terms * fit);
    for (Eigen::Index i = 0; i < fit.size(); ++i) {
      EXPECT_GE(fit(i), 0.0);
      if (fit(i) > 0.0) {
        EXPECT_NEAR(gain(i), 0.0, kFitError);
      } else {
        EXPECT_LE(gain(i), kFitError);
        ++at_zero;
      }
    }
  }
  EXPECT_GT(at_zero, 50);  // the bound was at work
}

// min |x - (1, -1)| with x >= 0 is (1, 0).
TEST(NonnegativeFitTest, HoldsAtZeroWhatWouldBeNegative) {
  const Eigen::VectorXd fit =
      nonnegative_fit(Eigen::Matrix2d::Identity(), Eigen::Vector2d(1.0, -1.0));
  EXPECT_DOUBLE_EQ(fit(0), 1.0);
  EXPECT_EQ(fit(1), 0.0);
}

TEST(NonnegativeFitTest, NamesTermsThatCannotBeToldApart) {
  Eigen::MatrixXd terms(4, 3);
  terms << 1, 2, 0.3, 2, 4, 0.1, 3, 6, 0.9, 4, 8, 0.2;
  EXPECT_THAT(collinear_terms(terms), ElementsAre(0, 1));
  terms.col(1) << 1, 0, 5, 2;
  EXPECT_THAT(collinear_terms(terms), IsEmpty());
  terms.col(2).setZero();
  EXPECT_THAT(collinear_terms(terms), ElementsAre(2));
  EXPECT_THAT(collinear_terms(Eigen::MatrixXd::Ones(2, 3)), SizeIs(3));  // fewer rows than terms
}

// Plans of four made-up fields whose energies are known sums of what was counted.
constexpr double kCell_wh = 2.0;
constexpr double kRepeat_wh = 0.7;
constexpr double kTurn_wh = 1.3;
constexpr double kUTurn_wh = 4.0;

std::vector<PlanRun> made_up_plans(double noise_wh = 0.0) {
  SeededRandom random(3);
  std::vector<PlanRun> plans;
  for (int field = 0; field < 4; ++field) {
    const int cells = 100 + 60 * field;
    for (int i = 0; i < 20; ++i) {
      PlanRun plan;
      plan.block = "field " + std::to_string(field);
      plan.cell_m = 2.0;
      plan.counts.distinct_cells = cells;
      plan.counts.repeats = draw_below(random, 30);
      plan.counts.turns = 10 + draw_below(random, 40);
      plan.counts.u_turns = draw_below(random, 6);
      plan.counts.steps = cells - 1 + plan.counts.repeats;
      plan.counts.level_m = plan.cell_m * plan.counts.steps;
      plan.energy_wh = kCell_wh * cells + kRepeat_wh * plan.counts.repeats +
                       kTurn_wh * plan.counts.turns + kUTurn_wh * plan.counts.u_turns +
                       noise_wh * (draw_unit(random) - 0.5);
      plan.predicted_wh = 0.9 * plan.energy_wh;
      plan.predicted_kind_wh = {0.9 * plan.energy_wh, 0.0, 0.0, 0.0, 0.0};
      plans.push_back(plan);
    }
  }
  return plans;
}

EnergyFit fit_of(GridObjective form, const std::vector<PlanRun>& plans) {
  return fit_energy(form, plans, 200, 1, "spec.yaml");
}

TEST(EnergyFitTest, RecoversKnownWeights) {
  const EnergyFit fit = fit_of(GridObjective::kWeighted, made_up_plans());
  ASSERT_THAT(fit.terms, SizeIs(4));
  const double truth[] = {kCell_wh, kRepeat_wh, kTurn_wh, kUTurn_wh};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(fit.terms[i].coefficient, truth[i], kFitError) << fit.terms[i].name;
  }
  const GridCost cost = fitted_cost(fit).value();
  EXPECT_EQ(cost.objective, GridObjective::kWeighted);
  EXPECT_NEAR(cost.weights.u_turn, kUTurn_wh, kFitError);
}

TEST(EnergyFitTest, IntervalsCoverTheTruthAndNarrowWithLessNoise) {
  const EnergyFit rough = fit_of(GridObjective::kWeighted, made_up_plans(20.0));
  const EnergyFit fine = fit_of(GridObjective::kWeighted, made_up_plans(2.0));
  const Interval& interval = rough.terms[2].interval;
  EXPECT_LT(interval.low, kTurn_wh);
  EXPECT_GT(interval.high, kTurn_wh);
  EXPECT_LT(fine.terms[2].interval.high - fine.terms[2].interval.low,
            0.5 * (interval.high - interval.low));
}

TEST(EnergyFitTest, TellsHowWellFormsPredict) {
  const std::vector<PlanRun> plans = made_up_plans();
  const EnergyFit fit = fit_of(GridObjective::kWeighted, plans);
  std::vector<double> fitted;
  std::vector<double> printed;
  for (const PlanRun& plan : plans) {
    fitted.push_back(fitted_energy_wh(fit, plan));
    printed.push_back(printed_energy_wh(fit, plan));
  }
  const Prediction after = prediction_of(plans, fitted);
  const Prediction before = prediction_of(plans, printed);
  EXPECT_NEAR(after.r2, 1.0, kFitError);
  // Energies that are equal come out different in the last digit.
  constexpr double kTies = 0.01;
  EXPECT_NEAR(after.spearman_in_block, 1.0, kTies);
  EXPECT_NEAR(after.mean_absolute_error, 0.0, kFitError);
  EXPECT_LT(before.spearman_in_block, after.spearman_in_block);
  EXPECT_GT(before.mean_absolute_error, after.mean_absolute_error);
  // A tenth less than driven is an error of a tenth, and one factor mends it.
  const EnergyFit measured = fit_of(GridObjective::kMeasured, plans);
  EXPECT_NEAR(measured.terms[0].coefficient, 1.0 / 0.9, kFitError);
  EXPECT_EQ(measured.terms[1].coefficient, 1.0);  // no plan has any
  EXPECT_NEAR(printed_energy_wh(measured, plans[0]), 0.9 * plans[0].energy_wh, kFitError);
}

// Negative control: energies that have nothing to do with the plans give no weights worth planning
// by, and tell nothing.
TEST(EnergyFitTest, ShuffledEnergiesTellNothing) {
  const std::vector<PlanRun> plans = made_up_plans();
  const std::vector<PlanRun> shuffled = with_shuffled_energies(plans, 5);
  double sum = 0.0;
  double shuffled_sum = 0.0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    sum += plans[i].energy_wh;
    shuffled_sum += shuffled[i].energy_wh;
  }
  EXPECT_NEAR(shuffled_sum, sum, kFitError);
  const EnergyFit fit = fit_of(GridObjective::kWeighted, shuffled);
  std::vector<double> told;
  for (const PlanRun& plan : plans) told.push_back(fitted_energy_wh(fit, plan));
  // Three weights fitted to twenty plans a field follow chance a little.
  constexpr double kChance = 0.4;
  EXPECT_LT(prediction_of(shuffled, told).spearman_in_block, kChance);
}

// Two plans on one field count 2 and 6 turns, none else: the second is above the mean of 4, its
// weight of turns grows by a third before all three are scaled to 1 (Wu et al., Eqs 2 to 10).
TEST(EnergyFitTest, AdaptsWeightsAsThePaperDoes) {
  std::vector<PlanRun> plans(2);
  for (PlanRun& plan : plans) {
    plan.block = "field";
    plan.counts.distinct_cells = 10;
  }
  plans[0].counts.turns = 2;
  plans[1].counts.turns = 6;
  const std::vector<double> costs = adapted_costs(plans);
  EXPECT_NEAR(costs[0], 2.0 * 0.2, 1e-12);
  const double grown = 0.2 * (1.0 + 2.0 / 6.0);
  EXPECT_NEAR(costs[1], 6.0 * grown / (0.8 + grown), 1e-12);
  // Energies that are sums of these are told exactly.
  for (std::size_t i = 0; i < plans.size(); ++i) plans[i].energy_wh = 3.0 * costs[i] + 10.0 * 0.5;
  const AdaptedFit fit = fit_adapted(plans);
  EXPECT_NEAR(fit.scale, 3.0, 1e-9);
  EXPECT_NEAR(fit.cell_wh, 0.5, 1e-9);
  EXPECT_NEAR(adapted_energies_wh(fit, plans)[1], plans[1].energy_wh, 1e-9);
}

TEST(EnergyFitTest, RefusesWhatCannotBeFitted) {
  std::vector<PlanRun> plans = made_up_plans();
  EXPECT_THAT(
      refusal([&] { fit_of(GridObjective::kTractor, plans); }),
      HasSubstr(
          "spec.yaml: training: 'climb': in no training plan, so that tractor cannot be fitted; "
          "other fields, terrains or plans help, or leave tractor out of forms"));
  for (PlanRun& plan : plans) plan.counts.turns = 2 * plan.counts.repeats;
  EXPECT_THAT(refusal([&] { fit_of(GridObjective::kWeighted, plans); }),
              HasSubstr("'repeats, turns': not told apart by the training plans, so that weighted "
                        "cannot be fitted"));
  plans.resize(3);
  EXPECT_THAT(refusal([&] { fit_of(GridObjective::kWeighted, plans); }),
              HasSubstr("'3 plans': at least 4 are needed to fit weighted"));
}

TEST(EnergyFitTest, LeavesOutWhatHasNoFigures) {
  std::vector<PlanRun> plans = made_up_plans();
  plans[0].fault = "stuck";
  plans[0].energy_wh = kNotANumber;
  plans[1].jumps = true;
  plans[2].predicted_wh = kNotANumber;
  EXPECT_THAT(fit_plans(plans), SizeIs(plans.size() - 3));
}

// Plans by two methods on five fields: the second takes a tenth less on each.
TEST(MethodSavingsTest, PairsPlansOfTheSameField) {
  std::vector<PlanRun> plans;
  for (int field = 0; field < 5; ++field) {
    for (const char* method : {"rows", "tuned"}) {
      PlanRun plan;
      plan.block = std::to_string(field);
      plan.method = method;
      const bool tuned = plan.method == "tuned";
      plan.energy_wh = (100.0 + 10.0 * field) * (tuned ? 0.9 : 1.0);
      plan.energy_wh_per_ha = plan.time_s = plan.delta_soc = plan.energy_wh;
      plans.push_back(plan);
    }
  }
  PlanRun stuck;
  stuck.block = "0";
  stuck.method = "stuck";
  stuck.fault = "stuck: slip";
  stuck.energy_wh = kNotANumber;
  plans.push_back(stuck);
  const std::vector<MethodFigures> figures = method_figures(plans, {"rows"});
  ASSERT_THAT(figures, SizeIs(3));
  EXPECT_EQ(energy_saving(figures[0], "rows"), nullptr);  // over itself
  const Saving& saving = *energy_saving(figures[1], "rows");
  EXPECT_EQ(saving.blocks, 5);
  EXPECT_NEAR(saving.ratio.mean, 0.1, kFitError);
  EXPECT_NEAR(saving.ratio.ci95.value_or(1.0), 0.0, kFitError);
  EXPECT_EQ(saving.test.wins, 5);
  EXPECT_DOUBLE_EQ(saving.test.p, 0.0625);  // the least that five pairs can give
  EXPECT_NEAR(figures[1].mean.energy_wh, 108.0, kFitError);
  EXPECT_EQ(figures[2].faults, 1);
  EXPECT_EQ(figures[2].first_fault, "0: stuck: slip");
  EXPECT_TRUE(std::isnan(figures[2].mean.energy_wh));
  EXPECT_TRUE(std::isnan(figures[2].mean.coverage_ratio));
  EXPECT_EQ(energy_saving(figures[2], "rows")->blocks, 0);
  EXPECT_TRUE(std::isnan(energy_saving(figures[2], "rows")->ratio.mean));
}

// A bowl with its bottom at shares of 0.2, 0.5, 0.3.
double bowl(const WeightShares& weights) {
  const double turn = std::log(weights[1] / weights[0] / 2.5);
  const double u_turn = std::log(weights[2] / weights[0] / 1.5);
  return turn * turn + u_turn * u_turn;
}

TEST(WeightSearchTest, FindsTheBottomWithinItsBudget) {
  int calls = 0;
  const WeightLoss loss = [&](const WeightShares& weights) {
    ++calls;
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 0.01);  // to three digits
    return bowl(weights);
  };
  const WeightSearch found = search_weights(loss, {{0.3, 0.2, 0.5}}, 120, 1);
  EXPECT_LE(calls, 120);
  EXPECT_EQ(found.evaluations, 120);
  EXPECT_THAT(found.least_so_far, SizeIs(120));
  EXPECT_LT(found.loss, 0.05 * bowl({0.3, 0.2, 0.5}));
  EXPECT_NEAR(found.weights[1], 0.5, 0.1);
  EXPECT_EQ(found.weights, search_weights(bowl, {{0.3, 0.2, 0.5}}, 120, 1).weights);  // by seed
}

TEST(WeightSearchTest, ASmallBudgetTriesTheStarts) {
  const WeightSearch found = search_weights(bowl, {{0.3, 0.2, 0.5}, {0.2, 0.5, 0.3}}, 3, 1);
  EXPECT_EQ(found.evaluations, 2);
  EXPECT_NEAR(found.weights[1], 0.5, 0.001);
}

TEST(WeightSearchTest, EndsWhenALossIsCancelled) {
  EXPECT_THROW(search_weights([](const WeightShares&) -> double { throw Cancelled{}; },
                              {{0.3, 0.2, 0.5}}, 60, 1),
               Cancelled);
}

}  // namespace
}  // namespace headland
