#include "evaluate/run_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <limits>
#include <string>

#include "evaluate/digest.h"
#include "evaluate/run_claims.h"
#include "evaluate/run_query.h"
#include "evaluate/run_store_tables.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class Store : public ScratchFolder {
 protected:
  StoredRun run_of(int number) const {
    StoredRun stored;
    stored.key = digest_of(std::to_string(number));
    stored.scenario = "seed: " + std::to_string(number) + "\n";
    stored.run.figures[run_figure_place("energy_wh")] = number + 0.25;
    return stored;
  }

  // Runs from `first` on, and a sweep of them.
  void fill(const std::string& name, int first, int count) const {
    RunStore store;
    open_run_store(path(name), DatabaseMode::kWrite, store);
    std::vector<SweepCell> cells;
    for (int i = first; i < first + count; ++i) {
      keep_run(store, run_of(i));
      cells.push_back({"field", "flat", "firm", "robot, small", "rows", 1, run_of(i).key});
    }
    keep_cells(store, "sweep", cells);
  }

  std::string energies(const std::string& name, const std::string& where = "") const {
    return query_runs(path(name), {{"energy_wh"}, where});
  }

  std::string refused_where(const std::string& where) const {
    return refusal([&] { static_cast<void>(energies("runs.db", where)); });
  }

  void change(const std::string& name, const std::string& sql) const {
    execute(open_database(path(name), DatabaseMode::kWrite), sql);
  }

  std::string refused(const std::string& name) const {
    RunStore store;
    return refusal([&] { open_run_store(path(name), DatabaseMode::kWrite, store); });
  }
};

TEST_F(Store, GivesBackWhatItWasGiven) {
  fill("runs.db", 1, 3);
  EXPECT_EQ(energies("runs.db"), "energy_wh\n1.25\n2.25\n3.25\n");
  EXPECT_EQ(energies("runs.db", "energy_wh > 2 AND state = 'driven'"), "energy_wh\n2.25\n3.25\n");
  EXPECT_EQ(
      query_runs(path("runs.db"), {{"vehicle", "seed", "outcome", "verdict"}, "energy_wh < 2"}),
      "vehicle,seed,outcome,verdict\n\"robot, small\",1,finished,FAIL\n");
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kRead, store);
  EXPECT_TRUE(holds_run(store, run_of(2).key));
  EXPECT_FALSE(holds_run(store, run_of(4).key));
}

// A number that is none is empty, not 0, and a cell without a run is told.
TEST_F(Store, KeepsWhatIsNotKnownApartFromZero) {
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  StoredRun diverged = run_of(1);
  diverged.run.outcome = Outcome::kDiverged;
  diverged.run.figures[run_figure_place("energy_wh")] = std::numeric_limits<double>::quiet_NaN();
  StoredRun refused = run_of(2);
  refused.run = EvaluatedRun{};
  refused.run.end = RunEnd::kNoPlan;
  refused.run.reason = "too narrow, \"really\"";
  keep_run(store, diverged);
  keep_run(store, refused);
  std::vector<SweepCell> cells(3);
  for (int i = 0; i < 3; ++i) cells[static_cast<std::size_t>(i)].key = run_of(i + 1).key;
  keep_cells(store, "sweep", cells);
  EXPECT_EQ(query_runs(path("runs.db"), {{"state", "outcome", "energy_wh", "reason"}, ""}),
            "state,outcome,energy_wh,reason\n"
            "driven,diverged,,\n"
            "no plan,,,\"too narrow, \"\"really\"\"\"\n"
            "not run,,,\n");
}

TEST_F(Store, KeepsTheFirstOfTwoRunsWithOneKey) {
  fill("runs.db", 1, 1);
  StoredRun other = run_of(1);
  other.run.figures[run_figure_place("energy_wh")] = 9.0;
  {
    RunStore store;
    open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
    keep_run(store, other);
  }
  EXPECT_EQ(energies("runs.db"), "energy_wh\n1.25\n");
}

TEST_F(Store, ColumnsOfTheViewAreThoseThatAreListed) {
  fill("runs.db", 1, 1);
  const std::string csv = query_runs(path("runs.db"), {{"all"}, ""});
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(std::count(header.begin(), header.end(), ',') + 1,
            static_cast<std::ptrdiff_t>(stored_run_columns().size()));
  EXPECT_THAT(header, HasSubstr("energy_wh,energy_wh_per_ha"));
}

TEST_F(Store, RefusesWhatIsNone) {
  written("notes.txt", "a text that is longer than the head of a database would be");
  EXPECT_THAT(refused("notes.txt"),
              HasSubstr("notes.txt: not a store of runs: no SQLite database"));
  change("other.db", "CREATE TABLE something (x)");
  EXPECT_THAT(refused("other.db"), HasSubstr("a SQLite database, but not a store of runs"));
  fill("old.db", 1, 1);
  change("old.db", "PRAGMA user_version = 7");
  EXPECT_THAT(refused("old.db"), HasSubstr("'tables 0000007': a store of another version"));
  std::filesystem::create_directory(path("folder"));
  EXPECT_THAT(refused("folder"), HasSubstr("folder: "));
  EXPECT_THAT(refusal([&] { static_cast<void>(energies("absent.db")); }), HasSubstr("absent.db: "));
  EXPECT_FALSE(std::filesystem::exists(path("absent.db")));
}

