#include "evaluate/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "evaluate/scenario_keys.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ScenarioTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Scenario read(const std::string& yaml, std::optional<std::uint64_t> seed = std::nullopt) {
    std::ofstream(file_) << yaml;
    return read_scenario(file_, seed);
  }

  std::string refusal(const std::string& yaml) {
    try {
      read(yaml);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_THAT(error.what(), HasSubstr(file_.string()));
      return error.what();
    }
    return "(accepted)";
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file_ = folder_ / "field.yaml";
};

const std::string kField = "field: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\n";
const std::string kLeast = kField + "vehicle: transplanter\n";

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
              HasSubstr("planner.ab_line: '1 points': two points, A and B"));
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

TEST_F(ScenarioTest, RefusesMissingAndMalformedFiles) {
  EXPECT_THAT([&] { read_scenario(folder_ / "none.yaml"); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("none.yaml: no such file")));
  EXPECT_THAT([&] { read_scenario(folder_); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("is a folder")));
  EXPECT_THAT(refusal("name: a\nfield: [1, 2\nvehicle: b\n"),
              AllOf(HasSubstr("line "), HasSubstr("malformed YAML")));
  EXPECT_THAT(refusal(""), HasSubstr("a mapping"));
  EXPECT_THAT(refusal("- 1\n- 2\n"), HasSubstr("a mapping"));
}

TEST_F(ScenarioTest, RefusesUnknownKeysWithTheNearestOne) {
  EXPECT_THAT(refusal(kLeast + "sead: 1\n"),
              AllOf(HasSubstr("line 3: sead"), HasSubstr("did you mean 'seed'?")));
  EXPECT_THAT(refusal(kLeast + "simulation:\n  rate: 240\n"),
              AllOf(HasSubstr("line 4: simulation.rate"), HasSubstr("'rate_hz'")));
  EXPECT_THAT(refusal(kLeast + "verdict: {slip_max: {wran: 0.1}}\n"),
              AllOf(HasSubstr("verdict.slip_max.wran"), HasSubstr("'warn'")));
  EXPECT_THAT(refusal(kLeast + "terrain: {generator: rolling, amplitude: 1}\n"),
              HasSubstr("did you mean 'amplitude_m'?"));
  EXPECT_THAT(refusal(kLeast + "planner: {name: boustrophedon, headland_pass: 1}\n"),
              HasSubstr("did you mean 'headland_passes'?"));
  EXPECT_THAT(refusal(kLeast + "seed: 1\nseed: 2\n"),
              AllOf(HasSubstr("line 4: seed"), HasSubstr("given twice")));
}

TEST_F(ScenarioTest, RefusesASecondDocument) {
  EXPECT_EQ(refusal(kLeast + "---\n" + kLeast),
            file_.string() + ": line 4: a second YAML document begins here; one file holds one");
  EXPECT_EQ(read("---\n" + kLeast + "...\n").vehicle, "transplanter");
}

TEST_F(ScenarioTest, SaysWhatIsWantedWhereThereIsNoneOrAnotherKindOfValue) {
  const std::string at = file_.string() + ": line 3: ";
  const std::pair<const char*, const char*> cases[] = {
      {"name:", "name: a word is needed, there is no value"},
      {"name: ''", "name: a word is needed, not an empty text"},
      {"name: [a, b]", "name: '[a, b]': a word is needed, not a list"},
      {"name: {a: b}", "name: a word is needed, not a mapping"},
      {"seed: ~",
       "seed: a whole number from 0 to 18446744073709551615 is needed, there is no value"},
      {"coverage: {cell_m: [1]}",
       "coverage.cell_m: '[1]': a number from 0.02 to 5 is needed, not a list"},
      {"coverage: {cell_m: ~}",
       "coverage.cell_m: a number from 0.02 to 5 is needed, there is no value"},
      {"path: {allow_overrun: {}}", "path.allow_overrun: true or false is needed, not a mapping"},
      {"verdict:", "verdict: a section of keys is needed, there is no value"},
      {"verdict: []", "verdict: a section of keys is needed, not a list"},
      {"planner: {headland_passes: [2]}",
       "planner.headland_passes: '[2]': auto or a whole number from 1 to 20 is needed, not a list"},
      {"planner: {headland_passes: 1.5}",
       "planner.headland_passes: '1.5': auto or a whole number from 1 to 20"},
      {"planner: {headland_passes: 0}",
       "planner.headland_passes: '0': auto or a whole number from 1 to 20"},
      {"planner: {swath_direction_deg: -1}",
       "planner.swath_direction_deg: '-1': auto or a number from 0 to 360"},
      {"? [a, b]\n: 1", "a key that is a word is needed"},
  };
  for (const auto& [yaml, message] : cases) {
    EXPECT_EQ(refusal(kLeast + yaml + "\n"), at + message);
  }
  EXPECT_TRUE(
      std::holds_alternative<std::string>(read(kLeast).planner.parameters.at("headland_passes")));
  EXPECT_EQ(number(read(kLeast + "planner: {headland_passes: 2}\n").planner.parameters,
                   "headland_passes"),
            2.0);
}

