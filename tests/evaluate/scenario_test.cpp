#include "evaluate/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "evaluate/scenario_keys.h"
#include "tests/evaluate/scenario_fixture.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using test::kLeast;
using test::ScenarioTest;
using ::testing::HasSubstr;

TEST_F(ScenarioTest, NeedsOnlyAFieldAndAVehicle) {
  const Scenario scenario = read(kLeast);
  EXPECT_EQ(scenario.name, "field");
  EXPECT_EQ(scenario.field.boundary.size(), 4U);
  EXPECT_EQ(scenario.terrain.generator, "flat");
  EXPECT_EQ(scenario.soil.soil.name, "firm");
  EXPECT_TRUE(scenario.soil.file.empty());
  EXPECT_EQ(scenario.working_width_m, load_vehicle("transplanter").implement.working_width_m);
  EXPECT_EQ(scenario.simulation.rate_hz, SimulationOptions{}.rate_hz);
}

TEST_F(ScenarioTest, ReadsEveryKindOfValue) {
  const Scenario scenario = read(R"(name: north
seed: 18446744073709551615
field:
  boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]
  holes: [[[10, 10], [12, 10], [12, 12]]]
  obstacles:
    - {kind: rock, at: [30, 20], radius_m: 1.5, height_m: 0.8}
    - {kind: fence, line: [[40, 20], [45, 20], [45, 25]], thickness_m: 0.1}
  entry: [1, +2.5]
terrain: {generator: rolling, amplitude_m: 2, cell_m: 0.5, micro_relief: {rms_m: 0.03}, seed: 9}
vehicle: transplanter
implement: {working_width_m: 1.5}
path: {allow_overrun: true, clearance_m: 0.4}
verdict: {slip_max: {fail: 0.25}}
)");
  EXPECT_EQ(scenario.name, "north");
  EXPECT_EQ(scenario.seed, 18446744073709551615U);
  ASSERT_EQ(scenario.field.holes.size(), 1U);
  EXPECT_EQ(scenario.field.holes[0].size(), 3U);
  ASSERT_EQ(scenario.field.obstacles.size(), 2U);
  EXPECT_EQ(scenario.field.obstacles[1].line.size(), 3U);
  EXPECT_EQ(scenario.field.obstacles[1].radius_m, 0.05);
  EXPECT_EQ(scenario.field.obstacles[1].height_m, 1.5);
  EXPECT_EQ(scenario.field.obstacles[0].kind, ObstacleKind::kRock);
  EXPECT_EQ(scenario.field.obstacles[0].radius_m, 1.5);
  EXPECT_EQ(scenario.field.entry, Eigen::Vector2d(1.0, 2.5));
  EXPECT_EQ(number(scenario.terrain.parameters, "amplitude_m"), 2.0);
  EXPECT_EQ(scenario.terrain.micro_relief.rms_m, 0.03);
  EXPECT_EQ(scenario.terrain.seed, 9U);
  EXPECT_EQ(scenario.working_width_m, 1.5);
  EXPECT_TRUE(scenario.path.allow_overrun);
  EXPECT_EQ(scenario.path.clearance_m, 0.4);
  EXPECT_EQ(scenario.verdict.slip_max.fail, 0.25);
  EXPECT_EQ(scenario.verdict.slip_max.warn, VerdictLimits{}.slip_max.warn);
}

TEST_F(ScenarioTest, TerrainFollowsTheSeedUnlessItHasItsOwnAndAGivenOneIsForAll) {
  EXPECT_EQ(read(kLeast + "seed: 5\n").terrain.seed, 5U);
  EXPECT_EQ(read(kLeast + "seed: 5\nterrain: {seed: 2}\n").terrain.seed, 2U);
  EXPECT_EQ(read(kLeast + "seed: 5\n", 6).terrain.seed, 6U);
  EXPECT_EQ(read(kLeast + "seed: 5\nterrain: {seed: 2}\n", 6).terrain.seed, 6U);
  EXPECT_EQ(read(kLeast + "seed: 5\n", 6).seed, 6U);
}

