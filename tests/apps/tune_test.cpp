// headland tune and the weights it writes, by the real program.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/evaluate/made_up_costs.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

const std::string kTraining = "training: {fields: {square: {grid_map: square.txt}}}\n";
const std::string kHeldOut = "held_out: {fields: {hook: {grid_map: hook.txt}}}\n";

class TuneCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write("square.txt", "....\n....\n....\n");
    write("hook.txt", "....\n.#..\n....\n");
    write("tune.yaml", "vehicle: transplanter\n" + kTraining + kHeldOut);
  }
  std::string said(const std::string& arguments) const {
    const CommandResult result = headland(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  }
};

TEST_F(TuneCommandTest, RefusesInOneLineAndWritesNothing) {
  write("alone.yaml", "vehicle: transplanter\n" + kTraining);
  EXPECT_THAT(said("tune alone.yaml -o out"), HasSubstr("alone.yaml: line 1: held_out: missing"));
  EXPECT_THAT(said("tune tune.yaml -o out --jobs 0"), HasSubstr("--jobs: '0'"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  EXPECT_THAT(said("tune tune.yaml -o out --store square.txt"),
              HasSubstr("square.txt: not a store of runs"));
}

TEST_F(TuneCommandTest, TunesAndPlansByWhatCameOut) {
  const std::string terrain =
      "  terrains: {hill: {generator: rolling, amplitude_m: 0.5, wavelength_m: 30, cell_m: 1}}\n";
  write("costs.yaml", cost_table_yaml(made_up_table()));
  write("small.yaml",
        "vehicle: transplanter\ncosts: costs.yaml\nforms: [tractor, measured]\n"
        "planner: {name: grid_local_search, stop: {iterations: 3}}\n"
        "plans: {planners: [grid_boustrophedon, grid_local_search], variations: 4, iterations: 3}\n"
        "bootstrap: 100\nshuffles: 1\nsimulation: {rate_hz: 60, record_hz: 1}\n"
        "coverage: {cell_m: 1}\n"
        "training:\n  fields: {square: {grid_map: square.txt}}\n" +
            terrain + "held_out:\n  fields: {hook: {grid_map: hook.txt}}\n" + terrain);
  const CommandResult tuned = headland("tune small.yaml -o out");
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  EXPECT_THAT(tuned.out, HasSubstr("figures, pictures and report.html are in out"));
  // One held-out field tells no interval.
  EXPECT_THAT(tuned.out, HasSubstr("±- p 1"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "out/tune.json"));
  EXPECT_EQ(json["best"], "Wang et al. fitted");
  EXPECT_EQ(json["held_out"]["without_figures"], 0);
  ASSERT_GE(json["pictures"].size(), 4U);
  for (const std::string name : json["pictures"]) {
    EXPECT_GT(text_of(folder_ / "out" / name).size(), 1000U) << name;
  }
  EXPECT_EQ(json["vehicle"], "transplanter");
  EXPECT_EQ(json["spec"]["file"], "small.yaml");
  const std::string page = text_of(folder_ / "out/report.html");
  EXPECT_THAT(page, HasSubstr("data-picture=\"plans_most_saved.png\""));
  ASSERT_EQ(headland("report out -q").exit_code, 0);
  EXPECT_TRUE(text_of(folder_ / "out/report.html") == page);
  // What the kinds of movement are told to take is all that is told.
  for (const auto& plan : json["held_out_plans"]) {
    double sum_wh = 0.0;
    for (const auto& [kind, wh] : plan["predicted_kind_wh"].items()) sum_wh += wh.get<double>();
    EXPECT_NEAR(sum_wh, plan["predicted_wh"].get<double>(), 1e-6) << plan["method"];
  }
  write("map.yaml",
        "vehicle: transplanter\nfield: {grid_map: hook.txt}\n"
        "planner: {name: grid_local_search, stop: {iterations: 3}}\n");
  const CommandResult planned = headland("plan map.yaml --weights out/weights.yaml -o plan");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(text_of(folder_ / "plan/scenario.yaml"), HasSubstr("objective: tractor"));
}

TEST_F(TuneCommandTest, PlansByWeights) {
  write("weights.yaml", "cost: {objective: weighted, repeat: 1, turn: 2, u_turn: 4}\n");
  write(
      "map.yaml",
      "vehicle: transplanter\nfield: {grid_map: hook.txt}\nplanner: {name: grid_boustrophedon}\n");
  const CommandResult planned = headland("plan map.yaml --weights weights.yaml -o out");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(text_of(folder_ / "out/scenario.yaml"), HasSubstr("u_turn: 4"));
  EXPECT_THAT(said("plan tiny.yaml --weights weights.yaml -o out2"),
              HasSubstr("only for planners on grid maps"));
  EXPECT_THAT(said("plan map.yaml --weights weights.yaml --cost weights.yaml -o out2"),
              HasSubstr("--weights: 'weights.yaml': not with --cost"));
}

}  // namespace
}  // namespace headland
