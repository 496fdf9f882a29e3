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
const std::string kTrack = "drive tiny.yaml --path other.csv -o DIR";
const std::string kOnEarth =
    "field: {crs: 'EPSG:4326', boundary: [[9.0, 48.0], [9.001, 48.0], [9.001, 48.0006]]}\n"
    "vehicle: transplanter\nterrain: {file: other.csv}\n";

std::string grid(const std::string& value) {
  return "ncols 2\nnrows 2\nxllcorner 9.0\nyllcorner 48.0\ncellsize 0.0001\nnodata_value -9999\n" +
         value + " 1\n1 1\n";
}

const BadInput kBadInputs[] = {
    {"MissingScenario", "evaluate none.yaml -o DIR", "", "", "none.yaml"},
    {"ScenarioIsAFolder", "evaluate . -o DIR", "", "", "is a folder"},
    {"MalformedYaml", kEvaluate, "field: [1, 2\n", "", "malformed YAML"},
    {"UnknownKey", kEvaluate, kTinyScenario + "sead: 1\n", "", "did you mean 'seed'?"},
    {"MalformedGeoJson", kEvaluate, "field: {file: other.geojson}\nvehicle: transplanter\n",
     "{\"type\":\n\"Polygon\", ,}\n", "other.geojson"},
    {"MalformedCsv", kTrack, "", "x,y\n1,2\n3,four\n", "line 3"},
    {"SelfIntersectingBoundary", kEvaluate, field("[0, 0], [60, 40], [60, 0], [0, 40]"), "",
     "boundary"},
    {"EmptyBoundary", kEvaluate, field(""), "", "boundary"},
    {"HoleOutsideTheField", kEvaluate,
     field(kSquare, ", holes: [[[100, 100], [110, 100], [110, 110]]]"), "", "hole"},
    {"NoCrs", kEvaluate, kOnEarth, grid("1"), "CRS"},
    {"TerrainDoesNotCoverTheField", kEvaluate,
     kOnEarth.substr(0, kOnEarth.rfind('}')) + ", crs: 'EPSG:4326'}\n", grid("1"), "%"},
    {"NodataInsideTheField", kEvaluate,
     "field: {crs: 'EPSG:4326', boundary: [[9.00002, 48.00002], [9.00018, 48.00002], "
     "[9.00018, 48.00018], [9.00002, 48.00018]]}\nvehicle: transplanter\n"
     "terrain: {file: other.csv, crs: 'EPSG:4326'}\n",
     grid("-9999"), "has no data"},
    {"NanParameter", kEvaluate, field(kSquare) + "path: {clearance_m: .nan}\n", "",
     "path.clearance_m"},
    {"NegativeParameter", kEvaluate, kTinyScenario + "implement: {working_width_m: -1}\n", "",
     "working_width_m"},
    {"TerrainRasterTooLarge", kEvaluate,
     field("[0, 0], [900, 0], [900, 900], [0, 900]") + "terrain: {cell_m: 0.01}\n", "", " GB"},
    {"CoverageRasterTooLarge", kEvaluate,
     field("[0, 0], [900, 0], [900, 900], [0, 900]") + "coverage: {cell_m: 0.02}\n", "",
     "bad.yaml: coverage.cell_m: '0.02': 55000 x 55000 cells need 18.2 GB"},
    {"NameTooLong", "render " + std::string(300, 'x'), "", "", "File name too long"},
    {"ImplementWiderThanTheField", kEvaluate,
     field("[0, 0], [30, 0], [30, 24], [0, 24]") + "implement: {working_width_m: 26}\n", "",
     "wider than the field"},
    {"NothingFits", kEvaluate, field("[0, 0], [7, 0], [7, 7], [0, 7]"), "", "turn"},
    {"UnknownPlanner", kEvaluate, kTinyScenario + "planner: {name: boustrofedon}\n", "",
     "boustrophedon"},
    {"UnknownVehicle", kEvaluate, kTinyField + "vehicle: transplantor\n", "",
     "did you mean 'transplanter'?"},
    {"TrackOfOnePoint", kTrack, "", "x,y\n1,2\n", "other.csv"},
    {"TrackOfRepeatedPoints", kTrack, "", "x,y\n1,2\n1,2\n1,2\n", "other.csv"},
    {"TrackWithAJump", kTrack, "", "x,y\n1,2\n2,2\n90000,2\n", "line"},
    {"MissingTrack", "drive tiny.yaml --path none.csv -o DIR", "", "", "none.csv"},
    {"NoPathToDrive", "drive tiny.yaml -o DIR", "", "", "no path to drive"},
    {"NothingToRender", "render none", "", "", "no such file"},
    {"OutputBelowAFile", "evaluate tiny.yaml -o tiny.yaml/DIR", "", "", "is not a folder"},
    {"OutputNotWritable", "plan tiny.yaml -o /proc/headland", "", "", "/proc/headland"},
    {"PictureSize", "evaluate tiny.yaml -o DIR --size 10x10", "", "", "240 to 8192"},
    {"RecordRate", "evaluate tiny.yaml -o DIR --record-hz 1e9", "", "", "--record-hz"},
    {"UnknownSubcommand", "evalute tiny.yaml -o DIR", "", "", "did you mean 'evaluate'?"},
    {"UnknownListing", "list vehicels", "", "", "did you mean 'vehicles'?"},
    {"UnknownOption", "evaluate tiny.yaml -o DIR --sead 3", "", "", "--sead"},
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
