#include "evaluate/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "evaluate/atomic_file.h"
#include "evaluate/json_text.h"
#include "evaluate/metrics_file.h"
#include "evaluate/plan_file.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// 1e-10 deg of latitude is 11 um; rounding moves a point by half of that in each axis.
constexpr double kGeoPlaceTolerance_m = 2e-5;
// Local metres are written with 6 decimals.
constexpr double kLocalPlaceTolerance_m = 1e-6;
// Headings and curvatures are written with 9 decimals.
constexpr double kAngleTolerance = 1e-9;

const GeoFrame kLocal;
const GeoFrame kOnEarth{true, 43.9241, -93.9751};

class ResultsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    write_together(folder_, {{name, text}});
    return folder_ / name;
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) /
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

Path some_path() {
  Path path;
  PathSegment swath{PathKind::kSwath, Gear::kForward, true, 0, {}};
  swath.points = {{{-12.3456789, 7.0}, 0.123456789012, 0.0},
                  {{100.1, 7.5}, -3.1, 0.25},
                  {{400.0, -250.0}, 3.1, -0.25}};
  PathSegment turn{PathKind::kUTurn, Gear::kReverse, false, 1, {}};
  turn.points = {swath.points.back(), {{401.0, -250.0}, 3.0, 0.5}};
  path.segments = {swath, turn};
  path.violations = {{{401.0, -250.0}, 1, 0.375, "hull beyond the boundary"}};
  return path;
}

RunRecord some_run() {
  RunRecord run;
  run.outcome = Outcome::kStuck;
  run.outcome_detail = "wheels spin, at \"a\" place";
  run.duration_s = 12.5;
  run.distance_m = 8.25;
  run.soc_end = 0.9375;
  run.energy.battery_j = 1234.5678;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) run.energy.cause_j[i] = 0.5 + double(i);
  run.peaks.slip = {0.75, 3.25, {1.5, -2.5}};
  run.peaks.belly_contacts = 3;
  run.peaks.motor_clipped_s = 1.75;
  for (int i = 0; i < 3; ++i) {
    RunSample sample;
    sample.time_s = 0.1 * i;
    sample.p_WB = {0.5 * i, 1.0, 0.25};
    sample.wheel_load_n = {1000.5, 2000.0, 3000.0, 4000.0};
    sample.segment = i / 2;
    sample.implement_down = i < 2;
    run.samples.push_back(sample);
    run.footprints.push_back({{0.5 * i, 1.0}, {0.5 * i, -1.0}, 0.5 * i, 0.25 * i, i == 0});
  }
  SegmentRecord segment;
  segment.segment = 1;
  segment.duration_s = 4.0;
  segment.distance_m = 2.0;
  segment.energy = run.energy;
  segment.cross_track_sum_m3 = 0.02;  // 0.1 m rms over 2 m
  run.segments = {segment};
  return run;
}

void expect_same_path(const Path& read, const Path& path, double tolerance_m) {
  ASSERT_EQ(read.segments.size(), path.segments.size());
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    EXPECT_EQ(read.segments[i].kind, path.segments[i].kind);
    EXPECT_EQ(read.segments[i].gear, path.segments[i].gear);
    EXPECT_EQ(read.segments[i].implement_down, path.segments[i].implement_down);
    EXPECT_EQ(read.segments[i].manoeuvre, path.segments[i].manoeuvre);
    ASSERT_EQ(read.segments[i].points.size(), path.segments[i].points.size());
    for (std::size_t j = 0; j < path.segments[i].points.size(); ++j) {
      const PathPoint& point = path.segments[i].points[j];
      const PathPoint& point_read = read.segments[i].points[j];
      EXPECT_LT((point_read.p_W - point.p_W).norm(), tolerance_m);
      EXPECT_NEAR(point_read.heading_rad, point.heading_rad, kAngleTolerance);
      EXPECT_NEAR(point_read.curvature_per_m, point.curvature_per_m, kAngleTolerance);
    }
  }
  ASSERT_EQ(read.violations.size(), path.violations.size());
  EXPECT_EQ(read.violations[0].what, path.violations[0].what);
  EXPECT_EQ(read.violations[0].overrun_m, path.violations[0].overrun_m);
}

TEST_F(ResultsTest, PathComesBackInLocalMetresAndOnTheEarth) {
  const Path path = some_path();
  expect_same_path(read_path(write("a", path_geojson(path, kLocal)), kLocal), path,
                   kLocalPlaceTolerance_m);
  expect_same_path(read_path(write("b", path_geojson(path, kOnEarth)), kOnEarth), path,
                   kGeoPlaceTolerance_m);
}