TEST_F(ScenarioTest, PositioningIsIdealUnlessAskedAndItsNoiseFollowsTheSeed) {
  EXPECT_EQ(read(kLeast).simulation.positioning.noise_m, 0.0);
  EXPECT_EQ(read(kLeast).simulation.steering_latency_s, 0.0);
  const Scenario scenario =
      read(kLeast +
               "positioning: {noise_m: 0.02, noise_time_s: 20, latency_s: 0.1}\n"
               "simulation: {steering_latency_s: 0.2}\nseed: 5\n",
           6);
  const PositioningOptions& positioning = scenario.simulation.positioning;
  EXPECT_EQ(positioning.noise_m, 0.02);
  EXPECT_EQ(positioning.noise_time_s, 20.0);
  EXPECT_EQ(positioning.latency_s, 0.1);
  EXPECT_EQ(scenario.simulation.steering_latency_s, 0.2);
  EXPECT_EQ(positioning.seed, 6U);
}

TEST_F(ScenarioTest, ReadsBackWhatItWrote) {
  const Scenario first = read(R"(name: "two: words"
field:
  boundary: [[0.1, 0], [60, -1e-3], [60, 40], [0, 40]]
  holes: [[[10, 10], [12, 10], [12, 12]]]
  obstacles: [{at: [30, 20]}, {kind: wall, line: [[1, 2], [3, 4.5]], thickness_m: 0.3}]
  entry: [1, 2]
terrain: {generator: rolling, wavelength_m: 80, micro_relief: {rms_m: 0.01}}
vehicle: transplanter
verdict: {coverage_ratio_min: {warn: 0.9, fail: 0.8}}
seed: 12345678901234567890
)");
  const std::string written = scenario_yaml(first);
  const Scenario second = read(written);
  EXPECT_EQ(scenario_yaml(second), written);
  EXPECT_EQ(second.name, "two: words");
  EXPECT_EQ(second.field.boundary, first.field.boundary);
  EXPECT_EQ(second.field.holes, first.field.holes);
  EXPECT_EQ(second.seed, first.seed);
  EXPECT_EQ(second.terrain.parameters, first.terrain.parameters);
}

TEST_F(ScenarioTest, WritesEveryNumberAndThreshold) {
  const std::string written = scenario_yaml(read(kLeast));
  for (const NumberKey& key : number_keys()) {
    EXPECT_THAT(written, HasSubstr(std::string(key.path.substr(key.path.rfind('.') + 1)) + ": "));
  }
  for (const LimitKey& key : limit_keys()) {
    EXPECT_THAT(written, HasSubstr(std::string(key.path.substr(key.path.rfind('.') + 1)) + ": {"));
  }
}

TEST_F(ScenarioTest, AGuidanceLineIsReadWrittenAndBroughtToW) {
  const std::string field =
      "field: {boundary: [[11.5, 48.1], [11.502, 48.1], [11.502, 48.101], [11.5, 48.101]], "
      "crs: EPSG:4326}\nvehicle: transplanter\n";
  const Scenario scenario =
      read(field + "planner: {ab_line: [[11.501, 48.1], [11.501, 48.101]]}\n");
  ASSERT_TRUE(scenario.planner.ab_line);
  EXPECT_EQ(read(scenario_yaml(scenario)).planner.ab_line, scenario.planner.ab_line);
  const Stage stage = load_stage(scenario);
  const PlanRequest request = plan_request(scenario, stage);
  ASSERT_TRUE(request.ab_line_W);
  // North through the middle, a thousandth of a degree of latitude long.
  const auto& [a_W, b_W] = *request.ab_line_W;
  EXPECT_NEAR(b_W.x() - a_W.x(), 0.0, 0.01);
  EXPECT_NEAR(b_W.y() - a_W.y(), 111.2, 0.1);
  EXPECT_TRUE(inside_field(stage.field, 0.5 * (a_W + b_W)));
  EXPECT_THAT(refusal(field + "planner: {ab_line: [[11.501, 48.1]]}\n"),
              HasSubstr("planner.ab_line: '1 point': two points, A and B"));
  EXPECT_THAT(refusal(field + "planner: {name: grid_tplp, ab_line: [[1, 2], [3, 4]]}\n"),
              HasSubstr("only of planners on fields"));
}

