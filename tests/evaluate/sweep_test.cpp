#include "evaluate/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>

#include "evaluate/digest.h"
#include "evaluate/run_figures.h"
#include "evaluate/run_query.h"
#include "evaluate/sweep_keys.h"
#include "tests/evaluate/tiny_sweep.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

class SweepTest : public ScratchFolder {
 protected:
  Sweep tiny() const { return read_sweep(written("tiny.yaml", kTinySweep)); }

  SweepResult swept(const std::string& store_name, const ParallelOptions& options = {},
                    const Shard& shard = {}) const {
    RunStore store;
    open_run_store(path(store_name), DatabaseMode::kWrite, store);
    return run_sweep(tiny(), store, shard, options);
  }

  // Everything but the seconds.
  std::string table(const std::string& store_name) const {
    RunQuery query;
    query.columns = {"field", "terrain", "soil",    "vehicle",        "planner", "seed",
                     "key",   "state",   "outcome", "outcome_detail", "verdict", "reason"};
    for (const std::string& key : run_figure_keys()) {
      if (key != kPlanSeconds && key != kDriveSeconds) query.columns.push_back(key);
    }
    return query_runs(path(store_name), query);
  }

  std::int64_t runs_in(const std::string& store_name) const {
    if (!std::filesystem::exists(path(store_name))) return 0;
    const Database database = open_database(path(store_name), DatabaseMode::kWrite);
    if (whole_number_of(database, "SELECT count(*) FROM sqlite_schema") == 0) return 0;
    return whole_number_of(database, "SELECT count(*) FROM results");
  }

  std::string refused(const std::string& text) const {
    const std::string file = written("bad.yaml", text).string();
    const std::string said = refusal([&] { read_sweep(file); });
    return said.starts_with(file) ? said.substr(file.size() + 2) : said;
  }
};

TEST_F(SweepTest, DrivesEveryRunOnceAndTellsOfThoseItCannot) {
  const SweepResult first = swept("runs.db");
  EXPECT_EQ(first.cells, static_cast<std::size_t>(kTinyRuns));
  EXPECT_EQ(first.runs, static_cast<std::size_t>(kTinyRuns));
  EXPECT_EQ(first.known, 0U);
  EXPECT_EQ(first.driven, static_cast<std::size_t>(kTinyDriven));
  EXPECT_EQ(first.no_plan, static_cast<std::size_t>(kTinyRuns - kTinyDriven));
  ASSERT_FALSE(first.refusals.empty());
  EXPECT_THAT(first.refusals[0].why, HasSubstr("the turning radius fits nowhere"));
  EXPECT_TRUE(first.failed.empty());
  const std::string one = table("runs.db");
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), kTinyRuns + 1);

  const SweepResult second = swept("runs.db");
  EXPECT_EQ(second.known, static_cast<std::size_t>(kTinyRuns));
  EXPECT_EQ(second.driven + second.no_plan, 0U);
  EXPECT_EQ(table("runs.db"), one);
}

// The sweep's numbers are those of the scenario it keeps.
TEST_F(SweepTest, ARunIsThatOfItsScenario) {
  swept("runs.db");
  const Database database = open_database(path("runs.db"), DatabaseMode::kWrite);
  const Statement row =
      prepare(database,
              "SELECT scenario, energy_wh, path_length_m, rolling_resistance_wh, swath_count FROM "
              "scenarios JOIN results USING (key) WHERE state = 'driven' LIMIT 1 OFFSET 3");
  ASSERT_TRUE(step(row));
  const Scenario scenario = read_scenario(written("again.yaml", text_at(row, 0)));
  SharedPlan plan;
  const auto run = evaluate_run(scenario, plan, {});
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->figures[run_figure_place("energy_wh")], number_at(row, 1));
  EXPECT_EQ(run->figures[run_figure_place("path_length_m")], number_at(row, 2));
  EXPECT_EQ(run->figures[run_figure_place("rolling_resistance_wh")], number_at(row, 3));
  EXPECT_EQ(run->figures[run_figure_place("swath_count")], number_at(row, 4));
}

TEST_F(SweepTest, IsTheSameWithAnyNumberOfJobsAndInParts) {
  swept("one.db", {1, {}, {}});
  swept("three.db", {3, {}, {}});
  EXPECT_EQ(table("three.db"), table("one.db"));
  std::size_t runs = 0;
  for (int part = 1; part <= 3; ++part) {
    runs += swept("part_" + std::to_string(part), {}, {part, 3}).runs;
  }
  EXPECT_EQ(runs, static_cast<std::size_t>(kTinyRuns));
  RunStore joined;
  open_run_store(path("joined.db"), DatabaseMode::kWrite, joined);
  for (int part = 1; part <= 3; ++part) {
    merge_run_store(joined, path("part_" + std::to_string(part)));
  }
  EXPECT_EQ(table("joined.db"), table("one.db"));
}

