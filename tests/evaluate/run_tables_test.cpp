#include "evaluate/run_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

#include "evaluate/metrics_file.h"
#include "evaluate/results.h"
#include "evaluate/scenario.h"
#include "evaluate/verdict.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"
#include "tests/evaluate/results_folder.h"
#include "tests/terrains/refusal.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

using test::field_on;
using test::kLocal;
using test::some_path;
using test::some_run;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// `table` with another cell in a line (counted from 1) of a column.
std::string with_cell(const std::string& table, int line, const std::string& column,
                      const std::string& cell) {
  std::stringstream in(table);
  std::stringstream out;
  std::string text;
  std::size_t index = 0;
  for (int number = 1; std::getline(in, text); ++number) {
    std::vector<std::string> cells;
    std::stringstream row(text);
    for (std::string part; std::getline(row, part, ',');) cells.push_back(part);
    if (number == 1) {
      index =
          static_cast<std::size_t>(std::find(cells.begin(), cells.end(), column) - cells.begin());
    }
    if (number == line) cells.at(index) = cell;
    for (std::size_t i = 0; i < cells.size(); ++i) out << (i == 0 ? "" : ",") << cells[i];
    out << "\n";
  }
  return out.str();
}

class RunFilesTest : public test::ResultsFolder {
 protected:
  void SetUp() override {
    ResultsFolder::SetUp();
    const Metrics metrics;
    const Verdict verdict;
    const Field field;
    const auto json =
        metrics_json({Scenario{}, field, vehicle_, path_, run_, metrics, verdict, {}}, "1.2.3");
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
  const auto refused = [&](const std::string& text) {
    return refusal([&] { read_run_csv(write("run.csv", text)); });
  };
  const std::string header = run_csv({}, kLocal);
  EXPECT_THAT(refused(""), HasSubstr("run.csv: line 1: the header line is missing"));
  EXPECT_THAT(refused("time_s\n1\n"), HasSubstr("line 1, travel_m: the column is missing"));
  EXPECT_THAT(refused("time_s," + header), HasSubstr("line 1, time_s: the column stands twice"));
  EXPECT_THAT(refused(header + "1,2\n"), HasSubstr("line 2: '2 cells': the header has 30 columns"));
}

// One damage to a table, and how the refusal ends.
struct Damage {
  std::string table;
  std::string column;
  std::string cell;  // in the third line
  std::string message;
};

TEST_F(RunFilesTest, RefusesDamagedCellsWithLineColumnAndValue) {
  const std::string any = "a number from -1000000000 to 1000000000 is needed";
  const Damage damages[] = {
      {kRunFile, "time_s", "x", "line 3, time_s: 'x': a number from 0 to 1000000000 is needed"},
      {kRunFile, "time_s", "nan", "line 3, time_s: 'nan': a number from 0 to 1000000000 is needed"},
      {kRunFile, "time_s", "-1", "line 3, time_s: '-1': a number from 0 to 1000000000 is needed"},
      {kRunFile, "time_s", "0.25", "line 4, time_s: '0.2': at least 0.25, as in the line before"},
      {kRunFile, "x_m", "nan", "line 3, x_m: 'nan': " + any},
      {kRunFile, "x_m", "1e300", "line 3, x_m: '1e300': " + any},
      {kRunFile, "x_m", "1e6",
       "line 3, x_m, y_m: '1000000, 1': a place within 2000 m of path.geojson beside it"},
      {kRunFile, "slip", "1.5", "line 3, slip: '1.5': a number from 0 to 1 is needed"},
      {kRunFile, "pitch_rad", "inf", "line 3, pitch_rad: 'inf': " + any},
      {kRunFile, "segment", "1e300",
       "line 3, segment: '1e300': a whole number from 0 to 1000000000 is needed"},
      {kRunFile, "segment", "7",
       "line 3, segment: '7': path.geojson beside it has 2 segments: the run belongs to another "
       "path"},
      {kRunFile, "implement_down", "0.5",
       "line 3, implement_down: '0.5': a whole number from 0 to 1 is needed"},
      {kFootprintFile, "left_x_m", "nan", "line 3, left_x_m: 'nan': " + any},
      {kFootprintFile, "right_y_m", "1e8",
       "line 3, right_x_m, right_y_m: '0.5, 1e+08': a place within 2000 m of path.geojson beside "
       "it"},
      {kFootprintFile, "time_s", "9", "line 4, time_s: '1': at least 9, as in the line before"},
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.message);
    const std::string good = read_text(folder_ / damage.table);
    write(damage.table, with_cell(good, 3, damage.column, damage.cell));
    EXPECT_EQ(refusal([&] { read_run(folder_, path_); }),
              (folder_ / damage.table).string() + ": " + damage.message);
    write(damage.table, good);
  }
  EXPECT_NO_THROW(read_run(folder_, path_));
}

