// headland tune and the weights it writes, by the real program.
#include <gmock/gmock.h>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

const std::string kTraining = "training: {fields: {square: {grid_map: square.txt}}}\n";
const std::string kHeldOut = "held_out: {fields: {hook: {grid_map: hook.txt}}}\n";

class TuneCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write("square.txt", "....\n....\n....\n");
    write("hook.txt", "....\n.#..\n....\n");
    write("tune.yaml", "vehicle: transplanter\n" + kTraining + kHeldOut);
  }
  std::string said(const std::string& arguments) const {
    const CommandResult result = headland(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  }
};

TEST_F(TuneCommandTest, RefusesInOneLineAndWritesNothing) {
  write("alone.yaml", "vehicle: transplanter\n" + kTraining);
  EXPECT_THAT(said("tune alone.yaml -o out"), HasSubstr("alone.yaml: line 1: held_out: missing"));
  EXPECT_THAT(said("tune tune.yaml -o out --jobs 0"), HasSubstr("--jobs: '0'"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  EXPECT_THAT(said("tune tune.yaml -o out --store square.txt"),
              HasSubstr("square.txt: not a store of runs"));
}

TEST_F(TuneCommandTest, PlansByWeights) {
  write("weights.yaml", "cost: {objective: weighted, repeat: 1, turn: 2, u_turn: 4}\n");
  write(
      "map.yaml",
      "vehicle: transplanter\nfield: {grid_map: hook.txt}\nplanner: {name: grid_boustrophedon}\n");
  const CommandResult planned = headland("plan map.yaml --weights weights.yaml -o out");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(text_of(folder_ / "out/scenario.yaml"), HasSubstr("u_turn: 4"));
  EXPECT_THAT(said("plan tiny.yaml --weights weights.yaml -o out2"),
              HasSubstr("only for planners on grid maps"));
  EXPECT_THAT(said("plan map.yaml --weights weights.yaml --cost weights.yaml -o out2"),
              HasSubstr("--weights: 'weights.yaml': not with --cost"));
}

}  // namespace
}  // namespace headland
