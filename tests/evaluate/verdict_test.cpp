#include "evaluate/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "evaluate/metrics.h"
#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A run that went well: every figure is a little better than its warning.
struct JudgedRun {
  Path path;
  RunRecord record;
  Metrics metrics;

  JudgedRun() {
    metrics.coverage_ratio = 0.99;
    metrics.overlap_ratio = 0.10;
    metrics.outside_area_ratio = 0.001;
    metrics.track_rms_working_m = 0.03;
    metrics.coverage.missed_m2 = 312.0;
    metrics.delta_soc = 0.6;
    record.soc_end = 0.4;
    record.duration_s = 500.0;
    record.peaks.slip = {0.1, 10.0, {1.0, 2.0}};
    record.peaks.load_transfer_ratio = {-0.3, 200.0, {12.34, 4.5}};
    record.peaks.cross_track_working_m = {-0.1, 30.0, {5.0, 6.0}};
    record.peaks.boundary_overrun_m = {0.0, 0.0, {0.0, 0.0}};
    record.samples.resize(1);
    record.samples.back().p_WB = {7.0, 8.0, 0.5};
  }

  Verdict judged() const { return judge(path, record, metrics, VerdictLimits()); }
};

TEST(Verdict, AGoodRunPassesWithoutReasons) {
  const Verdict verdict = JudgedRun().judged();
  EXPECT_EQ(verdict.grade, Grade::kPass);
  EXPECT_TRUE(verdict.reasons.empty());
}

// One limit: how to bring its figure to a value, and values on each side of the defaults.
struct LimitCase {
  const char* figure;
  std::function<void(JudgedRun&, double)> set;
  double fine;
  double warns;
  double fails;
  bool placed;
};

class EveryLimit : public testing::TestWithParam<LimitCase> {};

INSTANTIATE_TEST_SUITE_P(
    All, EveryLimit,
    testing::Values(
        LimitCase{"coverage_ratio_min",
                  [](JudgedRun& r, double v) { r.metrics.coverage_ratio = v; }, 0.98, 0.97, 0.94,
                  false},
        LimitCase{"overlap_ratio_max", [](JudgedRun& r, double v) { r.metrics.overlap_ratio = v; },
                  0.15, 0.16, 0.31, false},
        LimitCase{"outside_area_ratio_max",
                  [](JudgedRun& r, double v) { r.metrics.outside_area_ratio = v; }, 0.005, 0.006,
                  0.021, false},
        LimitCase{"slip_max", [](JudgedRun& r, double v) { r.record.peaks.slip.value = v; }, 0.2,
                  0.21, 0.31, true},
        LimitCase{"load_transfer_max",
                  [](JudgedRun& r, double v) { r.record.peaks.load_transfer_ratio.value = -v; },
                  0.6, 0.61, 0.91, true},
        LimitCase{"track_rms_working_m_max",
                  [](JudgedRun& r, double v) { r.metrics.track_rms_working_m = v; }, 0.05, 0.06,
                  0.16, false},
        LimitCase{"track_error_m_max",
                  [](JudgedRun& r, double v) { r.record.peaks.cross_track_working_m.value = -v; },
                  0.3, 0.31, 1.01, true},
        LimitCase{"boundary_overrun_m_max",
                  [](JudgedRun& r, double v) { r.record.peaks.boundary_overrun_m.value = v; }, 0.05,
                  0.06, 0.51, true},
        LimitCase{"belly_contact_m_max",
                  [](JudgedRun& r, double v) { r.record.peaks.belly_contact_m.value = v; }, 0.0,
                  0.01, 0.06, true},
        LimitCase{"reserve_soc_min", [](JudgedRun& r, double v) { r.record.soc_end = v; }, 0.20,
                  0.19, 0.09, false},
        LimitCase{"ledger_residual_ratio_max",
                  [](JudgedRun& r, double v) { r.metrics.ledger_residual_ratio = v; }, 0.001, 0.002,
                  0.011, false}),
    [](const auto& test) { return std::string(test.param.figure); });

TEST_P(EveryLimit, GradesItsFigureAndSaysWhichLimitItPassed) {
  JudgedRun run;
  GetParam().set(run, GetParam().fine);
  EXPECT_EQ(run.judged().grade, Grade::kPass) << "a figure on its warning limit is fine";

  GetParam().set(run, GetParam().warns);
  const Verdict warned = run.judged();
  EXPECT_EQ(warned.grade, Grade::kWarn);
  ASSERT_EQ(warned.reasons.size(), 1U);
  EXPECT_EQ(warned.reasons.front().figure, GetParam().figure);
  EXPECT_DOUBLE_EQ(warned.reasons.front().value, GetParam().warns);
  EXPECT_DOUBLE_EQ(warned.reasons.front().limit, GetParam().fine);
  EXPECT_EQ(warned.reasons.front().p_W.has_value(), GetParam().placed);
  EXPECT_EQ(warned.reasons.front().time_s.has_value(), GetParam().placed);

  GetParam().set(run, GetParam().fails);
  const Verdict failed = run.judged();
  EXPECT_EQ(failed.grade, Grade::kFail);
  ASSERT_EQ(failed.reasons.size(), 1U);
  EXPECT_EQ(failed.reasons.front().figure, GetParam().figure);
  EXPECT_NE(failed.reasons.front().limit, warned.reasons.front().limit);
  EXPECT_THAT(failed.reasons.front().text, HasSubstr("limit"));
}