// So that a stage that writes what it read changes nothing.
TEST_F(ResultsTest, WritingWhatWasReadGivesTheSameBytes) {
  for (const GeoFrame& frame : {kLocal, kOnEarth}) {
    const std::string first = path_geojson(some_path(), frame);
    EXPECT_EQ(path_geojson(read_path(write("a", first), frame), frame), first);
  }
}

TEST_F(ResultsTest, GeoreferencedCoordinatesAreLongitudeAndLatitude) {
  Path path = some_path();
  path.segments[0].points[0].p_W.setZero();
  const auto json = parse_json(write("a", path_geojson(path, kOnEarth)));
  const auto first = json["features"][0]["geometry"]["coordinates"][0];
  EXPECT_NEAR(first[0].get<double>(), kOnEarth.longitude_deg, 1e-9);
  EXPECT_NEAR(first[1].get<double>(), kOnEarth.latitude_deg, 1e-9);
  EXPECT_EQ(json["features"][1]["properties"]["kind"], "U-turn");
  EXPECT_EQ(json["features"][1]["properties"]["gear"], "reverse");
  EXPECT_NEAR(json["features"][1]["properties"]["length_m"].get<double>(), 1.0, 1e-3);
}

TEST_F(ResultsTest, TheFrameOfTheLocalMetresIsRecorded) {
  Field field;
  field.frame = kOnEarth;
  const auto metrics =
      metrics_json({Scenario{}, field, Path{}, RunRecord{}, Metrics{}, Verdict{}}, "1");
  const auto path = parse_json(write("a", path_geojson(some_path(), kOnEarth)));
  for (const auto& frame : {metrics["frame"], path["headland"]["frame"]}) {
    EXPECT_EQ(frame["longitude_deg"].get<double>(), kOnEarth.longitude_deg);
    EXPECT_EQ(frame["latitude_deg"].get<double>(), kOnEarth.latitude_deg);
    EXPECT_EQ(frame["proj"].get<std::string>(), proj_of(kOnEarth));
  }
  const auto local = parse_json(write("b", path_geojson(some_path(), kLocal)));
  EXPECT_TRUE(local["headland"].at("frame").is_null());
}

TEST_F(ResultsTest, PlanComesBack) {
  Plan plan;
  plan.planner = "boustrophedon";
  plan.swath_direction_rad = 0.75;
  plan.headland_width_m = 6.0;
  plan.planned_length_m = 123.0;
  plan.passes = {{PassKind::kSwath, {{0, 0}, {10, 0}}},
                 {PassKind::kHeadlandPass, {{0, 1}, {10, 1}, {10, 5}}}};
  const Plan read = read_plan(write("plan", plan_geojson(plan, kLocal)), kLocal);
  EXPECT_EQ(read.planner, plan.planner);
  EXPECT_EQ(read.swath_direction_rad, plan.swath_direction_rad);
  EXPECT_EQ(read.headland_width_m, plan.headland_width_m);
  EXPECT_EQ(read.planned_length_m, plan.planned_length_m);
  ASSERT_EQ(read.passes.size(), 2U);
  EXPECT_EQ(read.passes[1].kind, PassKind::kHeadlandPass);
  EXPECT_EQ(read.passes[1].points_W, plan.passes[1].points_W);
}

TEST_F(ResultsTest, RefusesPathsThatAreNone) {
  const std::string good = path_geojson(some_path(), kLocal);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    const fs::path file = write("path.geojson", bad);
    try {
      read_path(file, kLocal);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("(accepted)");
  };
  EXPECT_THAT(refusal("\"swath\"", "\"swat\""), AllOf(HasSubstr("feature 1"), HasSubstr("swat")));
  EXPECT_THAT(refusal("\"reverse\"", "\"back\""), HasSubstr("feature 2"));
  EXPECT_THAT(refusal("\"heading_rad\":[", "\"heading_rad\":[0.0,"), HasSubstr("3 numbers"));
  EXPECT_THAT(refusal("\"manoeuvre\":0", "\"manoeuvre\":-7"), HasSubstr("a count from 0"));
  EXPECT_THAT(refusal("\"manoeuvre\":0", "\"m\":0"), HasSubstr("missing"));
  EXPECT_THAT(refusal("\"LineString\"", "\"Polygon\""), HasSubstr("Polygon"));
  EXPECT_THAT(refusal("\n]}", "\n]"), AllOf(HasSubstr("line "), HasSubstr("malformed JSON")));
  EXPECT_THAT(refusal("\"manoeuvre\":0", "\"manoeuvre\":1e999"),
              AllOf(HasSubstr("malformed JSON"), HasSubstr("1e999")));
  EXPECT_THAT(refusal("local metres", "furlongs"), HasSubstr("furlongs"));
  EXPECT_THAT([&] { read_path(write("a", path_geojson(some_path(), kOnEarth)), kLocal); },
              ThrowsMessage<InputError>(HasSubstr("headland.coordinates")));
  EXPECT_THAT([&] { read_path(write("a", path_geojson({}, kLocal)), kLocal); },
              ThrowsMessage<InputError>(HasSubstr("no path segment")));
  EXPECT_THROW(read_path(folder_ / "none", kLocal), InputError);
}