TEST_F(RunFilesTest, RefusesARunWithoutRows) {
  write(kRunFile, run_csv({}, kLocal));
  EXPECT_EQ(refusal([&] { read_run(folder_, path_); }),
            (folder_ / kRunFile).string() + ": line 2: the table has no rows");
}

TEST_F(RunFilesTest, ReadsTablesWithLineEndsOfOtherSystems) {
  std::string table;
  for (const char c : read_text(folder_ / kRunFile)) {
    if (c == '\n') table.push_back('\r');
    table.push_back(c);
  }
  write(kRunFile, table);
  EXPECT_EQ(read_run(folder_, path_).samples.size(), run_.samples.size());
}

TEST_F(RunFilesTest, OfARunThatDivergedOnlyWhatIsFiniteIsWritten) {
  RunRecord run = run_;
  run.samples.back().p_WB.x() = std::numeric_limits<double>::quiet_NaN();
  run.footprints.back().left_W.x() = std::numeric_limits<double>::infinity();
  run.segments.back().energy.battery_j = std::numeric_limits<double>::quiet_NaN();
  write(kRunFile, run_csv(run.samples, kLocal));
  write(kFootprintFile, footprint_csv(run.footprints));
  write(kSegmentsFile, segments_csv(path_, run.segments));
  EXPECT_THAT(refusal([&] { read_run(folder_, path_); }), HasSubstr("line 2, battery_j: 'nan'"));
  auto json = parse_json(folder_ / kMetricsFile);
  json["outcome"]["name"] = outcome_name(Outcome::kDiverged);
  write(kMetricsFile, json_text(json));
  const RunRecord read = read_run(folder_, path_);
  EXPECT_EQ(read.samples.size(), run.samples.size() - 1);
  EXPECT_EQ(read.footprints.size(), run.footprints.size() - 1);
  EXPECT_TRUE(std::isnan(read.segments.back().energy.battery_j));
}

TEST_F(RunFilesTest, RefusesSegmentsOfAnotherPath) {
  const std::string table = read_text(folder_ / kSegmentsFile);
  for (const char* index : {"2", "nan", "1e300", "-1e300"}) {
    write(kSegmentsFile, with_cell(table, 2, "segment", index));
    EXPECT_THAT(refusal([&] { read_run(folder_, path_); }),
                HasSubstr(std::string("segments.csv: line 2, segment: '") + index + "'"));
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

TEST_F(RunFilesTest, FiguresAreWrittenAndWhatIsNotFiniteIsNull) {
  Metrics metrics;
  metrics.coverage.covered_m2 = 123.25;
  metrics.u_turns = 7;
  metrics.worst_slip = std::numeric_limits<double>::quiet_NaN();
  metrics.by_kind[3].count = 7;
  metrics.by_kind[3].energy.cause_j[static_cast<std::size_t>(EnergyCause::kMotor)] = 4.5;
  const auto json = parse_json(write("metrics.json", json_text(metrics_json({Scenario{},
                                                                             field_on(kLocal),
                                                                             vehicle_,
                                                                             Path{},
                                                                             RunRecord{},
                                                                             metrics,
                                                                             Verdict{},
                                                                             {"mind the box"}},
                                                                            "1"))));
  EXPECT_EQ(json["figures"]["covered_m2"].get<double>(), 123.25);
  EXPECT_EQ(json["figures"]["u_turns"], 7);
  EXPECT_TRUE(json["figures"]["worst_slip"].is_null());
  EXPECT_EQ(json["by_kind"]["U-turn"]["count"], 7);
  EXPECT_EQ(json["by_kind"]["U-turn"]["energy"][energy_key(EnergyCause::kMotor)].get<double>(),
            4.5);
  EXPECT_EQ(json["notes"][0], "mind the box");
  EXPECT_EQ(json["stability"]["side_stability_angle_rad"].get<double>(),
            side_stability_angle_rad(vehicle_));
  EXPECT_EQ(json["stability"]["nose_up_stability_angle_rad"].get<double>(),
            nose_up_stability_angle_rad(vehicle_));
}

}  // namespace
}  // namespace headland
