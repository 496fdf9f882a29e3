// The command from end to end, on a tiny field.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

class StagesTest : public CommandTest {};

const std::string kEvaluateTiny = "evaluate tiny.yaml --size 640x400 -o ";

TEST_F(StagesTest, EvaluateFillsTheFolderAndTellsInBothForms) {
  const CommandResult result = headland(kEvaluateTiny + "DIR --json");
  EXPECT_LE(result.exit_code, 1) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(files_in("DIR"),
              UnorderedElementsAre("scenario.yaml", "plan.geojson", "path.geojson", "run.csv",
                                   "footprint.csv", "segments.csv", "metrics.json", "field.png",
                                   "view.png", "energy.png", "report.html"));
  EXPECT_EQ(result.out, text_of(folder_ / "DIR" / "metrics.json"));
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(result.exit_code == 1, json["verdict"]["grade"] == "FAIL");
  EXPECT_EQ(json["outcome"]["name"], "finished");
  EXPECT_GT(json["figures"]["coverage_ratio"].get<double>(), 0.5);
}

TEST_F(StagesTest, SameSeedSameBytesAndStagesGiveTheBytesOfTheWhole) {
  ASSERT_LE(headland(kEvaluateTiny + "A -q").exit_code, 1);
  ASSERT_LE(headland(kEvaluateTiny + "B -q").exit_code, 1);
  const CommandResult plan = headland("plan tiny.yaml -o C -q");
  ASSERT_EQ(plan.exit_code, 0);
  EXPECT_EQ(plan.err, "");
  ASSERT_LE(headland("drive C -q").exit_code, 1);
  ASSERT_EQ(headland("render C --size 640x400 -q").exit_code, 0);
  ASSERT_EQ(headland("report C -q").exit_code, 0);
  for (const std::string& name : files_in("A")) {
    const std::string bytes = text_of(folder_ / "A" / name);
    EXPECT_TRUE(text_of(folder_ / "B" / name) == bytes) << name << " differs from run to run";
    EXPECT_TRUE(text_of(folder_ / "C" / name) == bytes) << name << " differs in stages";
  }
  EXPECT_EQ(files_in("C"), files_in("A"));
}

// A pocket behind a gap of 1 m, which the hull of 1.4 m does not fit through.
TEST_F(StagesTest, PlanTellsWhichPassesAreLeftOut) {
  write("pocket.yaml",
        "field: {boundary: [[0, 0], [14, 0], [14, 8], [14.5, 8], [14.5, 6.5], [17.4, 6.5], "
        "[17.4, 10.5], [14.5, 10.5], [14.5, 9], [14, 9], [14, 14], [0, 14]]}\n"
        "vehicle: transplanter\nplanner: {headland_corners: covered}\n");
  const CommandResult told = headland("plan pocket.yaml -o DIR");
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const CommandResult result = headland("plan pocket.yaml -o DIR --json -q");
  const auto json = nlohmann::json::parse(result.out);
  const auto left_out = json["left_out"];
  bool in_pocket = false;
  double before_m2 = 1e9;
  double sum_m2 = 0.0;
  for (const auto& pass : left_out) {
    const double area_m2 = pass["area_m2"].get<double>();
    EXPECT_LE(area_m2, before_m2) << "the largest comes first";
    before_m2 = area_m2;
    sum_m2 += area_m2;
    const auto index = pass["pass"].get<int>();
    const auto why = pass["why"].get<std::string>();
    EXPECT_THAT(why, HasSubstr(fmt::format("pass {} ", index + 1)));
    EXPECT_THAT(told.out, HasSubstr(fmt::format("{:.1f} m²: {}", area_m2, why)));
    const double y_m = pass["y_m"].get<double>();
    in_pocket = in_pocket || (pass["x_m"].get<double>() > 14.5 && y_m > 6.5 && y_m < 10.5);
  }
  EXPECT_TRUE(in_pocket);
  // Told is no more than is unworked, which is counted in other cells than the passes' areas.
  constexpr double kCellsAlongEdges = 0.1;
  EXPECT_NEAR(json["left_out_m2"].get<double>(), sum_m2, kCellsAlongEdges * sum_m2);
  const auto coverage = json["coverage"];
  EXPECT_NEAR(json["left_out_ratio"].get<double>(),
              json["left_out_m2"].get<double>() / coverage["workable_m2"].get<double>(), 1e-12);
  EXPECT_GT(json["left_out_ratio"].get<double>(), 0.01) << "nothing to warn of";
  EXPECT_GE(coverage["unworked_m2"].get<double>(), json["left_out_m2"].get<double>());
  EXPECT_THAT(told.out, HasSubstr("that cannot be reached or left"));
  EXPECT_THAT(told.out, Not(HasSubstr("keep_off_worked")));
  EXPECT_THAT(told.out, HasSubstr(fmt::format(
                            "{:.2f} %", 100.0 * json["coverage"]["worked_ratio"].get<double>())));
  for (const std::string& err : {told.err, result.err}) {  // neither --json nor -q hides it
    EXPECT_THAT(err, HasSubstr(fmt::format("headland: warning: the plan leaves out {} passes",
                                           left_out.size())));
    EXPECT_THAT(err, HasSubstr("planner.headland_corners: rounded"));
    EXPECT_THAT(err, Not(HasSubstr("headland_edges"))) << "there are none to widen";
    EXPECT_THAT(err, Not(HasSubstr("keep_off_worked"))) << "it is not set";
  }
}