TEST_F(ScenarioTest, TheCellIsZeroOrInItsRange) {
  for (const char* cell : {"1e-9", "-1", "101"}) {
    EXPECT_EQ(refusal(kLeast + "terrain: {cell_m: " + cell + "}\n"),
              file_.string() + ": line 3: terrain.cell_m: '" + cell +
                  "': 0 or a number from 0.01 to 100 is needed");
  }
  EXPECT_EQ(read(kLeast + "terrain: {cell_m: 0}\n").terrain.cell_m, 0.0);
  EXPECT_EQ(read(kLeast + "terrain: {cell_m: 0.01}\n").terrain.cell_m, 0.01);
}

TEST_F(ScenarioTest, RefusesFoldersThatHoldNoVehicleAndUnknownCrs) {
  EXPECT_THAT(refusal(kField + "vehicle: ./\n"),
              AllOf(HasSubstr("line 2: vehicle: './': there is no vehicle.urdf in "),
                    HasSubstr(folder_.string())));
  EXPECT_THAT(refusal("field: {crs: 'EPSG:0', boundary: [[0, 0], [1, 0], [0, 1]]}\n"
                      "vehicle: transplanter\n"),
              HasSubstr("line 1: field.crs: 'EPSG:0': unknown CRS"));
}

TEST_F(ScenarioTest, RefusesMissingKeys) {
  EXPECT_THAT(refusal(kField),
              HasSubstr("field.yaml: vehicle: the key is missing: a folder or one of "));
  EXPECT_THAT(refusal("vehicle: transplanter\n"),
              HasSubstr("field.yaml: field: the section is missing: a file or a boundary"));
  EXPECT_THAT(refusal("field: {layer: a}\nvehicle: transplanter\n"),
              HasSubstr("one of field.file"));
  EXPECT_THAT(refusal("field:\n  boundary: [[0, 0], [1, 0], [0, 1]]\n  obstacles: [{kind: tree}]\n"
                      "vehicle: transplanter\n"),
              AllOf(HasSubstr("line 3: field.obstacles.at"), HasSubstr("missing")));
}

TEST_F(ScenarioTest, RefusesObstaclesThatAreNeitherPointNorLine) {
  const auto with = [&](const std::string& obstacle) {
    return refusal("field:\n  boundary: [[0, 0], [9, 0], [0, 9]]\n  obstacles: [" + obstacle +
                   "]\nvehicle: transplanter\n");
  };
  EXPECT_THAT(with("{kind: wall, at: [1, 1]}"),
              HasSubstr("line 3: field.obstacles.at: only of trees, poles and rocks"));
  EXPECT_THAT(with("{kind: wall}"), HasSubstr("field.obstacles.line: the key is missing: [[x, y]"));
  EXPECT_THAT(with("{kind: tree, at: [1, 1], line: [[1, 1], [2, 2]]}"),
              HasSubstr("field.obstacles.line: only of walls and fences"));
  EXPECT_THAT(with("{kind: fence, line: [[1, 1], [2, 2]], thickness_m: 0}"),
              HasSubstr("field.obstacles.thickness_m: '0': a number from 0.02 to 10 is needed"));
  EXPECT_THAT(with("{kind: hedge, at: [1, 1]}"),
              HasSubstr("unknown obstacle; known: tree, pole, rock, wall, fence"));
}

