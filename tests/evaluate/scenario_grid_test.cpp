#include "evaluate/scenario_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "evaluate/coverage.h"
#include "evaluate/grid_plan_file.h"
#include "evaluate/scenario.h"
#include "planner/grid_planners.h"
#include "terrains/grid_field.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"
#include "tests/evaluate/scenario_fixture.h"

namespace headland {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class GridScenarioTest : public test::ScenarioTest {
 protected:
  void SetUp() override {
    ScenarioTest::SetUp();
    std::ofstream(folder_ / "map.txt") << "......\n......\n..##..\n......\n";
  }

  std::string refusal(const std::string& yaml) {
    try {
      load_stage(read(yaml));
    } catch (const InputError& error) {
      return error.what();
    }
    return "(accepted)";
  }
};

const std::string kMapField = "field: {grid_map: map.txt}\nvehicle: transplanter\n";
const std::string kOnGrid = "planner: {name: grid_boustrophedon}\n";

TEST_F(GridScenarioTest, TakesCellsAsWideAsTheImplementAndGroundToTurnOn) {
  const Scenario scenario = read(kMapField + kOnGrid);
  EXPECT_EQ(scenario.field.cell_m, 2.0);
  EXPECT_EQ(scenario.field.margin_m, grid_margin_m(load_stage(scenario).vehicle, scenario.path));
  const Stage stage = load_stage(scenario);
  ASSERT_TRUE(stage.grid.has_value());
  EXPECT_EQ(free_cell_count(*stage.grid), 22);
  EXPECT_EQ(stage.field.holes.size(), 1U);
  const CoverageFigures figures = coverage_figures(measure_coverage(stage.field, {}, 2.0, 0.25));
  EXPECT_NEAR(figures.workable_m2, 22 * 4.0, 1e-9);
}

TEST_F(GridScenarioTest, ReadsBackAsItIsWritten) {
  const std::string written = scenario_yaml(
      read("field: {grid_map: map.txt, cell_m: 2.5, margin_m: 7, entry: [1, 1]}\n"
           "vehicle: transplanter\n"
           "planner: {name: grid_tplp, population: 20, start: north_west, end: [5, 0], "
           "direction_deg: 12.5, cost: {objective: weighted, turn: 0.4}, "
           "stop: {iterations: 30, stagnation: 10}, perturb: {changes: 3, seed: 9}}\n"));
  EXPECT_EQ(scenario_yaml(read(written)), written);
  EXPECT_THAT(written,
              AllOf(HasSubstr("start: north_west"), HasSubstr("end: [5, 0]"),
                    HasSubstr("turn: 0.4"), HasSubstr("stagnation: 10"), HasSubstr("margin_m: 7"),
                    HasSubstr("changes: 3"), HasSubstr("seed: 9")));
  const std::string tractor =
      scenario_yaml(read(kMapField + "planner: {name: grid_gwo, closed: true, cost: {objective: "
                                     "tractor, tractor: {friction: 0.3}}}\n"));
  EXPECT_EQ(scenario_yaml(read(tractor)), tractor);
  EXPECT_THAT(tractor, AllOf(HasSubstr("friction: 0.3"), HasSubstr("closed: true")));
}

TEST_F(GridScenarioTest, AsksOfThePlannerWhatItSays) {
  const Scenario scenario = read(
      kMapField + "planner: {name: grid_boustrophedon, start: north_west, end: [5, 0]}\nseed: 4\n");
  const GridPlanRequest request = grid_plan_request(scenario, load_stage(scenario));
  EXPECT_EQ(request.start, (GridCell{0, 3}));
  EXPECT_EQ(request.end, (GridCell{5, 0}));
  EXPECT_EQ(request.seed, 4U);
  EXPECT_EQ(request.map.height_m.size(), request.map.blocked.size());
}

TEST_F(GridScenarioTest, LaysCellsOverAField) {
  // 31 x 13 m: 15 x 6 cells of 2 m, and a metre of each side that no cell fills.
  const Stage stage = load_stage(
      read("field: {boundary: [[0, 0], [31, 0], [31, 13], [0, 13]]}\nvehicle: transplanter\n" +
           kOnGrid));
  ASSERT_TRUE(stage.grid.has_value());
  EXPECT_EQ(free_cell_count(*stage.grid), 15 * 6);
  EXPECT_THAT(stage.notes, ::testing::Contains(HasSubstr("grid: 90 cells of 2 m")));
  const CoverageFigures figures = coverage_figures(measure_coverage(stage.field, {}, 2.0, 0.25));
  EXPECT_NEAR(figures.workable_m2, 90 * 4.0, 1e-9);
}

TEST_F(GridScenarioTest, TellsOfPockets) {
  // A dumb-bell whose bar is narrower than a cell.
  const Stage stage = load_stage(
      read("field: {boundary: [[0, 0], [12, 0], [12, 5], [18, 5], [18, 0], [24, 0], [24, 8], "
           "[18, 8], [18, 6], [12, 6], [12, 8], [0, 8]]}\nvehicle: transplanter\n" +
           kOnGrid));
  EXPECT_EQ(free_cell_count(*stage.grid), 24);
  EXPECT_THAT(stage.notes, ::testing::Contains(HasSubstr("pocket of 12 cells at (19.0, 1.0) m")));
}

TEST_F(GridScenarioTest, OtherPlannersTakeAMapWithoutMargin) {
  const Scenario scenario = read(kMapField);
  EXPECT_EQ(scenario.field.margin_m, 0.0);
  EXPECT_FALSE(load_stage(scenario).grid.has_value());
}

TEST_F(GridScenarioTest, RefusesWhatDoesNotGoTogether) {
  EXPECT_THAT(refusal("field: {grid_map: map.txt, boundary: [[0, 0], [9, 0], [9, 9]]}\n"
                      "vehicle: transplanter\n"),
              AllOf(HasSubstr("field.boundary"), HasSubstr("not with field.grid_map")));
  EXPECT_THAT(refusal("field: {boundary: [[0, 0], [60, 0], [60, 40]], margin_m: 3}\n"
                      "vehicle: transplanter\n"),
              AllOf(HasSubstr("field.margin_m"), HasSubstr("only with field.grid_map")));
  EXPECT_THAT(refusal("vehicle: transplanter\nfield: {layer: a}\n"),
              HasSubstr("one of field.file, field.boundary and field.grid_map"));
  EXPECT_THAT(refusal(kMapField + "planner: {name: boustrophedon, start: free}\n"),
              AllOf(HasSubstr("planner.start"), HasSubstr("only of planners on grid maps")));
  EXPECT_THAT(refusal(kMapField + "planner: {name: grid_tpl}\n"),
              AllOf(HasSubstr("planner.name"), HasSubstr("the nearest is grid_tplp")));
  EXPECT_THAT(refusal(kMapField + "planner: {name: grid_tplp, perturb: {change: 1}}\n"),
              HasSubstr("did you mean 'changes'?"));
  EXPECT_THAT(refusal(kMapField + "planner: {name: boustrophedon, perturb: {changes: 1}}\n"),
              AllOf(HasSubstr("planner.perturb"), HasSubstr("only of planners on grid maps")));
  EXPECT_THAT(refusal("field: {grid_map: none.txt}\nvehicle: transplanter\n"),
              HasSubstr("none.txt"));
}

TEST_F(GridScenarioTest, RefusesEndsThatAreNoFreeCells) {
  EXPECT_THAT(refusal(kMapField + "planner: {name: grid_tplp, start: [2, 1]}\n"),
              AllOf(HasSubstr("planner.start"), HasSubstr("2, 1")));
  EXPECT_THAT(refusal(kMapField + "planner: {name: grid_tplp, end: [6, 0]}\n"),
              HasSubstr("planner.end"));
  EXPECT_THAT(refusal(kMapField + "planner: {name: grid_tplp, end: [1.5, 0]}\n"),
              AllOf(HasSubstr("planner.end"), HasSubstr("[column, row]")));
}

TEST_F(GridScenarioTest, RefusesMapsWhoseFreeCellsAreNotConnected) {
  std::ofstream(folder_ / "map.txt") << "..#..\n..#..\n";
  EXPECT_THAT(refusal(kMapField + kOnGrid), AllOf(HasSubstr("map.txt"), HasSubstr("4")));
}

TEST_F(GridScenarioTest, WritesCellsInOrderAndWhatIsNotWorked) {
  GridPlan plan;
  plan.planner = "grid_tplp";
  plan.cells = {{0, 0}, {1, 0}};
  plan.counts.steps = 1;
  GridDrive drive;
  drive.unworked.push_back({{1, 0}, 0.25, "a wall"});
  drive.unworked_ratio = 0.125;
  drive.left_out.push_back({{1, 0}, {0, 0}, "no turn"});
  GridMap map = free_grid_map(2, 1);
  map.cell_m = 2.0;
  std::ofstream(folder_ / "plan.json") << grid_plan_json(map, plan, drive);
  const auto json = parse_json(folder_ / "plan.json");
  EXPECT_EQ(json["cells"], "0 0, 1 0");
  EXPECT_EQ(json["unworked"][0]["column"], 1);
  EXPECT_EQ(json["unworked"][0]["x_m"], 3.0);
  EXPECT_EQ(json["unworked"][0]["why"], "a wall");
  EXPECT_EQ(json["unworked_ratio"], 0.125);
  EXPECT_EQ(json["runs_left_out"].dump(), R"([{"from":[1,0],"to":[0,0],"why":"no turn"}])");
}

}  // namespace
}  // namespace headland