TEST_F(StagesTest, PlanTellsThatWheelsKeptOffRows) {
  write("rows.yaml",
        "field: {boundary: [[0, 0], [14, 0], [14, 8], [14.5, 8], [14.5, 6.5], [17.4, 6.5], "
        "[17.4, 10.5], [14.5, 10.5], [14.5, 9], [14, 9], [14, 14], [0, 14]]}\n"
        "vehicle: transplanter\nplanner: {headland_corners: covered}\n"
        "path: {keep_off_worked: true}\n");
  const CommandResult told = headland("plan rows.yaml -o DIR");
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("over worked rows                   0 m"));
  EXPECT_THAT(told.out, HasSubstr("(path.keep_off_worked) may be why"));
  EXPECT_THAT(told.err, HasSubstr("path.keep_off_worked: false"));
}

TEST_F(StagesTest, AFailingVerdictExitsWith1) {
  write("tiny.yaml", kTinyScenario + "verdict: {reserve_soc_min: {warn: 1, fail: 1}}\n");
  const CommandResult result = headland(kEvaluateTiny + "DIR");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("verdict: FAIL"));
}

TEST_F(StagesTest, DrivesATrackOfAnotherTool) {
  write("track.csv", "x,y\n10,20\n20,20\n30,20\n40,20\n50,20\n");
  const CommandResult result = headland("drive tiny.yaml --path track.csv -o DIR");
  EXPECT_EQ(result.exit_code, 1) << result.err;  // one strip does not cover the field
  EXPECT_THAT(result.out, HasSubstr("track made drivable"));
  EXPECT_THAT(result.out, HasSubstr(", path track.csv, seed 1\n"));
  EXPECT_THAT(result.out, HasSubstr("finished"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR" / "plan.geojson"));
}

TEST_F(StagesTest, APathOfHeadlandIsDrivenAsItIs) {
  ASSERT_LE(headland("plan tiny.yaml -o OURS -q").exit_code, 1);
  ASSERT_LE(headland("drive OURS -q").exit_code, 1);
  ASSERT_LE(headland("drive tiny.yaml --path OURS/path.geojson -o DIR -q").exit_code, 1);
  for (const char* name : {"path.geojson", "run.csv", "footprint.csv", "segments.csv"}) {
    EXPECT_TRUE(text_of(folder_ / "DIR" / name) == text_of(folder_ / "OURS" / name)) << name;
  }
  auto ours = nlohmann::json::parse(text_of(folder_ / "OURS" / "metrics.json"));
  auto again = nlohmann::json::parse(text_of(folder_ / "DIR" / "metrics.json"));
  EXPECT_EQ(ours["scenario"]["planner"], "boustrophedon");
  EXPECT_FALSE(again["scenario"].contains("planner"));
  EXPECT_EQ(again["scenario"]["path"], "path.geojson");
  ours.erase("scenario");
  again.erase("scenario");
  EXPECT_EQ(again, ours);
}

TEST_F(StagesTest, ADamagedPathOfHeadlandIsNotTakenForATrack) {
  ASSERT_EQ(headland("plan tiny.yaml -o OURS -q").exit_code, 0);
  std::string path = text_of(folder_ / "OURS" / "path.geojson");
  path.replace(path.find("\"gear\":\"forward\""), 16, "\"gear\":\"sideway\"");
  write("damaged.geojson", path);
  const CommandResult result = headland("drive tiny.yaml --path damaged.geojson -o DIR");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "headland: damaged.geojson: feature 1: 'sideway': known: forward, reverse\n");
}

TEST_F(StagesTest, WhatWasDrivenIsNamedAndItsScenarioRunsAgain) {
  write("track.csv", "x,y\n10,20\n50,20\n");
  ASSERT_EQ(headland("drive tiny.yaml --path track.csv --tolerance 0.2 -o DIR -q").exit_code, 1);
  const std::string scenario = text_of(folder_ / "DIR" / "scenario.yaml");
  EXPECT_THAT(scenario, HasSubstr("file: " + (folder_ / "track.csv").string() + "\n"));
  EXPECT_THAT(scenario, HasSubstr("tolerance_m: 0.2\n"));
  EXPECT_THAT(scenario, ::testing::Not(HasSubstr("planner")));
  const std::string metrics = text_of(folder_ / "DIR" / "metrics.json");
  EXPECT_EQ(nlohmann::json::parse(metrics)["scenario"]["path"], "track.csv");
  // Driven again from its folder, or all of it from its scenario.
  ASSERT_EQ(headland("drive DIR -q").exit_code, 1);
  EXPECT_EQ(text_of(folder_ / "DIR" / "metrics.json"), metrics);
  write("again.yaml", scenario);
  ASSERT_EQ(headland("evaluate again.yaml -o AGAIN --size 640x400 -q").exit_code, 1);
  EXPECT_EQ(text_of(folder_ / "AGAIN" / "metrics.json"), metrics);
  // The pictures outlive the track.
  std::filesystem::remove(folder_ / "track.csv");
  EXPECT_EQ(headland("render DIR --size 640x400 -q").exit_code, 0);
  EXPECT_TRUE(text_of(folder_ / "DIR" / "field.png") == text_of(folder_ / "AGAIN" / "field.png"));
  const CommandResult gone = headland("evaluate again.yaml -o AGAIN");
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_THAT(gone.err, HasSubstr("track.csv: no such file"));
}

TEST_F(StagesTest, ResultsDoNotReplaceThePathThatIsDriven) {
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  const std::set<std::string> planned = files_in("DIR");
  const CommandResult result = headland("drive tiny.yaml --path DIR/plan.geojson -o DIR");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "headland: DIR/plan.geojson: the results would replace it; give another "
            "folder for them with -o\n");
  EXPECT_EQ(files_in("DIR"), planned);
}

