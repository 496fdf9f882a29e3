// headland sweep: a matrix of runs, planned and driven into a store.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "apps/terminal_text.h"
#include "evaluate/sweep.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kMostJobs = 1024;
constexpr int kMostParts = 1'000'000;

struct SweepCommand {
  std::string spec;
  std::string store;
  std::string shard = "1/1";
  int jobs = 1;
  bool quiet = false;
};

Shard read_shard(const std::string& text) {
  Shard shard;
  int read = 0;
  const bool parsed =
      std::sscanf(text.c_str(), "%9d/%9d%n", &shard.part, &shard.parts, &read) == 2 &&
      static_cast<std::size_t>(read) == text.size();
  if (parsed && shard.part >= 1 && shard.part <= shard.parts && shard.parts <= kMostParts) {
    return shard;
  }
  throw InputError(
      "--shard", "", text,
      fmt::format("PART/PARTS is needed, 1/4 to 4/4 for instance, with at most {} parts",
                  kMostParts));
}

std::string counts_text(const SweepResult& result, const std::string& store) {
  std::string text = fmt::format(
      "{} runs of {} in the matrix: {} were in {}, {} driven now, {} without a plan, {} refused",
      result.runs, result.cells, result.known, terminal_text(store), result.driven, result.no_plan,
      result.refused);
  if (result.elsewhere > 0) text += fmt::format(", {} driven by other programs", result.elsewhere);
  if (!result.failed.empty()) text += fmt::format(", {} failed", result.failed.size());
  text += "\n";
  if (result.no_energy > 0) {
    text +=
        fmt::format("  {} of those driven diverged: their energy is no number\n", result.no_energy);
  }
  const auto tell = [&](const char* how, const FailedRun& run) {
    text += fmt::format("  {}: {}: {}\n", how, terminal_text(run.what), terminal_text(run.why));
  };
  for (const FailedRun& run : result.refusals) tell("not driven", run);
  const std::size_t more = result.no_plan + result.refused - result.refusals.size();
  if (more > 0) text += fmt::format("  and {} more that were not driven\n", more);
  return text;
}

int sweep(const SweepCommand& command) {
  if (command.jobs < 1 || command.jobs > kMostJobs) {
    throw InputError("--jobs", "", fmt::format("{}", command.jobs),
                     fmt::format("a whole number from 1 to {}", kMostJobs));
  }
  const Shard shard = read_shard(command.shard);
  const Sweep matrix = read_sweep(command.spec);
  RunStore store;
  open_run_store(command.store, DatabaseMode::kWrite, store);
  ProgressLine line = start_progress(command.quiet);
  ParallelOptions options;
  options.jobs = command.jobs;
  options.progress = [&](int done, int all) { show_count(line, "runs", done, all); };
  options.cancelled = interrupted;
  const SweepResult result = run_sweep(matrix, store, shard, options);
  end_progress(line);
  if (!command.quiet) fmt::print("{}", counts_text(result, command.store));
  for (const FailedRun& run : result.failed) {
    fmt::print(stderr, "headland: failed: {}: {}\n", terminal_text(run.what),
               terminal_text(run.why));
  }
  stop_if_interrupted();
  return result.failed.empty() ? kExitRan : kExitInternal;
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("sweep", "Drive a matrix of runs into a store");
  auto given = std::make_shared<SweepCommand>();
  given->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("SPEC", given->spec, "Fields, terrains, soils, vehicles, planners (YAML)")
      ->required();
  command
      ->add_option("--store", given->store,
                   "SQLite file with the runs; what it holds is not driven again")
      ->required();
  command->add_option("--jobs", given->jobs, "Runs at the same time")->capture_default_str();
  command
      ->add_option("--shard", given->shard,
                   "PART/PARTS: this part of the runs alone, for a scheduler's array of jobs")
      ->capture_default_str();
  command->add_flag("--quiet,-q", given->quiet, "No progress and no summary");
  command->footer(
      "Examples:\n  headland sweep examples/sweep.yaml --store out/runs.db\n"
      "  headland sweep examples/sweep.yaml --store out/runs_2.db --shard 2/8\n\n"
      "Ended early, by whatever, it goes on where it was when called again.\n"
      "Exits with 0 when every run is in the store, 2 for bad input, 3 when runs failed by a "
      "fault\n"
      "of headland (they are tried again next time), 130 after Ctrl-C.");
  command->callback([given, &exit_code] { exit_code = sweep(*given); });
}

}  // namespace headland
