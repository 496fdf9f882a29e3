// headland compare: planners on maps, several times each, side by side.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "apps/commands.h"
#include "apps/compare_pictures.h"
#include "apps/compare_summary.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "apps/set_reports.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/comparison_drive.h"
#include "evaluate/comparison_file.h"
#include "evaluate/comparison_reader.h"
#include "evaluate/results.h"
#include "render/gnuplot.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr char kRunsFile[] = "runs.csv";
constexpr char kTableFile[] = "table.csv";

struct CompareCommand {
  std::string spec;
  std::string folder;
  std::optional<std::uint64_t> seed;
  std::string cost;
  int jobs = 1;
  bool drive = false;
  bool json = false;
  bool quiet = false;
};

ParallelOptions options_with(ProgressLine& line, const CompareCommand& command, const char* what) {
  ParallelOptions options;
  options.jobs = command.jobs;
  options.progress = [&line, what](int done, int all) { show_count(line, what, done, all); };
  options.cancelled = interrupted;
  return options;
}

std::vector<ComparedRun> run_with_progress(const Comparison& comparison,
                                           const CompareCommand& command) {
  // Before any run: what cannot be driven on is refused while nothing is lost by it.
  std::vector<Stage> stages;
  if (comparison.drive) stages = drive_stages(comparison);
  ProgressLine line = start_progress(command.quiet);
  std::vector<ComparedRun> runs = run_comparison(comparison, options_with(line, command, "runs"));
  end_progress(line);
  if (!comparison.drive || interrupted()) return runs;
  line = start_progress(command.quiet);
  drive_best_plans(comparison, stages, options_with(line, command, "drives"), runs);
  end_progress(line);
  return runs;
}

// A comparison of which no run could be planned is bad input, told by the first of the refusals.
void refuse_where_nothing_is_planned(const CompareCommand& command,
                                     const std::vector<ComparedRun>& runs) {
  const bool all_refused = std::ranges::all_of(
      runs, [](const ComparedRun& run) { return run.state == RunState::kRefused; });
  if (!all_refused) return;
  throw InputError(command.spec, "planners", "",
                   "none of them can plan any of these: " + runs.front().refusal);
}

int compare(const CompareCommand& command) {
  constexpr int kMostJobs = 1024;
  if (command.jobs < 1 || command.jobs > kMostJobs) {
    throw InputError("--jobs", "", fmt::format("{}", command.jobs),
                     fmt::format("a whole number from 1 to {}", kMostJobs));
  }
  check_output_folder(command.folder);
  Comparison comparison = read_comparison(command.spec, command.seed);
  if (command.drive && !comparison.drive) {
    throw InputError(command.spec, "drive", "",
                     "the section is missing: --drive needs at least drive.vehicle");
  }
  if (!command.cost.empty()) {
    require_file(command.cost);
    take_measured_costs(std::filesystem::absolute(command.cost).lexically_normal(), comparison);
    if (comparison.cost.objective == GridObjective::kLength) {
      comparison.cost.objective = GridObjective::kMeasured;
    }
  }
  for (const std::string& note : comparison.notes) {
    fmt::print(stderr, "headland: {}\n", terminal_text(note));
  }
  if (!command.drive) comparison.drive.reset();
  require_gnuplot();
  prove_least_costs(comparison, {command.jobs, nullptr, interrupted});
  const std::vector<ComparedRun> runs = run_with_progress(comparison, command);
  refuse_where_nothing_is_planned(command, runs);
  const ComparisonRanks ranks = rank_planners(comparison, runs);
  nlohmann::ordered_json json = comparison_json(comparison, runs, ranks, HEADLAND_VERSION);
  const std::filesystem::path folder = command.folder;
  const std::vector<std::filesystem::path> outdated = earlier_pictures(folder / kComparisonFile);
  // The tables first: pictures that cannot be drawn cost nobody a run.
  write_together(folder, {{kComparisonFile, json_text(json, 1) + "\n"},
                          {kRunsFile, comparison_runs_csv(comparison, runs)},
                          {kTableFile, comparison_table_csv(comparison, runs)}});
  for (const std::filesystem::path& picture : outdated) std::filesystem::remove(picture);
  std::filesystem::remove(folder / kReportFile);
  if (!interrupted()) {
    std::vector<FileText> files = comparison_pictures(comparison, runs);
    for (const FileText& file : files) json["pictures"].push_back(file.name);
    files.push_back({kComparisonFile, json_text(json, 1) + "\n"});
    write_together(folder, files);
    write_together(folder, {{kReportFile, comparison_report(folder).html}});
  }
  if (command.json) {
    fmt::print("{}\n", json_text(json, 1));
  } else if (!command.quiet) {
    fmt::print("{}\ntables, pictures and {} are in {}\n",
               comparison_summary(comparison, runs, ranks), kReportFile,
               terminal_text(command.folder));
  }
  stop_if_interrupted();
  return kExitRan;
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("compare", "Compare planners on grid maps or on fields");
  auto given = std::make_shared<CompareCommand>();
  given->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command
      ->add_option("SPEC", given->spec, "Maps or fields, planners and how to compare them (YAML)")
      ->required();
  command->add_option("-o,--output", given->folder, "Folder for the results")->required();
  command->add_option("--seed", given->seed, "Seed of every random draw, instead of the file's")
      ->check(whole_number_fault);
  add_cost_option(*command, given->cost);
  command->add_option("--jobs", given->jobs, "Runs at the same time")->capture_default_str();
  command->add_flag("--drive", given->drive, "Drive the best plans in physics, as `drive` says");
  command->add_flag("--json", given->json, "Print compare.json, and nothing else");
  command->add_flag("--quiet,-q", given->quiet, "No progress and no summary");
  command->footer(
      "Example:\n  headland compare examples/compare.yaml -o out/compare\n"
      "  headland compare examples/compare.yaml --drive -o out/compare\n"
      "  headland compare examples/compare_fields.yaml -o out/compare_fields\n\n"
      "Writes compare.json, runs.csv, table.csv, and for each map plans_MAP.png,\n"
      "convergence_MAP.svg and plan_MAP_PLANNER.png, and report.html that shows them.\n"
      "Exits with 0, 2 for bad input, 130 after Ctrl-C (finished runs are kept).");
  command->callback([given, &exit_code] { exit_code = compare(*given); });
}

}  // namespace headland