TEST_F(StagesTest, ATrackAndPlanningOptionsLeaveAPlannedFolderAlone) {
  write("track.csv", "x,y\n10,20\n20,20\n30,20\n40,20\n50,20\n");
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  const std::set<std::string> planned = files_in("DIR");
  const std::pair<const char*, const char*> refused[] = {
      {"drive DIR --path track.csv", "-o: a folder for the results is needed"},
      {"drive DIR --seed 3", "--seed: '3': is for planning"},
      {"drive DIR --allow-overrun", "--allow-overrun: is for planning"}};
  for (const auto& [arguments, message] : refused) {
    const CommandResult result = headland(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(files_in("DIR"), planned) << arguments;
  }
  // Negative control: with a track and a folder of its own they are all fine.
  const CommandResult result =
      headland("drive DIR --path track.csv --seed 3 --allow-overrun -o OTHER");
  EXPECT_EQ(result.exit_code, 1) << result.err;  // one strip does not cover the field
  EXPECT_EQ(files_in("DIR"), planned);
}

TEST_F(StagesTest, AFolderInTheWayOfAResultIsToldBeforeAnyWork) {
  std::filesystem::create_directories(folder_ / "DIR" / "metrics.json");
  const CommandResult result = headland(kEvaluateTiny + "DIR");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "headland: DIR/metrics.json: cannot be written: a folder of that name is in the way\n");
  EXPECT_THAT(files_in("DIR"), UnorderedElementsAre("metrics.json"));
}