TEST_F(Store, BlamesADamagedFileAndNoCondition) {
  fill("runs.db", 1, 2);
  EXPECT_EQ(energies("runs.db", "seed > 0"), "energy_wh\n1.25\n2.25\n");
  constexpr std::size_t kPage = 4096;  // SQLite's, of which the first tells the tables
  const std::size_t bytes = std::filesystem::file_size(path("runs.db"));
  std::fstream file(path("runs.db"), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(kPage);
  file << std::string(bytes - kPage, '\xff');
  file.close();
  EXPECT_THAT(refused_where("seed > 0"), HasSubstr("runs.db: database disk image is malformed"));
  EXPECT_THAT(refused_where(""), HasSubstr("runs.db: database disk image is malformed"));
}

TEST_F(Store, ConditionsReadAndDoNothingElse) {
  fill("runs.db", 1, 2);
  for (const char* where :
       {"1); DROP TABLE results; --", "1) UNION SELECT scenario FROM scenarios --",
        "key IN (SELECT scenario FROM scenarios)", "(SELECT count(*) FROM sqlite_schema)",
        "load_extension('x')", "energy_wh >", "no_such_column = 1"}) {
    EXPECT_THAT(refused_where(where), StartsWith("--where: ")) << where;
  }
  EXPECT_THAT(refused_where("key IN (SELECT scenario FROM scenarios)"),
              HasSubstr("may read them and nothing else"));
  EXPECT_EQ(energies("runs.db", "1 -- a comment"), "energy_wh\n1.25\n2.25\n");
  EXPECT_THAT(refusal([&] {
                query_runs(path("runs.db"), {{"energy"}, ""});
              }),
              HasSubstr("--columns: 'energy': unknown column; did you mean '"));
}

// The limit on the size of files stands in for a disk that is full.
TEST_F(Store, OnAFullDiskWhatIsThereStays) {
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  struct rlimit unlimited {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &unlimited), 0);
  struct rlimit limited = unlimited;
  limited.rlim_cur = 400'000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limited), 0);
  int kept = 0;
  const std::string said = refusal([&] {
    for (; kept < 1000; ++kept) keep_run(store, run_of(kept));
  });
  setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(said, HasSubstr("runs.db: "));
  EXPECT_GT(kept, 5);
  EXPECT_LT(kept, 1000);
  for (int i = 0; i < kept; ++i) EXPECT_TRUE(holds_run(store, run_of(i).key)) << i;
  EXPECT_FALSE(holds_run(store, run_of(kept).key));
  keep_run(store, run_of(kept));  // there is room again
  EXPECT_TRUE(holds_run(store, run_of(kept).key));
}

TEST_F(Store, TakesWhatTwoProgramsWriteAtOnce) {
  constexpr int kEach = 40;
  std::vector<pid_t> writers;
  for (int first : {0, kEach}) {
    writers.push_back(fork());
    if (writers.back() != 0) continue;
    // Both make the store, or find it half made.
    RunStore store;
    open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
    for (int i = first; i < first + kEach; ++i) keep_run(store, run_of(i));
    _exit(0);
  }
  for (const pid_t writer : writers) {
    int status = 0;
    waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
  }
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  for (int i = 0; i < 2 * kEach; ++i) EXPECT_TRUE(holds_run(store, run_of(i).key)) << i;
}

TEST_F(Store, JoinsOthers) {
  fill("a.db", 1, 3);
  fill("b.db", 3, 2);
  change("b.db", "UPDATE results SET energy_wh = 77 WHERE energy_wh = 3.25");
  change("b.db", "UPDATE results SET drive_s = 5");  // seconds differ from drive to drive
  change("b.db", "UPDATE cells SET sweep = 'other'");
  {
    RunStore store;
    open_run_store(path("a.db"), DatabaseMode::kWrite, store);
    const MergeCounts counts = merge_run_store(store, path("b.db"));
    EXPECT_EQ(counts.runs, 1);
    EXPECT_EQ(counts.known, 1);
    EXPECT_EQ(counts.different, 1);
    EXPECT_EQ(merge_run_store(store, path("b.db")).runs, 0);
  }
  EXPECT_EQ(query_runs(path("a.db"), {{"sweep", "energy_wh"}, ""}),
            "sweep,energy_wh\nother,3.25\nother,4.25\nsweep,1.25\nsweep,2.25\nsweep,3.25\n");
}

TEST_F(Store, ARunIsClaimedOnce) {
  const std::string one = digest_of("one");
  const std::string other = digest_of("other");
  RunClaims here(path("runs.db"));
  {
    RunClaims there(path("runs.db"));
    EXPECT_TRUE(here.claim(one));
    EXPECT_FALSE(there.claim(one));
    EXPECT_TRUE(there.claim(other));
    EXPECT_FALSE(here.claim(other));
    here.release(one);
    EXPECT_TRUE(there.claim(one));
  }
  // Gone with whoever had them.
  EXPECT_TRUE(here.claim(one));
  EXPECT_TRUE(here.claim(other));
}

// FIPS 180-4's own example, cut.
TEST(DigestOf, IsSha256) { EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223"); }

}  // namespace
}  // namespace headland