class RunFilesTest : public ResultsTest {
 protected:
  void SetUp() override {
    ResultsTest::SetUp();
    const Metrics metrics;
    const Verdict verdict;
    const Field field;
    const auto json = metrics_json({Scenario{}, field, path_, run_, metrics, verdict}, "1.2.3");
    write(kMetricsFile, json_text(json, 2));
    write(kRunFile, run_csv(run_.samples, kLocal));
    write(kFootprintFile, footprint_csv(run_.footprints));
    write(kSegmentsFile, segments_csv(path_, run_.segments));
  }

  const Path path_ = some_path();
  const RunRecord run_ = some_run();
};

// The values of some_run() have no more decimals than the files.
TEST_F(RunFilesTest, AWholeRunComesBack) {
  const RunRecord read = read_run(folder_, path_);
  EXPECT_EQ(read.outcome, run_.outcome);
  EXPECT_EQ(read.outcome_detail, run_.outcome_detail);
  EXPECT_EQ(read.duration_s, run_.duration_s);
  EXPECT_EQ(read.soc_end, run_.soc_end);
  EXPECT_EQ(read.energy.battery_j, run_.energy.battery_j);
  EXPECT_EQ(read.energy.cause_j, run_.energy.cause_j);
  EXPECT_EQ(read.peaks.slip.value, run_.peaks.slip.value);
  EXPECT_EQ(read.peaks.slip.p_W, run_.peaks.slip.p_W);
  EXPECT_EQ(read.peaks.belly_contacts, run_.peaks.belly_contacts);
  EXPECT_EQ(read.peaks.motor_clipped_s, run_.peaks.motor_clipped_s);
  ASSERT_EQ(read.samples.size(), run_.samples.size());
  EXPECT_EQ(read.samples[1].p_WB, run_.samples[1].p_WB);
  EXPECT_EQ(read.samples[2].wheel_load_n, run_.samples[2].wheel_load_n);
  EXPECT_EQ(read.samples[2].segment, 1);
  EXPECT_TRUE(read.samples[1].implement_down);
  EXPECT_FALSE(read.samples[2].implement_down);
  ASSERT_EQ(read.footprints.size(), run_.footprints.size());
  EXPECT_EQ(read.footprints[2].right_W, run_.footprints[2].right_W);
  EXPECT_TRUE(read.footprints[0].starts_strip);
  EXPECT_FALSE(read.footprints[1].starts_strip);
  ASSERT_EQ(read.segments.size(), 1U);
  EXPECT_EQ(read.segments[0].segment, 1);
  EXPECT_EQ(read.segments[0].energy.cause_j, run_.energy.cause_j);
  // Its root is written with 6 decimals, about 0.1 m here: 0.1 +- 5e-7, squared, times 2 m.
  EXPECT_NEAR(read.segments[0].cross_track_sum_m3, 0.02, 3e-7);
}