TEST_F(StagesTest, AMeshThatIsNoneIsToldEverywhereAndTheRunGoesOn) {
  std::filesystem::copy(HEADLAND_SOURCE_DIR "/vehicle_models/transplanter", folder_ / "mine",
                        std::filesystem::copy_options::recursive);
  write("mine/meshes/transplanter.obj", "?");
  write("tiny.yaml", kTinyField + "vehicle: ./mine\n");
  const std::string note =
      "vehicle mine: transplanter.obj cannot be read: plain box in the pictures";
  const CommandResult result = headland(kEvaluateTiny + "DIR");
  EXPECT_LE(result.exit_code, 1);
  EXPECT_EQ(result.err, "headland: " + note + "\n");
  EXPECT_THAT(result.out, HasSubstr("note: " + note + "\n"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "DIR" / "metrics.json"));
  EXPECT_EQ(json["notes"], nlohmann::json::array({note}));
}

TEST_F(StagesTest, ControlCharactersInANameDoNotReachTheTerminal) {
  write("tiny.yaml", kTinyScenario + "name: \"a\\e[31m\\nverdict: PASS\\a\"\n");
  const CommandResult result = headland("plan tiny.yaml -o DIR");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ::testing::StartsWith("a\\x1B[31m\\x0Averdict: PASS\\x07: transplanter"));
}

TEST_F(StagesTest, DamagedResultsAreRefusedWithoutNewOnes) {
  ASSERT_LE(headland(kEvaluateTiny + "DIR -q").exit_code, 1);
  std::string path = text_of(folder_ / "DIR" / "path.geojson");
  const std::size_t heading = path.find("\"heading_rad\":[") + 15;
  path.replace(heading, path.find(',', heading) - heading, "1e300");
  write("DIR/path.geojson", path);
  const CommandResult drive = headland("drive DIR");
  EXPECT_EQ(drive.exit_code, 2);
  EXPECT_EQ(drive.err,
            "headland: DIR/path.geojson: feature 1, point 1: 'heading_rad 1e+300': a heading from "
            "-100 to 100 rad\n");
}

TEST_F(StagesTest, TheListTellsWhatAParameterTakes) {
  EXPECT_THAT(headland("list planners").out, HasSubstr("; auto or a whole number from 1 to 20\n"));
  const auto list = nlohmann::json::parse(headland("list planners --json").out);
  const auto& parameter = list[0]["parameters"][0];
  EXPECT_EQ(parameter["default"], "auto");
  EXPECT_EQ(parameter["whole"], true);
  EXPECT_EQ(parameter["max"], 20.0);
}

TEST_F(StagesTest, ListsAndHelp) {
  for (const char* kind : {"planners", "vehicles", "soils", "generators"}) {
    const CommandResult text = headland(std::string("list ") + kind);
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_NE(text.out, "");
    const auto list = nlohmann::json::parse(headland(std::string("list ") + kind + " --json").out);
    EXPECT_FALSE(list.empty());
  }
  for (const char* command : {"evaluate", "plan", "drive", "render", "list"}) {
    const CommandResult help = headland(std::string(command) + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("Example"));
  }
  EXPECT_THAT(headland("--version").out, HasSubstr("headland "));
}

}  // namespace
}  // namespace headland
