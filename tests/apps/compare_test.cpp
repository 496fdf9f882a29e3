// The comparison from end to end, on tiny maps.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class CompareTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write("drawn.txt", "....\n.#..\n....\n");
    // Few maps: each takes five pictures.
    write("compare.yaml",
          "name: tiny\nrepeats: 6\nstart: north_west\n"
          "maps:\n  - {file: drawn.txt}\n"
          "  - {name: made, generator: {columns: 6, rows: 5, obstacles: 1}}\n"
          "stop: {iterations: 5}\n"
          "planners:\n  - {name: grid_tplp, label: ours}\n  - {name: grid_ga, label: GA}\n"
          "  - {name: grid_boustrophedon, label: rows}\n"
          "tests: {control: ours, blocks: runs}\n");
  }
};

TEST_F(CompareTest, TellsTablesRanksAndTests) {
  const CommandResult result = headland("compare compare.yaml -o DIR");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");  // no progress into a pipe
  EXPECT_THAT(result.out, StartsWith("tiny: 3 planners on 2 maps, 6 repeats, each planner's own "
                                     "end, seed 1\n"));
  EXPECT_THAT(result.out,
              HasSubstr("\ndrawn: 4 x 3 cells of 1 m, 11 free, start [0, 2], end free"));
  EXPECT_THAT(result.out, HasSubstr("  GA: 6 of 6 plans jump between cells"));
  EXPECT_THAT(result.out, HasSubstr("ranks by cost over 12 single runs"));
  EXPECT_THAT(result.out, HasSubstr("Iman and Davenport: F "));
  EXPECT_THAT(result.out, HasSubstr("Bonferroni and Dunn: average ranks "));
  EXPECT_THAT(result.out, HasSubstr("12 runs failed"));
  for (const char* file : {"compare.json", "runs.csv", "table.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "DIR" / file)) << file;
  }
  const auto json = nlohmann::json::parse(text_of(folder_ / "DIR" / "compare.json"));
  EXPECT_EQ(json["runs"].size(), 36U);
  EXPECT_EQ(json["results"].size(), 6U);
  EXPECT_EQ(json["results"][2]["best"]["path"][0], nlohmann::json({0, 2}));
}

TEST_F(CompareTest, ComparesOnFieldsToo) {
  write("fields.yaml",
        "name: tiny fields\nrepeats: 2\nparts: {width_m: 40}\n"
        "fields: [{name: made, count: 2, generator: {parts: 4}}]\nstop: {iterations: 5}\n"
        "planners:\n  - {name: region_iga, label: IGA}\n  - {name: region_exact, label: exact}\n");
  const CommandResult result = headland("compare fields.yaml -o DIR");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("tiny fields: 2 planners on 2 fields, 2 repeats"));
  EXPECT_THAT(result.out, HasSubstr("\nmade_1: 30.00 ha in 4 parts (convex), swaths 40 m wide"));
  EXPECT_THAT(result.out, HasSubstr("\n  least possible, each part along its own edge: "));
  EXPECT_THAT(result.out, HasSubstr("median gap %"));
  for (const char* file : {"compare.json", "runs.csv", "table.csv", "plans_made_1.png",
                           "plan_made_2_IGA.png", "convergence_made_1.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "DIR" / file)) << file;
  }
}

TEST_F(CompareTest, JsonIsTheFileAndNothingElse) {
  write("compare.yaml",
        "repeats: 1\nmaps: [{file: drawn.txt}]\n"
        "planners: [{name: grid_boustrophedon, label: rows}, {name: grid_ga, label: GA}]\n"
        "stop: {iterations: 5}\n");
  const CommandResult result = headland("compare compare.yaml -o DIR --json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, text_of(folder_ / "DIR" / "compare.json"));
  EXPECT_EQ(headland("compare compare.yaml -o DIR -q").out, "");
}

// The same bytes with one job and with two; plans with jumps are not driven.
TEST_F(CompareTest, DrivesTheBestPlans) {
  write("compare.yaml",
        "repeats: 1\nmaps: [{file: drawn.txt, cell_m: 2}]\n"
        "stop: {iterations: 5}\n"
        "planners: [{name: grid_boustrophedon, label: rows}, {name: grid_ga, label: GA}]\n"
        "drive: {vehicle: transplanter}\n");
  const CommandResult one = headland("compare compare.yaml -o DIR --drive --json --jobs 1");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  const auto json = nlohmann::json::parse(one.out);
  EXPECT_EQ(json["comparison"]["drive"]["vehicle"], "transplanter");
  const auto& rows = json["runs"][0]["drive"];
  EXPECT_EQ(rows["outcome"], "finished") << rows;
  EXPECT_THAT(json["runs"][1]["drive"].dump(), HasSubstr("jumps between cells"));
  const auto two =
      nlohmann::json::parse(headland("compare compare.yaml -o DIR --drive --json --jobs 2").out);
  EXPECT_EQ(two["runs"][0]["drive"], rows);
}

// Pictures of a comparison before go, other pictures stay.
TEST_F(CompareTest, ReplacesItsOwnPicturesAlone) {
  ASSERT_EQ(headland("compare compare.yaml -o DIR -q").exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "DIR" / "plan_drawn_ours.png"));
  write("DIR/plan_of_mine.png", "mine");
  write("compare.yaml",
        "repeats: 1\nmaps: [{file: drawn.txt}]\nstop: {iterations: 5}\n"
        "planners: [{name: grid_tplp, label: other}, {name: grid_boustrophedon, label: rows}]\n");
  ASSERT_EQ(headland("compare compare.yaml -o DIR -q").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR" / "plan_drawn_ours.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "DIR" / "plan_drawn_other.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "DIR" / "plan_of_mine.png"));
}

TEST_F(CompareTest, CtrlCKeepsTheRunsThatAreDone) {
  write("compare.yaml",
        "repeats: 1\nmaps: [{generator: {columns: 40, rows: 40}}]\n"
        "stop: {iterations: 100000000}\n"
        "planners: [{name: grid_boustrophedon, label: rows}, {name: grid_iga}]\n");
  // Processor time is what the machine's other work does not change: by then the first run is done.
  constexpr char kInterruptedAt[] =
      "{ (while [ $(cut -d' ' -f14 /proc/$$/stat) -lt 60 ]; do sleep 0.02; done; kill -INT $$) & } "
      "&& exec";
  const CommandResult result = headland("compare compare.yaml -o DIR --jobs 1", kInterruptedAt);
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_THAT(result.err, HasSubstr("headland: interrupted"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "DIR" / "compare.json"));
  EXPECT_EQ(json["results"][0]["runs"]["planned"], 1);
  EXPECT_EQ(json["results"][1]["runs"]["not_run"], 1);
  EXPECT_EQ(json["ranks"]["blocks_left_out"], 1);
}

}  // namespace
}  // namespace headland