TEST_F(ScenarioTest, HeadlandEdgesAreReadWrittenAndBroughtToW) {
  const std::string field =
      "field: {boundary: [[11.5, 48.1], [11.502, 48.1], [11.502, 48.101], [11.5, 48.101]], "
      "crs: EPSG:4326}\nvehicle: transplanter\n";
  const std::string edges =
      "planner: {headland_edges: [{at: [11.501, 48.1], passes: 0}, {edge: 3, width_m: 7.5}, "
      "{hole: 2, passes: 1}]}\n";
  const Scenario scenario = read(field + edges);
  ASSERT_EQ(scenario.planner.headland_edges.size(), 3U);
  const auto& again = read(scenario_yaml(scenario)).planner.headland_edges;
  ASSERT_EQ(again.size(), 3U);
  EXPECT_EQ(again[0].at_W, scenario.planner.headland_edges[0].at_W);
  EXPECT_EQ(again[0].passes, 0);
  EXPECT_EQ(again[1].edge, 3);
  EXPECT_FALSE(again[1].passes);
  EXPECT_DOUBLE_EQ(again[1].width_m, 7.5);
  EXPECT_EQ(again[2].hole, 2);
  const Stage stage = load_stage(scenario);
  const PlanRequest request = plan_request(scenario, stage);
  ASSERT_TRUE(request.headland_edges[0].at_W);
  // In the middle of the lower edge.
  EXPECT_NEAR(field_clearance_m(stage.field, *request.headland_edges[0].at_W), 0.0, 0.01);
  const auto refused = [&](const std::string& entry) {
    return refusal(field + "planner: {headland_edges: [" + entry + "]}\n");
  };
  EXPECT_THAT(refused("{passes: 1}"), HasSubstr("which edge is missing"));
  EXPECT_THAT(refused("{at: [1, 2], edge: 1, passes: 1}"), HasSubstr("not both"));
  EXPECT_THAT(refused("{edge: 1}"), HasSubstr("how wide is missing"));
  EXPECT_THAT(refused("{edge: 1, passes: 1, width_m: 3}"),
              HasSubstr("passes or width_m, not both"));
  EXPECT_THAT(refused("{edge: 1, passes: 21}"), HasSubstr("passes"));
  EXPECT_THAT(refused("{edge: 0, passes: 1}"), HasSubstr("edge"));
  EXPECT_THAT(refused("{edge: 1, passes: 1, pases: 2}"), HasSubstr("pases"));
  EXPECT_THAT(
      refusal(field + "planner: {name: grid_tplp, headland_edges: [{edge: 1, passes: 1}]}\n"),
      HasSubstr("only of planners on fields"));
}

TEST_F(ScenarioTest, PathOptionsAreReadAndWritten) {
  const Scenario scenario = read(
      "field: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\nvehicle: transplanter\n"
      "path: {keep_off_worked: true, continuous_turns: true}\n");
  EXPECT_TRUE(scenario.path.keep_off_worked);
  EXPECT_TRUE(scenario.path.continuous_turns);
  const Scenario again = read(scenario_yaml(scenario));
  EXPECT_TRUE(again.path.keep_off_worked);
  EXPECT_TRUE(again.path.continuous_turns);
}

TEST_F(ScenarioTest, FilePathsStartAtTheScenarioAndBecomeAbsolute) {
  std::ofstream(folder_ / "boundary.geojson") << "{}";
  const Scenario scenario = read("field: {file: boundary.geojson}\nvehicle: transplanter\n");
  EXPECT_TRUE(scenario.field.file.is_absolute());
  EXPECT_TRUE(std::filesystem::equivalent(scenario.field.file, folder_ / "boundary.geojson"));
  EXPECT_THAT(scenario_yaml(scenario), HasSubstr(scenario.field.file.string()));
}

TEST_F(ScenarioTest, EveryKeyStandsInTheDocumentation) {
  std::ifstream stream(std::string(HEADLAND_SOURCE_DIR) + "/docs/scenario.md");
  std::stringstream page;
  page << stream.rdbuf();
  for (const std::string& path : scenario_key_paths()) {
    if (path.ends_with(".warn") || path.ends_with(".fail")) continue;  // told once for all
    EXPECT_THAT(page.str(), HasSubstr("`" + path + "`"));
  }
}

TEST_F(ScenarioTest, TheExamplesAreRead) {
  for (const char* name : {"demo.yaml", "real_field.yaml", "field_b.yaml"}) {
    const auto file = std::filesystem::path(HEADLAND_SOURCE_DIR) / "examples" / name;
    EXPECT_NO_THROW(read_scenario(file)) << name;
  }
}

}  // namespace
}  // namespace headland
