#include "evaluate/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include "evaluate/atomic_file.h"
#include "evaluate/metrics_file.h"
#include "evaluate/plan_file.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"
#include "tests/terrains/refusal.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

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

  std::set<std::string> names_in_folder() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  const Vehicle vehicle_ = load_vehicle("transplanter");
  const fs::path folder_ = fs::path(::testing::TempDir()) /
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

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

Field field_on(const GeoFrame& frame) {
  Field field;
  field.name = "square";
  field.boundary = {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}};
  field.frame = frame;
  return field;
}

// The point a step [m] along a circle after `from`, headings within (-pi, pi].
PathPoint next_on_circle(const PathPoint& from, double step_m, double curvature_per_m) {
  const double turn_rad = step_m * curvature_per_m;
  const double along_rad = from.heading_rad + 0.5 * turn_rad;
  return {from.p_W + step_m * Eigen::Vector2d(std::cos(along_rad), std::sin(along_rad)),
          std::remainder(from.heading_rad + turn_rad, 2.0 * std::numbers::pi), curvature_per_m};
}

Path some_path() {
  Path path;
  PathSegment swath{PathKind::kSwath, Gear::kForward, true, 0, {}};
  swath.points = {{{-12.3456789, 7.0}, 3.123456789012, 0.25}};
  for (int i = 0; i < 2; ++i) {
    swath.points.push_back(next_on_circle(swath.points.back(), 0.25, 0.25));
  }
  PathSegment turn{PathKind::kUTurn, Gear::kReverse, false, 1, {}};
  turn.points = {swath.points.back(), next_on_circle(swath.points.back(), -0.5, -0.25)};
  path.segments = {swath, turn};
  path.violations = {{{-12.0, 7.0}, 1, 0.375, "hull beyond the boundary"}};
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
  expect_same_path(read_path(write("a", path_geojson(path, kLocal)), field_on(kLocal)), path,
                   kLocalPlaceTolerance_m);
  expect_same_path(read_path(write("b", path_geojson(path, kOnEarth)), field_on(kOnEarth)), path,
                   kGeoPlaceTolerance_m);
}

