// headland job: several fields as one path, which the other commands go on with.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

const std::string kTwoFields =
    "fields:\n"
    "  - {name: a, field: {boundary: [[0, 0], [20, 0], [20, 18], [0, 18]]}, gates: [[20, 9]]}\n"
    "  - {name: b, field: {boundary: [[30, 0], [50, 0], [50, 18], [30, 18]]}, gates: [[30, 9]]}\n"
    "simulation: {record_hz: 2}\ncoverage: {cell_m: 0.5}\nvehicle: transplanter\n";

class JobTest : public CommandTest {};

TEST_F(JobTest, IsPlannedAndGoneOnWith) {
  write("job.yaml", kTwoFields);
  const CommandResult planned = headland("job job.yaml -o DIR");
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("transit "));
  EXPECT_THAT(planned.out, HasSubstr("audit: PASS, 0 places"));
  EXPECT_EQ(files_in("DIR"),
            (std::set<std::string>{"scenario.yaml", "plan.geojson", "path.geojson", "job.json"}));
  EXPECT_EQ(headland("audit DIR/scenario.yaml --path DIR/path.geojson").exit_code, 0);
  EXPECT_EQ(headland("export DIR -o job.csv").exit_code, 0);
  EXPECT_EQ(headland("export DIR -o job.kml --origin 9,52").exit_code, 0);
  // Another plan in the folder is no job any more.
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  EXPECT_EQ(files_in("DIR").count("job.json"), 0U);
}

TEST_F(JobTest, IsDrivenAsOne) {
  write("job.yaml", kTwoFields);
  const CommandResult driven = headland("job job.yaml -o DIR --drive --json --size 640x400");
  // Fields as small as these have much of their ground in corners.
  ASSERT_LE(driven.exit_code, 1) << driven.err;
  const auto json = nlohmann::json::parse(driven.out);
  ASSERT_EQ(json["parts"].size(), 3U);
  EXPECT_EQ(json["parts"][1]["kind"], "transit");
  for (const auto& part : json["parts"]) {
    EXPECT_GT(part["driven"]["battery_wh"].get<double>(), 0.0);
    // Within a tenth of a second's speed changes and the tracking error.
    EXPECT_NEAR(part["driven"]["distance_m"].get<double>(), part["length_m"].get<double>(),
                0.02 * part["length_m"].get<double>());
  }
  EXPECT_EQ(nlohmann::json::parse(text_of(folder_ / "DIR/job.json")), json);
  const auto metrics = nlohmann::json::parse(text_of(folder_ / "DIR/metrics.json"));
  EXPECT_EQ(metrics["outcome"]["name"], "finished");
  EXPECT_NEAR(metrics["figures"]["workable_m2"].get<double>(), 2 * 20.0 * 18.0, 1e-6);
}

TEST_F(JobTest, TheExampleRuns) {
  const CommandResult planned =
      headland("job '" HEADLAND_SOURCE_DIR "/examples/job.yaml' -o DIR --json");
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_TRUE(nlohmann::json::parse(planned.out)["audit"]["passes"]);
}

TEST_F(JobTest, BadJobsLeaveNothing) {
  write("job.yaml", kTwoFields + "roads: [[[0, 60], [9, 60]]]\n");
  const CommandResult refused = headland("job job.yaml -o DIR");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("job.yaml: line 2: fields: gates: "));
  EXPECT_THAT(refused.err, HasSubstr("no road comes nearer than 30 m; draw one to it"));
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR"));
  EXPECT_EQ(headland("job none.yaml -o DIR").exit_code, 2);
  EXPECT_THAT(headland("job tiny.yaml -o DIR").err, HasSubstr("unknown key"));
}

}  // namespace
}  // namespace headland
