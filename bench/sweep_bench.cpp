// Sweeps of runs on one hectare: what a second job gains, what the store costs, how long queries
// take. Others may use the machine at the same time: runs with one job and with two alternate, and
// processor time is compared, not the clock's alone. Usage: sweep_bench [RUNS] [--json]
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bench/figures.h"
#include "bench/scratch.h"
#include "evaluate/run_claims.h"
#include "evaluate/run_key.h"
#include "evaluate/run_query.h"
#include "evaluate/run_store_tables.h"
#include "evaluate/sweep.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 1000;
constexpr int kRounds = 10;
constexpr int kStored = 100000;

std::string spec(int first_seed, int runs) {
  return fmt::format(
      "name: from {0}\nseeds: {{first: {0}, count: {1}}}\n"
      "fields: {{hectare: {{boundary: [[0, 0], [100, 0], [100, 100], [0, 100]]}}}}\n"
      "terrains: {{rolling: {{generator: rolling}}}}\n"
      "vehicles: [utility_tractor]\nplanners: [boustrophedon]\n",
      first_seed, runs);
}

double processor_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// Seconds that the program's threads ran or waited for a processor.
double wanted_s() {
  double sum_ns = 0.0;
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    double run_ns = 0.0;
    double wait_ns = 0.0;
    std::ifstream(task.path() / "schedstat") >> run_ns >> wait_ns;
    sum_ns += run_ns + wait_ns;
  }
  return 1e-9 * sum_ns;
}

struct Rate {
  int runs = 0;
  double wall_s = 0.0;
  double processor_s = 0.0;
  double wanted_s = 0.0;
};

struct Bench {
  Scratch scratch{"sweep-bench"};
  int next_seed = 1;

  Sweep next_sweep(int runs) {
    const fs::path file = scratch.folder / "sweep.yaml";
    std::ofstream(file) << spec(next_seed, runs);
    next_seed += runs;
    return read_sweep(file);
  }
};

void add_runs(Bench& bench, RunStore& store, int jobs, int runs, Rate& rate) {
  const Sweep sweep = bench.next_sweep(runs);
  const auto begun = std::chrono::steady_clock::now();
  const double processor = processor_s();
  const double wanted = wanted_s();
  ParallelOptions options;
  options.jobs = jobs;
  const SweepResult result = run_sweep(sweep, store, {}, options);
  rate.runs += static_cast<int>(result.driven);
  rate.wall_s += seconds_since(begun);
  rate.processor_s += processor_s() - processor;
  rate.wanted_s += wanted_s() - wanted;
}

void add_throughput(Bench& bench, int runs, std::vector<Figure>& figures) {
  RunStore store;
  open_run_store(bench.scratch.folder / "runs.db", DatabaseMode::kWrite, store);
  Rate one;
  Rate two;
  const int each = std::max(1, runs / (2 * kRounds));
  for (int round = 0; round < kRounds; ++round) {
    add_runs(bench, store, 1, each, one);
    add_runs(bench, store, 2, each, two);
  }
  const double of_one_s = one.processor_s / one.runs;
  const double of_two_s = two.processor_s / two.runs;
  const double busy = two.wanted_s / (2.0 * two.wall_s);
  figures.push_back({"runs of 1 ha, half with one job, half with two",
                     static_cast<double>(one.runs + two.runs), "", "1000"});
  figures.push_back({"processor time of a run, one job", 1e3 * of_one_s, "ms", ""});
  figures.push_back({"processor time of a run, two jobs", 1e3 * of_two_s, "ms", ""});
  figures.push_back({"time in which both jobs had work", 100.0 * busy, "%", ""});
  figures.push_back({"rate of two jobs / twice that of one, on free processors",
                     100.0 * busy * of_one_s / of_two_s, "%", ">= 90"});
  figures.push_back({"the same by the clock, among others at work",
                     100.0 * (two.runs / two.wall_s) / (2.0 * one.runs / one.wall_s), "%", ""});

  // What the store does for one run: look for it, claim it, keep it.
  const Sweep sweep = bench.next_sweep(kRuns);
  ContentDigests digests;
  const StoredRun stored{"", scenario_yaml(scenario_at(sweep, 0)), EvaluatedRun{}};
  RunClaims claims(store.file);
  double begun_s = processor_s();
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < kRuns; ++i) keys.push_back(run_key(scenario_at(sweep, i), digests));
  const double key_s = (processor_s() - begun_s) / kRuns;
  begun_s = processor_s();
  for (const std::string& key : keys) {
    claims.claim(key);
    if (!holds_run(store, key)) keep_run(store, {key, stored.scenario, stored.run});
    claims.release(key);
  }
  const double keep_s = (processor_s() - begun_s) / kRuns;
  figures.push_back({"key of a run", 1e3 * key_s, "ms", ""});
  figures.push_back({"claim, look for and keep a run", 1e3 * keep_s, "ms", ""});
  figures.push_back(
      {"store of a run's processor time", 100.0 * (key_s + keep_s) / of_one_s, "%", "< 1"});
}