TEST_F(RunFilesTest, RefusesTablesThatAreNone) {
  const std::string header = run_csv({}, kLocal);
  EXPECT_THAT([&] { read_run_csv(write("a", "")); },
              ThrowsMessage<InputError>(HasSubstr("header")));
  EXPECT_THAT([&] { read_run_csv(write("a", "time_s\n1\n")); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 1"), HasSubstr("missing"))));
  EXPECT_THAT([&] { read_run_csv(write("a", header + "1,2\n")); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 2"), HasSubstr("2 cells"))));
  std::string bad = run_csv(run_.samples, kLocal);
  bad.replace(bad.find("\n") + 1, 1, "x");
  EXPECT_THAT([&] { read_run_csv(write("a", bad)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 2"), HasSubstr("'time_s'"))));
}

TEST_F(RunFilesTest, RefusesARunOfAnotherPath) {
  Path shorter = path_;
  shorter.segments.pop_back();
  EXPECT_THAT([&] { read_run(folder_, shorter); },
              ThrowsMessage<InputError>(HasSubstr("another path")));
}

TEST_F(RunFilesTest, RefusesSegmentsThatAreNoIndex) {
  const std::string table = read_text(folder_ / kSegmentsFile);
  const std::size_t row = table.find('\n') + 1;
  for (const char* index : {"nan", "1e300", "-1e300"}) {
    std::string bad = table;
    write(kSegmentsFile, bad.replace(row, bad.find(',', row) - row, index));
    EXPECT_THAT([&] { read_run(folder_, path_); },
                ThrowsMessage<InputError>(HasSubstr("another path")))
        << index;
  }
}

TEST_F(RunFilesTest, RefusesMetricsWithoutAKey) {
  auto json = parse_json(folder_ / kMetricsFile);
  json["peaks"].erase("slip");
  write(kMetricsFile, json_text(json));
  EXPECT_THAT([&] { read_run(folder_, path_); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("peaks.slip"), HasSubstr("missing"))));
  json["outcome"]["name"] = "vanished";
  write(kMetricsFile, json_text(json));
  EXPECT_THAT([&] { read_run(folder_, path_); }, ThrowsMessage<InputError>(HasSubstr("vanished")));
}

TEST_F(RunFilesTest, EveryColumnStandsInTheDocumentation) {
  const std::string page = read_text(fs::path(HEADLAND_SOURCE_DIR) / "docs/results.md");
  for (const std::string& column : run_columns()) {
    EXPECT_THAT(page, HasSubstr("`" + column + "`"));
  }
}

TEST_F(ResultsTest, FiguresComeBackAndWhatIsNotFiniteIsNull) {
  Metrics metrics;
  metrics.coverage.covered_m2 = 123.25;
  metrics.u_turns = 7;
  metrics.worst_slip = std::numeric_limits<double>::quiet_NaN();
  metrics.by_kind[3].count = 7;
  metrics.by_kind[3].energy.cause_j[2] = 4.5;
  const Field field;
  const auto json = metrics_json({Scenario{}, field, Path{}, RunRecord{}, metrics, Verdict{}}, "1");
  const Metrics read = read_metrics(write("metrics.json", json_text(json)));
  EXPECT_EQ(read.coverage.covered_m2, 123.25);
  EXPECT_EQ(read.u_turns, 7);
  EXPECT_TRUE(std::isnan(read.worst_slip));
  EXPECT_EQ(read.by_kind[3].count, 7);
  EXPECT_EQ(read.by_kind[3].energy.cause_j[2], 4.5);
}

TEST_F(ResultsTest, AFullDiskLeavesTheOldFilesAndNothingHalfWritten) {
  write("a", "old");
  // The temporary name of the second file leads to a device that is always full.
  fs::create_symlink("/dev/full", folder_ / ".b.partial");
  EXPECT_THAT(
      [&] {
        write_together(folder_, {{"a", "new"}, {"b", "new"}});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("b"), HasSubstr("No space left"))));
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ResultsTest, FoldersThatCannotBeAreRefused) {
  write("file", "x");
  EXPECT_THAT([&] { check_output_folder(folder_ / "file"); },
              ThrowsMessage<InputError>(HasSubstr("is not a folder")));
  EXPECT_THAT([&] { check_output_folder(folder_ / "file" / "below"); },
              ThrowsMessage<InputError>(HasSubstr("is not a folder")));
  EXPECT_THAT(
      [&] {
        write_together(folder_ / "file", {{"a", "x"}});
      },
      ThrowsMessage<InputError>(HasSubstr("file")));
  EXPECT_NO_THROW(check_output_folder(folder_ / "new" / "below"));
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

TEST_F(ResultsTest, DoingAStageAgainRemovesWhatFollowed) {
  for (const char* name : {kPathFile, kRunFile, kMetricsFile, kViewPicture, "notes.txt"}) {
    write(name, "x");
  }
  remove_results_from(folder_, kRunFile);
  EXPECT_TRUE(fs::exists(folder_ / kPathFile));
  EXPECT_FALSE(fs::exists(folder_ / kRunFile));
  EXPECT_FALSE(fs::exists(folder_ / kMetricsFile));
  EXPECT_FALSE(fs::exists(folder_ / kViewPicture));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

}  // namespace
}  // namespace headland
