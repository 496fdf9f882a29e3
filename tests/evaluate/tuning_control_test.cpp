#include "evaluate/tuning_control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace headland {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::SizeIs;

constexpr double kError_wh = 1e-9;  // of sums of a few hundred

PlanRun run_of(const std::string& block, const std::string& method, double energy_wh) {
  PlanRun run;
  run.block = block;
  run.method = method;
  run.energy_wh = energy_wh;
  return run;
}

// A fit that plans better, one that plans worse, and one that plans the same.
std::vector<PlanRun> three_fits() {
  std::vector<PlanRun> plans;
  for (const auto& [block, wh] : {std::pair{"a", 100.0}, std::pair{"b", 200.0}}) {
    plans.push_back(run_of(block, "fitted", wh));
    plans.push_back(run_of(block, "shuffled 1", 0.9 * wh));
    plans.push_back(run_of(block, "shuffled 2", 1.4 * wh));
    plans.push_back(run_of(block, "shuffled 3", wh));
  }
  return plans;
}

TEST(TuningControlTest, CountsFitsThatPlanAsWell) {
  TuningControl control;
  control.fitted = "fitted";
  control.fits = 5;
  control.without_weights = 2;
  judge_control(three_fits(), control);
  EXPECT_EQ(control.as_good, 2);
  EXPECT_DOUBLE_EQ(control.p, 3.0 / 6.0);
}

TEST(TuningControlTest, ChanceIsUnlikelyWhereNoFitPlansAsWell) {
  std::vector<PlanRun> plans = {run_of("a", "fitted", 100.0)};
  TuningControl control;
  control.fitted = "fitted";
  control.fits = 19;
  for (int i = 1; i <= control.fits; ++i) {
    plans.push_back(run_of("a", "shuffled " + std::to_string(i), 100.0 + i));
  }
  judge_control(plans, control);
  EXPECT_EQ(control.as_good, 0);
  EXPECT_DOUBLE_EQ(control.p, 0.05);
  // One that does not get to the end is none that plans as well.
  plans.back().energy_wh = 1.0;
  plans.back().fault = "stuck";
  judge_control(plans, control);
  EXPECT_EQ(control.as_good, 0);
}

TEST(TuningControlTest, WeightsWhosePlansAreNotDrivenToTheEndProveNothing) {
  std::vector<PlanRun> plans = three_fits();
  for (PlanRun& plan : plans) plan.fault = plan.method == "fitted" ? "stuck" : "";
  TuningControl control;
  control.fitted = "fitted";
  control.fits = 3;
  judge_control(plans, control);
  EXPECT_DOUBLE_EQ(control.p, 1.0);
  // Nor where nothing was driven at all.
  for (PlanRun& plan : plans) plan.fault = "stuck";
  control.as_good = 0;
  judge_control(plans, control);
  EXPECT_DOUBLE_EQ(control.p, 1.0);
}

TEST(TuningControlTest, AllFitsAreOneMethodByTheirMeans) {
  std::vector<PlanRun> plans = three_fits();
  plans[6].fault = "stuck";  // "shuffled 2" on b
  std::vector<PlanRun> stuck = plans;
  std::vector<PlanRun> told = take_control(plans);
  EXPECT_THAT(plans, Each(Field(&PlanRun::method, "fitted")));
  ASSERT_THAT(told, SizeIs(2));
  EXPECT_EQ(told[0].method, "shuffled");
  EXPECT_NEAR(told[0].energy_wh, 110.0, kError_wh);
  EXPECT_EQ(told[1].block, "b");
  EXPECT_NEAR(told[1].energy_wh, 190.0, kError_wh);
  EXPECT_EQ(told[1].fault, "");

  for (PlanRun& plan : stuck) plan.fault = "stuck";
  told = take_control(stuck);
  ASSERT_THAT(told, SizeIs(2));
  EXPECT_EQ(told[1].fault, "stuck");
}

}  // namespace
}  // namespace headland