TEST_P(EveryLimit, FailsOnAFigureThatIsNotANumber) {
  JudgedRun run;
  GetParam().set(run, kNaN);
  const Verdict verdict = run.judged();
  EXPECT_EQ(verdict.grade, Grade::kFail);
  ASSERT_EQ(verdict.reasons.size(), 1U);
  EXPECT_EQ(verdict.reasons.front().figure, GetParam().figure);
  EXPECT_THAT(verdict.reasons.front().text, HasSubstr("could not be measured"));
}

TEST(Verdict, SpeaksInSentencesWithPlaceAndTime) {
  JudgedRun run;
  run.record.peaks.load_transfer_ratio.value = -0.72;
  EXPECT_EQ(run.judged().reasons.front().text,
            "Load transfer reached 0.72 (limit 0.60) at x 12.3 m, y 4.5 m after 3 min 20 s: the "
            "left wheels carried too little; at 1.00 they lift");
  run.record.peaks.load_transfer_ratio.value = 0.72;
  run.record.peaks.load_transfer_ratio.time_s = 3723.0;
  EXPECT_THAT(run.judged().reasons.front().text,
              AllOf(HasSubstr("1 h 02 min"), HasSubstr("the right wheels")));
  run.record.peaks.load_transfer_of_trailer = true;
  EXPECT_THAT(run.judged().reasons.front().text,
              HasSubstr("the right wheel of the trailed implement carried too little"));
  run = JudgedRun();
  run.metrics.coverage_ratio = 0.931;
  EXPECT_EQ(run.judged().reasons.front().text,
            "Coverage was only 93.1 % (limit 95.0 %): 312 m2 were not worked");
}

TEST(Verdict, ARunThatDidNotFinishFailsWhateverItsFigures) {
  for (const Outcome outcome :
       {Outcome::kStuck, Outcome::kRolledOver, Outcome::kLeftField, Outcome::kEnteredHole,
        Outcome::kLeftTerrain, Outcome::kHitObstacle, Outcome::kBatteryEmpty, Outcome::kTimedOut,
        Outcome::kDiverged, Outcome::kInterrupted}) {
    JudgedRun run;
    run.record.outcome = outcome;
    run.record.outcome_detail = "no progress for 20 s on a 31 % slope";
    const Verdict verdict = run.judged();
    EXPECT_EQ(verdict.grade, Grade::kFail);
    ASSERT_EQ(verdict.reasons.size(), 1U);
    const Reason& reason = verdict.reasons.front();
    EXPECT_EQ(reason.figure, "outcome");
    EXPECT_EQ(reason.p_W, Eigen::Vector2d(7.0, 8.0));
    EXPECT_EQ(reason.time_s, 500.0);
    EXPECT_THAT(reason.text, AllOf(HasSubstr(std::string(outcome_name(outcome))),
                                   HasSubstr("31 % slope"), HasSubstr("8 min 20 s")));
  }
}

TEST(Verdict, AnAcceptedPathThatDoesNotFitWarns) {
  JudgedRun run;
  run.path.violations.push_back(
      {.p_W = {3.0, 4.0}, .overrun_m = 0.4, .what = "hull past the edge"});
  run.path.violations.push_back({.p_W = {5.0, 6.0}, .overrun_m = 1.2, .what = "turn too tight"});
  const Verdict verdict = run.judged();
  EXPECT_EQ(verdict.grade, Grade::kWarn);
  ASSERT_EQ(verdict.reasons.size(), 1U);
  EXPECT_EQ(verdict.reasons.front().figure, "path");
  EXPECT_EQ(verdict.reasons.front().value, 2.0);
  EXPECT_THAT(
      verdict.reasons.front().text,
      AllOf(HasSubstr("2 places"), HasSubstr("1.20 m at x 5.0 m, y 6.0 m: turn too tight")));
}

TEST(Verdict, PutsTheWorstReasonFirst) {
  JudgedRun run;
  run.metrics.coverage_ratio = 0.97;        // warns
  run.record.peaks.slip.value = 0.4;        // fails
  run.metrics.overlap_ratio = 0.2;          // warns
  run.record.outcome = Outcome::kTimedOut;  // fails
  const Verdict verdict = run.judged();
  EXPECT_EQ(verdict.grade, Grade::kFail);
  std::vector<std::string> figures;
  for (const Reason& reason : verdict.reasons) figures.push_back(reason.figure);
  EXPECT_THAT(figures, testing::ElementsAre("outcome", "slip_max", "coverage_ratio_min",
                                            "overlap_ratio_max"));
}

TEST(Verdict, ObeysTheLimitsItIsGiven) {
  JudgedRun run;
  run.record.peaks.slip.value = 0.25;
  VerdictLimits limits;
  limits.slip_max = {0.3, 0.4};
  EXPECT_EQ(judge(run.path, run.record, run.metrics, limits).grade, Grade::kPass);
  limits.slip_max = {0.1, 0.2};
  EXPECT_EQ(judge(run.path, run.record, run.metrics, limits).grade, Grade::kFail);
}

TEST(Verdict, NamesItsGrades) {
  EXPECT_EQ(grade_name(Grade::kPass), "PASS");
  EXPECT_EQ(grade_name(Grade::kWarn), "WARN");
  EXPECT_EQ(grade_name(Grade::kFail), "FAIL");
}

}  // namespace
}  // namespace headland
