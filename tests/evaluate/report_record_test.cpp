#include "evaluate/report_record.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "evaluate/metrics_file.h"
#include "evaluate/plan_file.h"
#include "evaluate/report_assumptions.h"
#include "evaluate/report_movements.h"
#include "evaluate/results.h"
#include "evaluate/run_tables.h"
#include "terrains/json_text.h"
#include "tests/evaluate/results_folder.h"
#include "tests/terrains/refusal.h"

namespace headland::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ReportRecord : public ResultsFolder {
 protected:
  void SetUp() override {
    ResultsFolder::SetUp();
    RunRecord run = some_run();
    run.duration_s = run.samples.back().time_s + 0.05;
    const Metrics metrics = measure_run(path_, run, {});
    const Verdict verdict;
    const Scenario scenario;
    const std::vector<std::string> notes;
    write(kPathFile, path_geojson(path_, kLocal));
    write(kRunFile, run_csv(run.samples, kLocal));
    write(kFootprintFile, footprint_csv(run.footprints));
    write(kSegmentsFile, segments_csv(path_, run.segments));
    write(kMetricsFile,
          json_text(metrics_json({scenario, field_, vehicle_, path_, run, metrics, verdict, notes},
                                 "test")));
  }

  std::string text_of(const char* name) const {
    std::ifstream stream(folder_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const Path path_ = some_path();
  const Field field_ = field_on(kLocal);
};

TEST_F(ReportRecord, AWholeOneIsWhatReadRunReads) {
  const RecordedRun recorded = read_recorded_run(folder_, field_);
  EXPECT_THAT(recorded.missing, ElementsAre());
  const RunRecord run = read_run(folder_, path_);
  EXPECT_EQ(recorded.run.samples.size(), run.samples.size());
  EXPECT_EQ(recorded.run.segments.size(), run.segments.size());
  EXPECT_EQ(recorded.path.segments.size(), path_.segments.size());
  EXPECT_EQ(recorded.metrics["outcome"]["name"], outcome_name(run.outcome));
}

TEST_F(ReportRecord, KeepsTheRowsBeforeACut) {
  const std::string text = text_of(kRunFile);
  ASSERT_GE(some_run().samples.size(), 2U);
  // In the middle of the last row.
  write(kRunFile, text.substr(0, text.rfind('\n', text.size() - 2) + 20));
  const RecordedRun recorded = read_recorded_run(folder_, field_);
  EXPECT_EQ(recorded.run.samples.size(), some_run().samples.size() - 1);
  EXPECT_EQ(recorded.run.segments.size(), some_run().segments.size());
  EXPECT_THAT(recorded.missing, ElementsAre(HasSubstr("The time series ends after")));
  EXPECT_THAT(recorded.missing.front(), HasSubstr("run.csv, line"));
}

// Cut between two rows every table is whole by itself.
TEST_F(ReportRecord, TellsTablesThatAreCutAtTheEndOfARow) {
  RunRecord run = some_run();
  run.samples.clear();
  run.footprints.clear();
  for (int i = 0; i <= 100; ++i) {
    RunSample sample;
    sample.time_s = 0.1 * i;
    sample.travel_m = 0.2 * i;
    sample.implement_down = i < 80;
    run.samples.push_back(sample);
    if (sample.implement_down) {
      run.footprints.push_back(
          {{0.2 * i, 1.0}, {0.2 * i, -1.0}, sample.time_s, sample.travel_m, i == 0});
    }
  }
  run.duration_s = 10.0;
  const Metrics metrics = measure_run(path_, run, {});
  write(kMetricsFile, json_text(metrics_json({Scenario{}, field_, vehicle_, path_, run, metrics,
                                              Verdict{}, std::vector<std::string>{}},
                                             "test")));
  const auto missing_of = [&](std::size_t from, std::size_t samples, std::size_t footprints) {
    const auto begin = run.samples.begin() + static_cast<std::ptrdiff_t>(from);
    write(kRunFile, run_csv({begin, begin + static_cast<std::ptrdiff_t>(samples)}, kLocal));
    write(kFootprintFile,
          footprint_csv({run.footprints.begin(),
                         run.footprints.begin() + static_cast<std::ptrdiff_t>(footprints)}));
    return read_recorded_run(folder_, field_).missing;
  };
  EXPECT_THAT(missing_of(0, 101, 80), ElementsAre());
  EXPECT_THAT(missing_of(0, 50, 80),
              ElementsAre(StartsWith("The time series ends after 4.9 s of")));
  EXPECT_THAT(missing_of(50, 51, 80),
              ElementsAre(StartsWith("The time series begins after 5.0 s")));
  EXPECT_THAT(missing_of(0, 101, 40),
              ElementsAre(StartsWith("Ground covered is known for 7.8 m of 15.8 m")));
  EXPECT_THAT(missing_of(0, 101, 0), ElementsAre(StartsWith("Ground covered is known for 0.0 m")));
}

TEST_F(ReportRecord, TellsEveryFileThatIsGone) {
  for (const char* name : {kPathFile, kRunFile, kFootprintFile, kSegmentsFile}) {
    fs::remove(folder_ / name);
  }
  const RecordedRun recorded = read_recorded_run(folder_, field_);
  EXPECT_THAT(
      recorded.missing,
      ElementsAre(StartsWith("The planned path is missing (path.geojson"),
                  StartsWith("The time series is missing (run.csv"),
                  StartsWith("Ground covered is known in part at most (footprint.csv"),
                  StartsWith("Costs of movements are known in part at most (segments.csv")));
  EXPECT_FALSE(recorded.metrics.is_null());
}

TEST_F(ReportRecord, OfAnotherPathPointsNowhere) {
  Path shorter = path_;
  shorter.segments.resize(1);
  write(kPathFile, path_geojson(shorter, kLocal));
  const RecordedRun recorded = read_recorded_run(folder_, field_);
  EXPECT_FALSE(recorded.missing.empty());
  for (const SegmentRecord& record : recorded.run.segments) EXPECT_EQ(record.segment, 0);
}

TEST_F(ReportRecord, WithoutAnyRunIsRefused) {
  fs::remove(folder_ / kRunFile);
  fs::remove(folder_ / kMetricsFile);
  EXPECT_THAT(refusal([&] { read_recorded_run(folder_, field_); }),
              HasSubstr("metrics.json: no such file: 'headland drive'"));
}

TEST(Movements, AddUpToTheirSegments) {
  Path path = some_path();
  path.segments.push_back(path.segments.back());  // a second piece of the U-turn
  std::vector<SegmentRecord> records(3);
  for (int i = 0; i < 3; ++i) {
    SegmentRecord& record = records[static_cast<std::size_t>(i)];
    record.segment = i;
    record.start_time_s = 10.0 * i;
    record.duration_s = 5.0;
    record.distance_m = 2.0;
    record.energy.battery_j = 3600.0 * (i + 1);
    record.cross_track_sum_m3 = 2.0 * 0.01 * i;  // rms 0.1 sqrt(i)
    record.peak_power_w = 100.0 * i;
  }
  const std::vector<Movement> movements = movements_of(path, records);
  ASSERT_EQ(movements.size(), 2U);
  EXPECT_EQ(movements[0].kind, PathKind::kSwath);
  EXPECT_EQ(movements[0].energy_wh, 1.0);
  EXPECT_EQ(movements[1].kind, PathKind::kUTurn);
  EXPECT_EQ(movements[1].start_time_s, 10.0);
  EXPECT_EQ(movements[1].duration_s, 10.0);
  EXPECT_EQ(movements[1].energy_wh, 5.0);
  EXPECT_EQ(movements[1].peak_power_w, 200.0);
  EXPECT_EQ(movements[1].reverses, 2);
  EXPECT_DOUBLE_EQ(movements[1].track_rms_m, std::sqrt(0.06 / 4.0));
}

class Assumptions : public ResultsFolder {};

TEST_F(Assumptions, AreThoseOfTheFileInItsOrder) {
  const fs::path file =
      write("drive.yaml",
            "a: {value: 3, source: \"assumed: a guess\"}\n"
            "b: {c: {value: [1, 2], source: assumed}, d: {value: 4, source: book}}\n"
            "e: plain\n");
  const std::vector<Assumption> found = assumptions_of(file);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].key, "a");
  EXPECT_EQ(found[0].value, "3");
  EXPECT_EQ(found[0].why, "a guess");
  EXPECT_EQ(found[1].key, "b.c");
  EXPECT_EQ(found[1].value, "[1, 2]");
  EXPECT_EQ(found[1].why, "");
  EXPECT_TRUE(assumptions_of(folder_ / "none.yaml").empty());
  EXPECT_FALSE(assumptions_of(vehicle_.folder / "drive.yaml").empty());
}

}  // namespace
}  // namespace headland::test
