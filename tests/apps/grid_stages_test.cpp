// The command from end to end, on grid maps.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

class GridStagesTest : public CommandTest {};

TEST_F(GridStagesTest, GridPlannersAreDrivenLikeAnyOther) {
  write("map.txt", "......\n......\n..##..\n......\n");
  write("grid.yaml",
        "field: {grid_map: map.txt}\nvehicle: transplanter\ncoverage: {cell_m: 0.25}\n"
        "planner: {name: grid_tplp, stop: {iterations: 20}}\n");
  ASSERT_LE(headland("evaluate grid.yaml --size 640x400 -o A -q").exit_code, 1);
  const auto metrics = nlohmann::json::parse(text_of(folder_ / "A" / "metrics.json"));
  EXPECT_EQ(metrics["outcome"]["name"], "finished");
  EXPECT_GT(metrics["figures"]["coverage_ratio"].get<double>(), 0.95);
  const CommandResult plan = headland("plan grid.yaml -o B");
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("22 cells"));
  EXPECT_EQ(text_of(folder_ / "A" / "grid_plan.json"), text_of(folder_ / "B" / "grid_plan.json"));
  EXPECT_EQ(text_of(folder_ / "A" / "path.geojson"), text_of(folder_ / "B" / "path.geojson"));
  EXPECT_LE(headland("drive B -o C -q").exit_code, 1);
  EXPECT_EQ(text_of(folder_ / "A" / "run.csv"), text_of(folder_ / "C" / "run.csv"));
  // The grid figure is of the plan: nothing need be driven for it.
  ASSERT_EQ(headland("render A --view grid -o driven.png -q").exit_code, 0);
  const CommandResult drawn = headland("render B --view grid -o planned.png -q");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(text_of(folder_ / "planned.png") == text_of(folder_ / "driven.png"));
  EXPECT_EQ(headland("render B --view map -o map.png -q").exit_code, 2);
  // Another plan in the same folder leaves nothing of the grid's.
  EXPECT_EQ(headland("plan tiny.yaml -o B -q").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "B" / "grid_plan.json"));
}

// The fields of Wu et al. 2023 as reconstructed; bench/grid_drive drives all planners on them.
TEST_F(GridStagesTest, GridPlansCoverThePapersFieldsInside) {
  for (const char* map : {"field_A", "field_B"}) {
    write("field.yaml", std::string("field: {grid_map: ") + HEADLAND_SOURCE_DIR +
                            "/examples/maps/" + map +
                            ".txt}\nvehicle: transplanter\n"
                            "planner: {name: grid_boustrophedon}\n");
    ASSERT_EQ(headland("plan field.yaml -o F -q").exit_code, 0) << map;
    ASSERT_EQ(headland("drive F -q").exit_code, 0) << map;
    const auto metrics = nlohmann::json::parse(text_of(folder_ / "F" / "metrics.json"));
    EXPECT_EQ(metrics["outcome"]["name"], "finished") << map;
    EXPECT_GE(metrics["figures"]["coverage_ratio"].get<double>(), 0.99) << map;
    EXPECT_EQ(metrics["figures"]["outside_m2"].get<double>(), 0.0) << map;
    EXPECT_EQ(metrics["verdict"]["grade"], "PASS") << map;
  }
}

}  // namespace
}  // namespace headland
