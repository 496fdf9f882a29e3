// Every kind of bad input: exit 2, exactly one line that says what is wrong, nothing written.
#include <gmock/gmock.h>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

struct BadInput {
  std::string name;
  std::string arguments;
  std::string scenario;  // bad.yaml
  std::string other;     // other.csv and other.geojson
  std::string message;   // part of the line
};

std::string field(const std::string& boundary, const std::string& more = "") {
  return "field: {boundary: [" + boundary + "]" + more + "}\nvehicle: transplanter\n";
}

const std::string kSquare = "[0, 0], [60, 0], [60, 40], [0, 40]";
const std::string kEvaluate = "evaluate bad.yaml -o DIR";
const std::string kPlan = "plan bad.yaml -o DIR";
const std::string kTrack = "drive tiny.yaml --path other.csv -o DIR";
const std::string kCompare = "compare bad.yaml -o DIR";
const std::string kComparedMap = "maps: [{generator: {columns: 6, rows: 5}}]\n";
const std::string kDrawnMap = "maps: [{file: other.csv}]\nplanners: [{name: grid_tplp}]\n";
const std::string kOnEarth =
    "field: {crs: 'EPSG:4326', boundary: [[9.0, 48.0], [9.001, 48.0], [9.001, 48.0006]]}\n"
    "vehicle: transplanter\nterrain: {file: other.csv}\n";

std::string grid(const std::string& value) {
  return "ncols 2\nnrows 2\nxllcorner 9.0\nyllcorner 48.0\ncellsize 0.0001\nnodata_value -9999\n" +
         value + " 1\n1 1\n";
}