TEST_F(SweepTest, PartsTakeEveryRunOnceWhateverTheirNumber) {
  for (const int parts : {1, 2, 7}) {
    for (int i = 0; i < 100; ++i) {
      int in = 0;
      for (int part = 1; part <= parts; ++part) {
        in += is_in({part, parts}, digest_of(std::to_string(i))) ? 1 : 0;
      }
      EXPECT_EQ(in, 1) << parts << " " << i;
    }
  }
}

TEST_F(SweepTest, EndsEarlyAndGoesOnWhereItWas) {
  std::atomic<int> done = 0;
  ParallelOptions options;
  options.progress = [&](int count, int) { done = count; };
  options.cancelled = [&] { return done >= 5; };
  const SweepResult first = swept("runs.db", options);
  EXPECT_TRUE(first.ended_early);
  EXPECT_EQ(first.driven + first.no_plan, 5U);
  EXPECT_THAT(table("runs.db"), HasSubstr(",not run,"));
  EXPECT_EQ(swept("runs.db").known, 5U);
  swept("whole.db");
  EXPECT_EQ(table("runs.db"), table("whole.db"));
}

// Counts of the runs that children have told of, in memory that outlives them.
struct Told {
  std::atomic<int>* count =
      static_cast<std::atomic<int>*>(mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                                          MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  ~Told() { munmap(count, sizeof(std::atomic<int>)); }
};

TEST_F(SweepTest, TwoProgramsDriveNothingTwice) {
  const Told told;
  std::vector<pid_t> programs;
  for (int i = 0; i < 2; ++i) {
    programs.push_back(fork());
    if (programs.back() != 0) continue;
    const SweepResult result = swept("runs.db");
    *told.count += static_cast<int>(result.driven + result.no_plan);
    // Neither ends before the last run is there.
    _exit(runs_in("runs.db") == kTinyRuns ? 0 : 1);
  }
  for (const pid_t program : programs) {
    int status = 0;
    waitpid(program, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(*told.count, kTinyRuns);
  swept("alone.db");
  EXPECT_EQ(table("runs.db"), table("alone.db"));
}

// Killed 50 times at moments drawn by a fixed seed. A sweep that comes to its end before its kill
// is compared and begun anew, so that kills fall everywhere.
TEST_F(SweepTest, KilledAnywhereEndsWithTheSameTable) {
  constexpr int kKills = 50;
  const auto begun = std::chrono::steady_clock::now();
  swept("undisturbed.db", {2, {}, {}});
  const auto undisturbed = std::chrono::steady_clock::now() - begun;
  const std::string whole = table("undisturbed.db");
  std::mt19937 random(20250101);
  // A third of the whole sweep at first: most are killed several times. How long that takes depends
  // on what else the machine does, so that kills come later where they stop all, and sooner where
  // they stop none.
  double longest_us = 0.35 * std::chrono::duration<double, std::micro>(undisturbed).count();
  constexpr double kLater = 1.3;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int kills = 0;
  int kills_amid = 0;  // with some runs there, and some not
  int known = 0;
  while (kills < kKills) {
    const Told told;
    const pid_t program = fork();
    if (program == 0) {
      ParallelOptions options;
      options.jobs = 2;
      options.progress = [&](int done, int) { *told.count = done; };
      swept("runs.db", options);
      _exit(0);
    }
    usleep(static_cast<useconds_t>(share(random) * longest_us));
    kill(program, SIGKILL);
    int status = 0;
    waitpid(program, &status, 0);
    const int there = static_cast<int>(runs_in("runs.db"));
    // All that it had told of, and all that was there before it.
    EXPECT_GE(there, known + *told.count);
    if (there == known) longest_us *= kLater;
    known = there;
    if (WIFSIGNALED(status)) {
      ++kills;
      kills_amid += there > 0 && there < kTinyRuns ? 1 : 0;
      continue;
    }
    longest_us /= kLater;
    EXPECT_EQ(table("runs.db"), whole);
    for (const char* file : {"runs.db", "runs.db-wal", "runs.db-shm"}) {
      std::filesystem::remove(path(file));
    }
    known = 0;
  }
  EXPECT_GT(kills_amid, 5);
  swept("runs.db", {2, {}, {}});
  EXPECT_EQ(table("runs.db"), whole);
}

TEST_F(SweepTest, LabelsForOneRunCountOnce) {
  std::string text = kTinySweep;
  const std::string soils = "soils: [firm, tilled]\n";
  text.replace(text.find(soils), soils.size(), "soils: {a: firm, b: {name: firm}}\n");
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  const SweepResult result = run_sweep(read_sweep(written("two.yaml", text)), store, {}, {});
  EXPECT_EQ(result.cells, static_cast<std::size_t>(kTinyRuns));
  EXPECT_EQ(result.runs, static_cast<std::size_t>(kTinyRuns / 2));
  EXPECT_EQ(query_runs(path("runs.db"), {{"soil"}, "seed = 2 AND state = 'driven'"}),
            "soil\na\nb\n");
}

TEST_F(SweepTest, SeedsReachTerrainPositioningAndPlanner) {
  const Sweep sweep = tiny();
  const Scenario scenario = scenario_at(sweep, cell_count(sweep) - 1);
  EXPECT_EQ(scenario.seed, 3U);
  EXPECT_EQ(scenario.terrain.seed, 3U);
  EXPECT_EQ(scenario.simulation.positioning.seed, 3U);
  EXPECT_EQ(scenario.vehicle, "horticultural_tractor");
  EXPECT_EQ(scenario.soil.soil.name, "tilled");
  EXPECT_EQ(scenario.coverage_cell_m, 1.0);
  EXPECT_TRUE(scenario.path.allow_overrun);
}

const std::string kNeeded =
    "fields: {one: {boundary: [[0, 0], [9, 0], [9, 9]]}}\n"
    "vehicles: [transplanter]\n"
    "planners: [boustrophedon]\n";

TEST_F(SweepTest, RefusesWhatMakesNoMatrix) {
  EXPECT_EQ(refused(kNeeded), "accepted");
  EXPECT_THAT(refused(kNeeded + "soil: firm\n"),
              HasSubstr("line 4: soil: unknown key; did you mean 'soils'?"));
  EXPECT_THAT(refused("vehicles: [transplanter]\nplanners: [boustrophedon]\n"),
              HasSubstr("fields: labels with a scenario's field each, or a list of words"));
  EXPECT_THAT(refused(kNeeded + "planners: [boustrophedon]\n"),
              HasSubstr("planners: the key is given twice"));
  EXPECT_THAT(refused(kNeeded + "soils: [firm, firm]\n"),
              HasSubstr("line 4: soils: 'firm': the label stands twice"));
  EXPECT_THAT(refused(kNeeded + "soils: [firn]\n"),
              HasSubstr("line 4: soil: 'firn': unknown soil"));
  EXPECT_THAT(refused(kNeeded + "terrains:\n  hills: {amplitude_m: 2}\n"),
              HasSubstr("line 5: terrain: generator or file is needed"));
  EXPECT_THAT(refused(kNeeded + "terrains:\n  hills: {generator: rolling, amplitud_m: 2}\n"),
              HasSubstr("line 5: terrain.amplitud_m: unknown key; did you mean 'amplitude_m'?"));
  EXPECT_THAT(refused("planners: {mine: {headland_passes: 2}}\n" +
                      kNeeded.substr(0, kNeeded.find("planners"))),
              HasSubstr("line 1: planner: name is needed"));
  EXPECT_THAT(refused(kNeeded + "seeds: [1, 1]\n"), HasSubstr("line 4: seeds: "));
  EXPECT_THAT(refused(kNeeded + "seeds: {first: 3}\n"),
              HasSubstr("seeds.count: how many seeds is missing"));
  EXPECT_THAT(refused(kNeeded + "seeds: {count: 2000000}\n"), HasSubstr("seeds.count: '2000000'"));
  EXPECT_THAT(refused("fields: {one: {boundary: [[0, 0], [9, 0], [9, 9]]}}\n"
                      "vehicles: {mine: {vehicle: transplantr}}\nplanners: [boustrophedon]\n"),
              HasSubstr("line 2: vehicle: 'transplantr': unknown vehicle"));
  EXPECT_THAT(refused(kNeeded + "path: {file: track.csv}\n"), HasSubstr("no track"));
}

TEST(SweepDocs, NameEveryKeyAndColumn) {
  std::ifstream file(HEADLAND_SOURCE_DIR "/docs/sweep.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& key : sweep_key_paths()) EXPECT_THAT(text, HasSubstr("`" + key + "`"));
  for (const std::string& key : run_figure_keys()) EXPECT_THAT(text, HasSubstr("`" + key + "`"));
}

TEST(SweepDocs, TheExampleIsRead) {
  EXPECT_EQ(cell_count(read_sweep(HEADLAND_SOURCE_DIR "/examples/sweep.yaml")), 64U);
}

}  // namespace
}  // namespace headland
