#include "evaluate/plan_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
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

namespace headland {
namespace {

using test::field_on;
using test::kLocal;
using test::kOnEarth;
using test::some_path;
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

class PlanFilesTest : public test::ResultsFolder {};

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

TEST_F(PlanFilesTest, PathComesBackInLocalMetresAndOnTheEarth) {
  const Path path = some_path();
  expect_same_path(read_path(write("a", path_geojson(path, kLocal)), field_on(kLocal)), path,
                   kLocalPlaceTolerance_m);
  expect_same_path(read_path(write("b", path_geojson(path, kOnEarth)), field_on(kOnEarth)), path,
                   kGeoPlaceTolerance_m);
}

// So that a stage that writes what it read changes nothing.
TEST_F(PlanFilesTest, WritingWhatWasReadGivesTheSameBytes) {
  for (const GeoFrame& frame : {kLocal, kOnEarth}) {
    const std::string first = path_geojson(some_path(), frame);
    EXPECT_EQ(path_geojson(read_path(write("a", first), field_on(frame)), frame), first);
  }
}

TEST_F(PlanFilesTest, GeoreferencedCoordinatesAreLongitudeAndLatitude) {
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

TEST_F(PlanFilesTest, TheFrameOfTheLocalMetresIsRecorded) {
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

TEST_F(PlanFilesTest, APlanIsLinesWithKindAndOrder) {
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

TEST_F(PlanFilesTest, RefusesPathsThatAreNone) {
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

}  // namespace
}  // namespace headland