const BadInput kBadInputs[] = {
    {"MissingScenario", "evaluate none.yaml -o DIR", "", "", "none.yaml: no such file"},
    {"ScenarioIsAFolder", "evaluate . -o DIR", "", "", "is a folder"},
    {"MalformedYaml", kEvaluate, "field: [1, 2\n", "", "malformed YAML"},
    {"UnknownKey", kEvaluate, kTinyScenario + "sead: 1\n", "", "did you mean 'seed'?"},
    {"EdgeThatIsNotThere", kPlan,
     kTinyScenario + "planner:\n  headland_edges:\n    - {edge: 1, passes: 1}\n"
                     "    - {edge: 9, passes: 1}\n",
     "", "bad.yaml: line 8: planner.headland_edges: 'edge 9': the boundary has 4 edges"},
    {"EdgeFarOff", kPlan,
     kTinyScenario + "planner:\n  headland_edges:\n    - {at: [50, 2e6], passes: 1}\n", "",
     "bad.yaml: line 7: planner.headland_edges: 'at (50, 2000000) m': a place on an edge of "
     "the field, or at most 50 m from it; the nearest, edge 3, is more than 1000 km away"},
    {"GuidanceBesideTheField", kPlan, kTinyScenario + "planner:\n  ab_line: [[90, 0], [90, 40]]\n",
     "", "bad.yaml: line 6: planner.ab_line: '(90.0, 0.0) to (90.0, 40.0) m'"},
    {"GuidanceOfOnePoint", kPlan, kTinyScenario + "planner:\n  ab_line: [[90, 0]]\n", "",
     "bad.yaml: line 6: planner.ab_line: '1 point': two points, A and B"},
    {"KeyOfAnotherPlanner", kPlan, kTinyScenario + "planner: {name: decomposed, overhang_m: 0.5}\n",
     "", "bad.yaml: line 5: planner.overhang_m: a key of planner boustrophedon, not of decomposed"},
    {"ContinuousTurnsOfSkidSteeringOnCells", kPlan,
     kTinyField + "vehicle: skid_steer_robot\npath: {continuous_turns: true}\n"
                  "planner: {name: grid_tplp}\n",
     "", "bad.yaml: line 5: path.continuous_turns: 'true'"},
    {"ContinuousTurnsOfSkidSteering", kPlan,
     kTinyField + "vehicle: skid_steer_robot\npath: {continuous_turns: true}\n", "",
     "bad.yaml: line 5: path.continuous_turns: 'true'"},
    {"MalformedGeoJson", kEvaluate, "field: {file: other.geojson}\nvehicle: transplanter\n",
     "{\"type\":\n\"Polygon\", ,}\n", "other.geojson: line 2: malformed JSON (character 21)"},
    {"MalformedCsv", kTrack, "", "x,y\n1,2\n3,four\n",
     "other.csv: line 3, y: 'four': a finite number"},
    {"SelfIntersectingBoundary", kEvaluate, field("[0, 0], [60, 40], [60, 0], [0, 40]"), "",
     "bad.yaml: boundary: Self-intersection at x 30.000 m, y 20.000 m"},
    {"CollinearBoundary", kEvaluate, field("[0, 0], [30, 20], [60, 40]"), "",
     "bad.yaml: boundary: '3 points': the points lie on one line and bound no area"},
    {"FarAwayBoundary", kEvaluate, field("[1e15, 0], [1e15, 40], [-1e15, 0]"), "",
     "bad.yaml: boundary: '2e+15 m across': too large for one field (at most 20000 m)"},
    {"EmptyBoundary", kEvaluate, field(""), "",
     "bad.yaml: boundary: is empty; give at least three points"},
    {"HoleOutsideTheField", kEvaluate,
     field(kSquare, ", holes: [[[100, 100], [110, 100], [110, 110]]]"), "",
     "bad.yaml: hole 1: lies outside the boundary at x 110.000 m, y 110.000 m"},
    {"NoCrs", kEvaluate, kOnEarth, grid("1"), "other.csv: has no CRS; give it as terrain.crs"},
    {"TerrainDoesNotCoverTheField", kEvaluate,
     kOnEarth.substr(0, kOnEarth.rfind('}')) + ", crs: 'EPSG:4326'}\n", grid("1"),
     "other.csv: does not cover the field: 97 % of it is missing"},
    {"RasterOfNoSize", kEvaluate, kOnEarth.substr(0, kOnEarth.rfind('}')) + ", crs: 'EPSG:4326'}\n",
     std::string(grid("1")).replace(grid("1").find("0.0001"), 6, "0"),
     "other.csv: size of a pixel: '0 x -0': finite and not 0; in an ASCII grid: cellsize"},
    {"NodataInsideTheField", kEvaluate,
     "field: {crs: 'EPSG:4326', boundary: [[9.00002, 48.00002], [9.00018, 48.00002], "
     "[9.00018, 48.00018], [9.00002, 48.00018]]}\nvehicle: transplanter\n"
     "terrain: {file: other.csv, crs: 'EPSG:4326'}\n",
     grid("-9999"), "other.csv: has no data over "},
    {"NanParameter", kEvaluate, field(kSquare) + "path: {clearance_m: .nan}\n", "",
     "bad.yaml: line 3: path.clearance_m: '.nan': a number from 0 to 20 is needed"},
    {"NegativeParameter", kEvaluate, kTinyScenario + "implement: {working_width_m: -1}\n", "",
     "bad.yaml: line 5: implement.working_width_m: '-1': a number from 0.2 to 60 is needed"},
    {"TerrainRasterTooLarge", kEvaluate,
     field("[0, 0], [900, 0], [900, 900], [0, 900]") + "terrain: {cell_m: 0.01}\n", "", " GB"},
    {"CoverageRasterTooLarge", kEvaluate,
     field("[0, 0], [900, 0], [900, 900], [0, 900]") + "coverage: {cell_m: 0.02}\n", "",
     "bad.yaml: coverage.cell_m: '0.02': 55000 x 55000 cells need 18.2 GB"},
    {"NameTooLong", "render " + std::string(300, 'x'), "", "", "File name too long"},
    {"ImplementWiderThanTheField", kEvaluate,
     field("[0, 0], [30, 0], [30, 24], [0, 24]") + "implement: {working_width_m: 26}\n", "",
     "headland: bad.yaml: implement.working_width_m: '26': wider than the field 'bad' anywhere"},
    {"EntryOutsideTheField", kEvaluate, field(kSquare, ",\n  entry: [80, 20]"), "",
     "headland: bad.yaml: line 2: field.entry: lies 20.0 m outside the field"},
    {"EntryOutsideAFieldOfAFile", kEvaluate,
     "field:\n  file: other.geojson\n  entry: [9.0, 48.1]\nvehicle: transplanter\n",
     R"({"type": "Polygon", "coordinates": [[[9, 48], [9.001, 48], [9.001, 48.001], [9, 48]]]})",
     "headland: bad.yaml: line 3: field.entry: lies 11"},
    {"ObstacleOutsideTheField", kEvaluate,
     field(kSquare, ", obstacles: [{at: [9, 9]},\n  {at: [90, 9]}]"), "",
     "headland: bad.yaml: line 2: field.obstacles[1]: lies outside the boundary"},
    {"GeoJsonAsScenario", "evaluate other.geojson -o DIR", "",
     R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9]]]})",
     "headland: other.geojson: this is GeoJSON, not a scenario (YAML)"},
    {"BinaryAsScenario", "evaluate other.csv -o DIR", "", std::string("II*\0\1", 5),
     "headland: other.csv: this is a binary file, not a scenario (YAML)"},
    {"ScalarForAThreshold", kEvaluate, kTinyScenario + "verdict: {slip_max: 0.2}\n", "",
     "verdict.slip_max: '0.2': a section {warn: .., fail: ..} is needed"},
    {"NothingFits", kEvaluate, field("[0, 0], [7, 0], [7, 7], [0, 7]"), "", "turn"},
    {"UnknownPlanner", kEvaluate, kTinyScenario + "planner: {name: boustrofedon}\n", "",
     "boustrophedon"},
    {"UnknownVehicle", kEvaluate, kTinyField + "vehicle: transplantor\n", "",
     "did you mean 'transplanter'?"},
    {"AuditWithoutAField", "audit --path other.csv", "", "x,y\n1,2\n3,4\n",
     "--field: give either a scenario or a field with --field FILE and --vehicle NAME"},
    {"AuditWithoutAVehicle", "audit --field other.geojson --path other.geojson", "", "{}",
     "--vehicle: needed along with --field"},
    {"AuditOfAnUnknownWidth", "audit tiny.yaml --path other.csv --width -1", "", "x,y\n1,2\n3,4\n",
     "--width: '-1': from 0.05 to 100 m"},
    {"AuditWithACellWiderThanTheImplement", "audit tiny.yaml --path other.csv --cell 5", "",
     "x,y\n1,2\n3,4\n", "--cell: '5': from 0.02 m to half the working width, 1 m"},
    {"AuditOfAScenarioWithACrs", "audit tiny.yaml --path other.csv --crs EPSG:4326", "",
     "x,y\n1,2\n3,4\n", "--crs: 'EPSG:4326': goes with --field"},
    {"CompareLabelOfTwoLines", kCompare,
     kComparedMap + "planners: [{name: grid_tplp, label: \"a\\nb\"}]\n", "",
     "a label has at most 80 characters, all printable"},
    {"AuditOfOnePlace", "audit tiny.yaml --path other.csv -o DIR", "", "x,y\n1,2\n1,2\n",
     "has no two points that are apart"},
    {"AuditElsewhere", "audit tiny.yaml --path other.csv -o DIR", "", "x,y\n90000,2\n90001,2\n",
     "other.csv: line 2: '90000, 2': lies 90 km from the field 'tiny'"},
    {"TrackOfOnePoint", kTrack, "", "x,y\n1,2\n",
     "other.csv: '1 points': a track has at least two different points"},
    {"TrackOfRepeatedPoints", kTrack, "", "x,y\n1,2\n1,2\n1,2\n",
     "other.csv: '3 points': a track has at least two different points"},
    {"TrackWithAJump", kTrack, "", "x,y\n1,2\n2,2\n90000,2\n",
     "other.csv: line 4: '90000, 2': lies 90 km from the field 'tiny': take out the stray point"},
    {"TrackElsewhere", kTrack, "", "x,y\n500000,4864000\n500010,4864000\n",
     "headland: other.csv: line 2: '500000, 4864000': lies 4890 km from the field 'tiny': x,y are"},
    {"TrackNeverDown", kTrack, "", "x,y,implement\n10,20,0\n50,20,0\n",
     "headland: other.csv: no point with the implement down: 'implement' never is"},
    {"TrackThatDoesNotFit", kTrack, "", "x,y\n10,20\n50,90\n",
     "headland: other.csv: pass 1 (swath) takes the hull"},
    {"TrackThatDoesNotFitMayBeAllowed", kTrack, "", "x,y\n10,20\n50,90\n",
     "or allow overruns (--allow-overrun)"},
    {"TrackOfScraps", kTrack, "", "x,y\n10,20\n11,20\n",
     "headland: other.csv: the track has no piece of 5 m that the vehicle can follow"},
    {"PathForPlanning", "plan bad.yaml -o DIR", kTinyScenario + "path: {file: other.csv}\n",
     "x,y\n", "other.csv': is driven as it is, there is nothing to plan"},
    {"Tolerance", kTrack + " --tolerance 0", "", "x,y\n", "--tolerance: '0': from 0.01 to 100 m"},
    {"TrackWithAColumnTwice", kTrack, "", "x,y,x\n1,2,3\n",
     "other.csv: line 1, x: the column stands twice"},
    {"MissingTrack", "drive tiny.yaml --path none.csv -o DIR", "", "", "none.csv: no such file"},
    {"NoPathToDrive", "drive tiny.yaml -o DIR", "", "", "no path to drive"},
    {"NothingToRender", "render none", "", "", "no such file"},
    {"OutputBelowAFile", "evaluate tiny.yaml -o tiny.yaml/DIR", "", "", "is not a folder"},
    {"OutputNotWritable", "plan tiny.yaml -o /proc/headland", "", "", "/proc/headland"},
    {"PictureSize", "evaluate tiny.yaml -o DIR --size 10x10", "", "", "640x400 to 8192x8192"},
    {"RecordRate", "evaluate tiny.yaml -o DIR --record-hz 1e9", "", "",
     "--record-hz: '1000000000': more than 0 and at most 240"},
    {"NegativeSeed", "plan tiny.yaml -o DIR --seed -1", "", "",
     "--seed: '-1': a whole number from 0 to 18446744073709551615 is needed"},
    {"EmptyFolder", "evaluate tiny.yaml -o ''", "", "", "--output: the value is empty"},
    {"EmptyScenario", "evaluate '' -o DIR", "", "", "SCENARIO: the value is empty"},
    {"VehicleInNoFolder", kEvaluate, kTinyField + "vehicle: ../\n", "",
     "bad.yaml: line 4: vehicle: '../': there is no vehicle.urdf in "},
    {"WholeNumber", kEvaluate, kTinyScenario + "planner: {headland_passes: 1.5}\n", "",
     "planner.headland_passes: '1.5': auto or a whole number from 1 to 20"},
    {"SecondDocument", kEvaluate, kTinyScenario + "---\nname: other\n", "",
     "bad.yaml: line 6: a second YAML document begins here"},
    {"ControlCharacters", kEvaluate, kTinyField + "vehicle: \"a\\e[31mb\\u009b\"\n", "",
     "bad.yaml: line 4: vehicle: 'a\\x1B[31mb\\xC2\\x9B': unknown vehicle"},
    {"DeviceAsScenario", "evaluate /dev/zero -o DIR", "", "",
     "/dev/zero: is a pipe, a socket or a device"},
    {"CompareNoSpec", "compare none.yaml -o DIR", "", "", "none.yaml: no such file"},
    {"CompareUnknownPlanner", kCompare, kComparedMap + "planners: [{name: boustrophedon}]\n", "",
     "bad.yaml: line 2: planners.name: 'boustrophedon': unknown planner; did you mean "
     "'grid_boustrophedon'?"},
    {"CompareMissingMap", kCompare, "maps: [{file: none.txt}]\nplanners: [{name: grid_tplp}]\n", "",
     "none.txt': no such file"},
    {"CompareIntoAFile", "compare bad.yaml -o tiny.yaml",
     kComparedMap + "planners: [{name: grid_tplp}]\n", "", "tiny.yaml is not a folder"},
    {"CompareNoJobs", kCompare + " --jobs 0", kComparedMap + "planners: [{name: grid_tplp}]\n", "",
     "--jobs: '0': a whole number from 1 to 1024"},
    {"CompareStrangeCharacter", kCompare, kDrawnMap, "....\n.#x.\n",
     "other.csv: line 2, column 3: 'x': '.' for a free cell or '#' for a blocked one"},
    {"CompareRaggedRows", kCompare, kDrawnMap, "....\n...\n",
     "other.csv: line 2: '3 cells': 4 cells, as on line 1"},
    {"CompareNoFreeCell", kCompare, kDrawnMap, "##\n##\n", "map: there is no free cell"},
    {"CompareDisconnectedMap", kCompare, kDrawnMap, "..#.\n..#.\n",
     "bad.yaml: line 1: maps 'other': map: '2 of 6 free cells': cannot be reached from the rest"},
    {"CompareStartOnAnObstacle", kCompare, "start: [1, 0]\n" + kDrawnMap, "...\n.#.\n",
     "bad.yaml: line 2: maps 'other': start: '1, 0': a free cell; this one is blocked"},
    {"CompareHeightsOfAnotherSize", kCompare,
     "maps: [{generator: {columns: 6, rows: 5}, heights: other.csv}]\n"
     "planners: [{name: grid_tplp}]\n",
     "0 0 0\n", "other.csv: line 1: '3 heights': 6 heights, one for each column of the map"},
    {"CompareNegativeWeight", kCompare,
     kComparedMap + "planners: [{name: grid_tplp}]\ncost: {objective: weighted, turn: -1}\n", "",
     "bad.yaml: line 3: cost.turn: '-1': a number from 0 to 1000000 is needed"},
    {"CompareWeightsOfNothing", kCompare,
     kComparedMap + "planners: [{name: grid_tplp}]\n"
                    "cost: {objective: weighted, repeat: 0, turn: 0, u_turn: 0}\n",
     "", "all are zero"},
    {"ComparePopulationOfOne", kCompare,
     kComparedMap + "planners: [{name: grid_tplp, population: 1}]\n", "",
     "bad.yaml: line 2: planners.population: '1': a whole number from 2 to 1000"},
    {"CompareNoIterations", kCompare,
     kComparedMap + "planners: [{name: grid_tplp}]\nstop: {iterations: 0}\n", "",
     "bad.yaml: line 3: stop.iterations: '0': a whole number from 1 to 2147483647 is needed"},
    {"CompareMoreElitesThanIndividuals", kCompare,
     kComparedMap + "planners: [{name: grid_iga, population: 10, elites: 20}]\n", "",
     "bad.yaml: line 2: planners.elites: '20': at most 10, the population"},
    {"PlanWithMoreElitesThanIndividuals", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: transplanter\nplanner: {name: grid_ga, population: 5, elites: 6}\n", "",
     "planner.elites: '6': at most 5, the population"},
    {"PlanWithOverhangOfRoundedCorners", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: transplanter\nplanner: {overhang_m: 0.5}\n", "",
     "planner.overhang_m: '0.5': only with headland_corners covered"},
    {"PlanWithSkipOfNothing", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: transplanter\nplanner: {name: decomposed, swath_skip: 3}\n", "",
     "bad.yaml: line 5: planner.swath_skip: '3': only with swath_order skip or optimised, not with "
     "auto"},
    {"PlanPredictedByNothing", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: transplanter\nplanner: {predict: none.yaml}\n", "",
     "bad.yaml: line 5: planner.predict: '"},
    {"PlanByCostsThatAreNotThere", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: transplanter\nplanner: {cost: none.yaml}\n", "",
     "none.yaml': no such file"},
    {"CompareByCostsThatAreNotThere", kCompare,
     kComparedMap + "planners: [{name: grid_tplp}]\ncost: none.yaml\n", "",
     "bad.yaml: line 3: cost: '"},
    {"PlanWithTrailedIntoCorners", "plan bad.yaml -o DIR",
     kTinyField + "vehicle: utility_tractor_trailed\nplanner: {headland_corners: covered}\n", "",
     "headland_corners: 'covered': rounded with a trailed implement"},
    {"CompareSharesOfNothing", kCompare,
     kComparedMap + "planners: [{name: grid_tplp, share_2: 0, share_3: 0, share_4: 0}]\n", "",
     "bad.yaml: line 2: planners.share_2: '0': more than 0, or share_3 or share_4 is"},
    {"CompareMapTooLargeForAllPlanners", kCompare,
     "maps: [{generator: {columns: 200, rows: 200}}]\nplanners: [{name: grid_tplp}]\n", "",
     "bad.yaml: planners: none of them can plan any of these: grid plan: map: '35800 free cells': "
     "at most 20000 for this planner, which needs the distances between all of them; "
     "grid_boustrophedon and grid_local_search take more"},
    {"CompareDriveWithoutVehicle", kCompare + " --drive",
     kComparedMap + "planners: [{name: grid_tplp}]\n", "",
     "bad.yaml: drive: the section is missing: --drive needs at least drive.vehicle"},
    {"UnknownSubcommand", "evalute tiny.yaml -o DIR", "", "", "did you mean 'evaluate'?"},
    {"UnknownListing", "list vehicels", "", "", "did you mean 'vehicles'?"},
    {"UnknownOption", "evaluate tiny.yaml --sed 3", "", "",
     "headland: --sed: unknown option; did you mean '--seed'? (see 'headland evaluate --help')"},
    {"UnknownOptionBeforeTheScenario", "drive --tolerence=3 tiny.yaml", "", "",
     "headland: --tolerence: unknown option; did you mean '--tolerance'?"},
    {"MissingOption", "plan tiny.yaml", "", "", "(see 'headland plan --help')"},
    {"NoSubcommand", "", "", "", "--help"},
};

class BadInputTest : public CommandTest, public ::testing::WithParamInterface<BadInput> {};

TEST_P(BadInputTest, IsRefusedInOneLine) {
  const BadInput& bad = GetParam();
  write("bad.yaml", bad.scenario);
  if (!bad.other.empty()) {
    write("other.csv", bad.other);
    write("other.geojson", bad.other);
  }
  const CommandResult result = headland(bad.arguments);
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, ::testing::StartsWith("headland: "));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(bad.message));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR"));
}

INSTANTIATE_TEST_SUITE_P(Every, BadInputTest, ::testing::ValuesIn(kBadInputs),
                         [](const auto& tested) { return tested.param.name; });

class BadOutputTest : public CommandTest {};

TEST_F(BadOutputTest, AFullDiskLeavesNothingHalfWritten) {
  std::filesystem::create_directory(folder_ / "DIR");
  std::filesystem::create_symlink("/dev/full", folder_ / "DIR" / ".path.geojson.partial");
  const CommandResult result = headland("plan tiny.yaml -o DIR");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("No space left on device"));
  EXPECT_TRUE(files_in("DIR").empty());
}

}  // namespace
}  // namespace headland