TEST_F(ScenarioTest, RefusesValuesOutOfTheirRange) {
  EXPECT_THAT(refusal(kLeast + "simulation: {rate_hz: .nan}\n"),
              AllOf(HasSubstr("simulation.rate_hz"), HasSubstr("'.nan'"), HasSubstr("60 to 2000")));
  EXPECT_THAT(refusal(kLeast + "implement: {working_width_m: -2}\n"),
              AllOf(HasSubstr("'-2'"), HasSubstr("0.2 to 60")));
  EXPECT_THAT(refusal(kLeast + "coverage: {cell_m: 1e9}\n"), HasSubstr("'1e9'"));
  EXPECT_THAT(refusal(kLeast + "simulation: {soc_start: 80 %}\n"), HasSubstr("'80 %'"));
  EXPECT_THAT(refusal(kLeast + "simulation: {record_hz: 500}\n"), HasSubstr("simulation.rate_hz"));
  EXPECT_THAT(refusal(kLeast + "path: {allow_overrun: yes}\n"), HasSubstr("true or false"));
  EXPECT_THAT(refusal(kLeast + "seed: -1\n"), HasSubstr("whole number"));
  EXPECT_THAT(refusal(kLeast + "verdict: {slip_max: {warn: 0.5}}\n"),
              AllOf(HasSubstr("verdict.slip_max"), HasSubstr("less is better")));
  EXPECT_THAT(refusal(kLeast + "verdict: {coverage_ratio_min: {fail: 1}}\n"),
              HasSubstr("more is better"));
  EXPECT_THAT(refusal(kLeast + "terrain: {generator: rolling, wavelength_m: -3}\n"),
              AllOf(HasSubstr("line 3: terrain.wavelength_m"), HasSubstr("-3")));
}

TEST_F(ScenarioTest, RefusesWhatIsNoCoordinate) {
  EXPECT_THAT(
      refusal("field: {boundary: [[0, 0], [1, x], [0, 1]]}\nvehicle: transplanter\n"),
      ::testing::EndsWith("line 1: field.boundary point 2: '[1, x]': a point [x, y] of two finite "
                          "numbers is needed"));
  EXPECT_THAT(refusal("field: {boundary: [[0, 0], [1, .inf], [0, 1]]}\nvehicle: transplanter\n"),
              HasSubstr("finite"));
  EXPECT_THAT(refusal("field: {boundary: 7}\nvehicle: transplanter\n"), HasSubstr("'7'"));
}

TEST_F(ScenarioTest, RefusesUnknownNamesWithTheNearestOne) {
  EXPECT_THAT(refusal(kField + "vehicle: transplantor\n"),
              AllOf(HasSubstr("line 2: vehicle"), HasSubstr("did you mean 'transplanter'?")));
  EXPECT_THAT(refusal(kLeast + "soil: frim\n"), HasSubstr("did you mean 'firm'?"));
  EXPECT_THAT(refusal(kLeast + "terrain: {generator: roling}\n"),
              HasSubstr("did you mean 'rolling'?"));
  EXPECT_THAT(refusal(kLeast + "planner: {name: boustrofedon}\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("boustrophedon")));
}

TEST_F(ScenarioTest, RefusesFilesThatAreNotThereAndTwoSources) {
  EXPECT_THAT(refusal("field: {file: none.geojson}\nvehicle: transplanter\n"),
              AllOf(HasSubstr("line 1: field.file"), HasSubstr("no such file")));
  EXPECT_THAT(refusal(kLeast + "terrain: {file: none.tif}\n"),
              AllOf(HasSubstr("line 3: terrain.file"), HasSubstr("no such file")));
  std::ofstream(folder_ / "dem.asc") << "x";
  EXPECT_THAT(refusal(kLeast + "terrain: {file: dem.asc, generator: ramp}\n"),
              HasSubstr("not both"));
}

}  // namespace
}  // namespace headland