// Copies of the runs there are, under other keys and with other energies.
void fill(RunStore& store) {
  std::string columns;
  for (const std::string& column : stored_run_columns()) {
    if (run_figure_keys().end() !=
        std::find(run_figure_keys().begin(), run_figure_keys().end(), column)) {
      columns += column == "energy_wh" ? ", energy_wh * (1 + 1e-6 * (abs(random()) % 100000))"
                                       : ", " + column;
    }
  }
  const std::string copies = fmt::format(
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < {}) ", kStored);
  execute(
      store.database,
      fmt::format("BEGIN; DELETE FROM cells;"
                  "CREATE TEMP TABLE one AS SELECT * FROM results WHERE swath_count > 0 LIMIT 1;"
                  "DELETE FROM results; "
                  "{0} INSERT INTO results SELECT lower(hex(randomblob(16))), program, state, "
                  "reason, outcome, outcome_detail, verdict{1} FROM one JOIN n;"
                  "CREATE TEMP TABLE text AS SELECT scenario FROM scenarios LIMIT 1;"
                  "INSERT INTO scenarios SELECT key, scenario FROM results JOIN text;"
                  "INSERT INTO cells SELECT 'many', row_number() OVER () - 1, 'hectare', "
                  "'rolling', 'firm', 'utility_tractor', 'boustrophedon', rowid, key FROM results;"
                  "COMMIT",
                  copies, columns));
}

void add_queries(Bench& bench, std::vector<Figure>& figures) {
  const fs::path file = bench.scratch.folder / "runs.db";
  {
    RunStore store;
    open_run_store(file, DatabaseMode::kWrite, store);
    fill(store);
  }
  struct Asked {
    const char* name;
    const char* target;
    RunQuery query;
  };
  const Asked asked[] = {
      {"query of 100 000 runs: one in a hundred",
       "< 1",
       {{}, "planner = 'boustrophedon' AND seed % 100 = 7 AND energy_wh > 0"}},
      {"query of 100 000 runs: all of them, usual columns", "< 1", {}},
      {"query of 100 000 runs: all of them, all columns", "", {{"all"}, ""}},
  };
  for (const Asked& one : asked) {
    std::vector<double> seconds;
    for (int i = 0; i < 3; ++i) {
      const double begun_s = processor_s();
      static_cast<void>(query_runs(file, one.query));
      seconds.push_back(processor_s() - begun_s);
    }
    figures.push_back({one.name, median(seconds), "s", one.target});
  }
  figures.push_back(
      {"size of that store", 1e-6 * static_cast<double>(fs::file_size(file)), "MB", ""});
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  using namespace headland::bench;
  const int runs = argc > 1 && std::atoi(argv[1]) > 0 ? std::atoi(argv[1]) : kRuns;
  try {
    Bench bench;
    std::vector<Figure> figures;
    add_throughput(bench, runs, figures);
    add_queries(bench, figures);
    print(figures, wants_json(argc, argv));
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "sweep_bench: %s\n", error.what());
    return 2;
  }
  return EXIT_SUCCESS;
}