// So that a stage that writes what it read changes nothing.
TEST_F(ResultsTest, WritingWhatWasReadGivesTheSameBytes) {
  for (const GeoFrame& frame : {kLocal, kOnEarth}) {
    const std::string first = path_geojson(some_path(), frame);
    EXPECT_EQ(path_geojson(read_path(write("a", first), field_on(frame)), frame), first);
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
  EXPECT_NEAR(json["features"][1]["properties"]["length_m"].get<double>(), 0.5, 1e-3);
}

TEST_F(ResultsTest, TheFrameOfTheLocalMetresIsRecorded) {
  Field field;
  field.frame = kOnEarth;
  const auto metrics = metrics_json(
      {Scenario{}, field, vehicle_, Path{}, RunRecord{}, Metrics{}, Verdict{}, {}}, "1");
  const auto path = parse_json(write("a", path_geojson(some_path(), kOnEarth)));
  for (const auto& frame : {metrics["frame"], path["headland"]["frame"]}) {
    EXPECT_EQ(frame["longitude_deg"].get<double>(), kOnEarth.longitude_deg);
    EXPECT_EQ(frame["latitude_deg"].get<double>(), kOnEarth.latitude_deg);
    EXPECT_EQ(frame["proj"].get<std::string>(), proj_of(kOnEarth));
  }
  const auto local = parse_json(write("b", path_geojson(some_path(), kLocal)));
  EXPECT_TRUE(local["headland"].at("frame").is_null());
}

TEST_F(ResultsTest, APlanIsLinesWithKindAndOrder) {
  Plan plan;
  plan.planner = "boustrophedon";
  plan.swath_direction_rad = 0.75;
  plan.headland_width_m = 6.0;
  plan.passes = {{PassKind::kSwath, {{0, 0}, {10, 0}}},
                 {PassKind::kHeadlandPass, {{0, 1}, {10, 1}, {10, 5}}}};
  const auto json = parse_json(write("plan", plan_geojson(plan, kLocal)));
  EXPECT_EQ(json["headland"]["planner"], "boustrophedon");
  EXPECT_EQ(json["headland"]["swath_direction_rad"].get<double>(), 0.75);
  ASSERT_EQ(json["features"].size(), 2U);
  const auto& second = json["features"][1];
  EXPECT_EQ(second["properties"]["kind"], "headland pass");
  EXPECT_EQ(second["properties"]["order"], 2);
  EXPECT_EQ(second["properties"]["length_m"].get<double>(), 14.0);
  EXPECT_EQ(second["geometry"]["coordinates"][2][1].get<double>(), 5.0);
}

TEST_F(ResultsTest, RefusesPathsThatAreNone) {
  const std::string good = path_geojson(some_path(), kLocal);
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    const fs::path file = write("path.geojson", bad);
    return refusal([&] { read_path(file, field_on(kLocal)); });
  };
  EXPECT_THAT(refused("\"swath\"", "\"swat\""), AllOf(HasSubstr("feature 1"), HasSubstr("swat")));
  EXPECT_THAT(refused("\"reverse\"", "\"back\""),
              HasSubstr("path.geojson: feature 2: 'back': known: forward, reverse"));
  EXPECT_THAT(refused("\"heading_rad\":[", "\"heading_rad\":[0.0,"), HasSubstr("3 numbers"));
  EXPECT_THAT(refused("\"manoeuvre\":0", "\"manoeuvre\":-7"), HasSubstr("a count from 0"));
  EXPECT_THAT(refused("\"manoeuvre\":0", "\"manoeuvre\":1.5"),
              HasSubstr("path.geojson: feature 1: 'manoeuvre 1.5': a count from 0 is needed"));
  EXPECT_THAT(refused("\"manoeuvre\":0", "\"m\":0"),
              HasSubstr("path.geojson: feature 1: 'manoeuvre': the property is missing"));
  EXPECT_THAT(refused("\"LineString\"", "\"Polygon\""), HasSubstr("Polygon"));
  EXPECT_THAT(refused("\n]}", "\n]"), AllOf(HasSubstr("line "), HasSubstr("malformed JSON")));
  EXPECT_THAT(refused("\"manoeuvre\":0", "\"manoeuvre\":1e999"),
              AllOf(HasSubstr("malformed JSON"), HasSubstr("1e999")));
  EXPECT_THAT(refused("local metres", "furlongs"), HasSubstr("furlongs"));
  EXPECT_THAT([&] { read_path(write("a", path_geojson(some_path(), kOnEarth)), field_on(kLocal)); },
              ThrowsMessage<InputError>(HasSubstr("headland.coordinates")));
  EXPECT_THAT([&] { read_path(write("a", path_geojson({}, kLocal)), field_on(kLocal)); },
              ThrowsMessage<InputError>(HasSubstr("no path segment")));
  EXPECT_THROW(read_path(folder_ / "none", field_on(kLocal)), InputError);
}

class RunFilesTest : public ResultsTest {
 protected:
  void SetUp() override {
    ResultsTest::SetUp();
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

TEST_F(ResultsTest, FiguresAreWrittenAndWhatIsNotFiniteIsNull) {
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

TEST_F(ResultsTest, AFolderInTheWayOfOneFileLeavesAllAsTheyWere) {
  write("a", "old");
  fs::create_directory(folder_ / "b");
  EXPECT_EQ(refusal([&] {
              write_together(folder_, {{"a", "new"}, {"b", "new"}, {"c", "new"}});
            }),
            (folder_ / "b").string() + ": cannot be written: a folder of that name is in the way");
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(names_in_folder(), (std::set<std::string>{"a", "b"}));
}

TEST_F(ResultsTest, FilesAlreadyReplacedArePutBackWhenALaterOneFails) {
  write("a", "old");
  // Written and then gone: the same partial name twice, so that the second renaming finds nothing.
  EXPECT_THAT(refusal([&] {
                write_together(folder_, {{"a", "new"}, {"n", "new"}, {"n", "new"}});
              }),
              HasSubstr("/n: cannot be written: No such file"));
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(names_in_folder(), (std::set<std::string>{"a"}));
}

TEST_F(ResultsTest, FoldersMadeForNothingGoAgain) {
  EXPECT_THAT(refusal([&] {
                write_together(folder_ / "x" / "y", {{"n", "new"}, {"n", "new"}});
              }),
              HasSubstr("cannot be written"));
  EXPECT_TRUE(names_in_folder().empty());
}

TEST_F(ResultsTest, AFolderUnderTheNameOfAResultIsRefusedBeforeAnyWork) {
  fs::create_directory(folder_ / kMetricsFile);
  EXPECT_EQ(refusal([&] { check_results_folder(folder_); }),
            (folder_ / kMetricsFile).string() +
                ": cannot be written: a folder of that name is in the way");
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
