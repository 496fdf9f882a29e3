// headland export: what is written can be audited and planned on; what cannot be written is
// refused.
#include <gmock/gmock.h>

#include <string>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

const std::string kNorthField =
    "name: north\n"
    "field: {crs: 'EPSG:4326', boundary: [[9.0, 48.0], [9.0008, 48.0], [9.0008, 48.0004],\n"
    "  [9.0, 48.0004]]}\nvehicle: transplanter\n";

class ExportTest : public CommandTest {
 protected:
  // One line on standard error, exit code 2.
  std::string refused(const std::string& arguments) const {
    const CommandResult result = headland(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  }
};

TEST_F(ExportTest, EveryFormatIsAuditedAndPlannedOn) {
  write("earth.yaml", kNorthField);
  ASSERT_EQ(headland("plan earth.yaml -o DIR -q").exit_code, 0);
  for (const std::string file : {"a.geojson", "a.csv", "a.kml", "a.gpx", "a.XML"}) {
    const CommandResult made = headland("export DIR -o OUT/" + file);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("m of path as "));
    // Guidance lines are no whole path: they jump from pass to pass.
    const int expected = file == "a.XML" ? 1 : 0;
    const CommandResult audit = headland("audit earth.yaml --path OUT/" + file);
    EXPECT_EQ(audit.exit_code, expected) << file << audit.out << audit.err;
  }
  EXPECT_EQ(files_in("OUT"),
            (std::set<std::string>{"a.geojson", "a.csv", "a.kml", "a.gpx", "a.XML"}));
  EXPECT_EQ(text_of(folder_ / "OUT/a.geojson"), text_of(folder_ / "DIR/path.geojson"));
  for (const std::string file : {"a.kml", "a.XML"}) {
    write("again.yaml", "field: {file: OUT/" + file + "}\nvehicle: transplanter\n");
    const CommandResult planned = headland("plan again.yaml -o AGAIN --json");
    EXPECT_EQ(planned.exit_code, 0) << planned.err;
    EXPECT_THAT(planned.out, HasSubstr("\"field_area_m2\": 265"));
  }
  // The path file itself will do, and a scenario from elsewhere.
  EXPECT_EQ(headland("export DIR/path.geojson -o b.csv -q").exit_code, 0);
  EXPECT_EQ(headland("export OUT/a.csv --scenario earth.yaml -o c.geojson").exit_code, 0);
  EXPECT_EQ(text_of(folder_ / "b.csv"), text_of(folder_ / "OUT/a.csv"));
}

TEST_F(ExportTest, AFieldWithoutAPlaceNeedsAnOrigin) {
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  EXPECT_THAT(refused("export DIR -o a.kml"), HasSubstr("with --origin LON,LAT"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.kml"));
  EXPECT_EQ(headland("export DIR -o a.kml --origin 9.5,48.25").exit_code, 0);
  EXPECT_THAT(text_of(folder_ / "a.kml"), HasSubstr("9.50"));
  EXPECT_THAT(refused("export DIR -o a.gpx --origin 9.5"), HasSubstr("--origin: '9.5': LON,LAT"));
  EXPECT_THAT(refused("export DIR -o a.gpx --origin 48.25,95"), HasSubstr("from -85 to 85"));
  EXPECT_THAT(refused("export DIR -o a.gpx --origin nan,nan"), HasSubstr("--origin"));
  EXPECT_EQ(headland("export DIR -o a.csv").exit_code, 0);
}

TEST_F(ExportTest, WhatCannotBeWrittenIsRefused) {
  write("earth.yaml", kNorthField);
  ASSERT_EQ(headland("plan earth.yaml -o DIR -q").exit_code, 0);
  EXPECT_THAT(refused("export DIR -o a.foo"), HasSubstr("give --format, one of geojson, kml"));
  EXPECT_THAT(refused("export DIR -o a.kml --format pdf"), HasSubstr("--format: 'pdf': one of"));
  EXPECT_THAT(refused("export DIR -o a.kml --origin 9,48"), HasSubstr("this one has its own"));
  EXPECT_THAT(refused("export none -o a.kml"), HasSubstr("none: no such file"));
  EXPECT_THAT(refused("export tiny.yaml -o a.kml"), HasSubstr("scenario.yaml: no such file"));
  EXPECT_THAT(refused("export tiny.yaml --scenario tiny.yaml -o a.csv"),
              HasSubstr("is not a path that headland wrote"));
  EXPECT_THAT(refused("export DIR -o earth.yaml/a.kml"), HasSubstr("is not a folder"));
  EXPECT_THAT(refused("export DIR -o ''"), HasSubstr("--output: the value is empty"));
  EXPECT_THAT(refused("audit earth.yaml --part x --path DIR/path.geojson"),
              HasSubstr("--part: 'x': goes with --field"));
}

TEST_F(ExportTest, PartsAreOfFiles) {
  std::string inline_part = kTinyScenario;
  inline_part.replace(inline_part.find("field: {"), 8, "field: {part: a, ");
  write("bad.yaml", inline_part);
  EXPECT_THAT(refused("plan bad.yaml -o DIR"),
              HasSubstr("bad.yaml: line 1: field.part: only with field.file"));
}

}  // namespace
}  // namespace headland
