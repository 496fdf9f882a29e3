// What scenarios are refused for, and how that is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "evaluate/scenario.h"
#include "terrains/input_error.h"
#include "tests/evaluate/scenario_fixture.h"

namespace headland {
namespace {

using test::kField;
using test::kLeast;
using test::ScenarioTest;
using ::testing::AllOf;
using ::testing::HasSubstr;

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
