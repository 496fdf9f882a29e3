// Sweeps, queries and merges by the real program.
#include <gmock/gmock.h>

#include "tests/apps/command.h"
#include "tests/evaluate/tiny_sweep.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class SweepCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write("tiny.yaml", kTinySweep);
  }
};

TEST_F(SweepCommandTest, SweepsInPartsAndJoinsThem) {
  for (const char* part : {"1", "2"}) {
    const CommandResult result =
        headland(std::string("sweep tiny.yaml --store ") + part + ".db --shard " + part + "/2");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(" runs of 12 in the matrix: 0 were in "));
    EXPECT_EQ(result.err, "");  // no progress into a pipe
  }
  const CommandResult joined = headland("merge all.db 1.db 2.db");
  EXPECT_EQ(joined.exit_code, 0) << joined.err;
  EXPECT_THAT(joined.out, StartsWith("1.db: "));
  EXPECT_EQ(joined.err, "");
  const CommandResult again = headland("sweep tiny.yaml --store all.db");
  EXPECT_THAT(again.out, HasSubstr("12 runs of 12 in the matrix: 12 were in all.db, 0 driven now"));
  const CommandResult query = headland(
      "query all.db --where \"vehicle = 'skid_steer_robot' AND seed < 3\" --columns "
      "soil,seed,outcome");
  EXPECT_EQ(query.out,
            "soil,seed,outcome\nfirm,1,finished\ntilled,1,finished\nfirm,2,finished\n"
            "tilled,2,finished\n");
  EXPECT_EQ(headland("query all.db --columns soil,seed,outcome --where \"vehicle = "
                     "'skid_steer_robot' AND seed < 3\" -o out/runs.csv")
                .exit_code,
            0);
  EXPECT_EQ(text_of(folder_ / "out/runs.csv"), query.out);
  // Cut short by a full disk.
  for (const char* command : {"query all.db", "list planners", "list soils"}) {
    EXPECT_EQ(headland(std::string(command) + " >/dev/full 2>.err #").exit_code, 2) << command;
  }
  EXPECT_THAT(text_of(folder_ / ".err"), HasSubstr("standard output: cannot be written: No space"));
}

TEST_F(SweepCommandTest, RefusesInOneLine) {
  const auto said = [&](const std::string& arguments) {
    const CommandResult result = headland(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_THAT(said("sweep tiny.yaml --store runs.db --shard 3/2"),
              HasSubstr("--shard: '3/2': PART/PARTS is needed"));
  EXPECT_THAT(said("sweep tiny.yaml --store runs.db --jobs 0"), HasSubstr("--jobs: '0'"));
  EXPECT_THAT(said("sweep tiny.yaml --store tiny.yaml"),
              HasSubstr("tiny.yaml: not a store of runs: no SQLite database"));
  EXPECT_THAT(said("sweep tiny.yaml --store no/folder/runs.db"), HasSubstr("no/folder/runs.db: "));
  EXPECT_THAT(said("query absent.db"), HasSubstr("absent.db: "));
  EXPECT_THAT(said("merge out.db absent.db"), HasSubstr("absent.db: "));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.db"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "runs.db"));
}

// A file that may not grow, as on a full disk: told in a line, and what is stored is kept.
TEST_F(SweepCommandTest, TellsOfAFullDisk) {
  write("many.yaml", "seeds: {count: 400}\n" + kTinySweep.substr(kTinySweep.find("fields")));
  const CommandResult result =
      headland("sweep many.yaml --store runs.db", "ulimit -f 100 &&");  // blocks of 512 bytes
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("runs.db"));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(SweepCommandTest, CtrlCKeepsWhatIsDone) {
  write("many.yaml", "seeds: {count: 1000}\n" + kTinySweep.substr(kTinySweep.find("fields")));
  const CommandResult result =
      headland("sweep many.yaml --store runs.db", "timeout --foreground -s INT 3");
  EXPECT_EQ(result.exit_code, 124);  // timeout's own: it had to interrupt
  EXPECT_THAT(result.err, HasSubstr("interrupted; what the finished stages wrote is kept"));
  EXPECT_THAT(result.out, HasSubstr(" runs of 4000 in the matrix"));
}

}  // namespace
}  // namespace headland
