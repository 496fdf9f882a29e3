// headland evaluate: plans, drives, judges and draws.
#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/left_out.h"
#include "apps/plan_summary.h"
#include "apps/report_stage.h"
#include "apps/summary.h"
#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/results.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

// Makes the path to drive; returns what to tell of it.
std::string prepare(const Job& job, bool quiet) {
  if (job.scenario.path_file.empty()) {
    const PlanResult result = plan_with_progress(job, quiet);
    const CoverageFigures coverage =
        result.path.left_out.empty() ? CoverageFigures{} : coverage_of(job, result);
    warn_of_left_out(job, result, coverage);
    return predicted_row(result) + left_out_rows(result.path, coverage, job.scenario.path) +
           path_notes(result.path) + grid_notes(result) + notes_text(result.notes);
  }
  const std::optional<TrackReport> track = given_path_with_progress(job, quiet);
  return track ? track_summary(*track) : "";
}

int evaluate(const CommonOptions& options) {
  const PictureSize size = picture_size(options);
  const Job job = make_job(options.scenario, options.folder, options);
  const std::string made = prepare(job, options.quiet);
  stop_if_interrupted();
  const DriveResult result = drive_with_progress(job, options);
  stop_if_interrupted();
  draw_stage(job, recorded_run(job), size);
  stop_if_interrupted();
  report_stage(job);
  if (options.json) {
    fmt::print("{}\n", json_text(result.json, 2));
  } else if (!options.quiet) {
    fmt::print("{}{}\nresults, tables, pictures and {} are in {}\n", run_summary(job, result), made,
               kReportFile, terminal_text(job.folder.string()));
  }
  return exit_code_of(result.verdict);
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("evaluate", "Plan, drive, judge, draw and report a scenario");
  auto options = std::make_shared<CommonOptions>();
  command->add_option("SCENARIO", options->scenario, "Scenario file (YAML)")->required();
  command->add_option("-o,--output", options->folder, "Folder for the results")->required();
  add_scenario_options(*command, *options);
  add_cost_option(*command, options->cost);
  add_weights_option(*command, options->weights);
  add_record_option(*command, *options);
  add_size_option(*command, *options);
  command->footer(
      "Example:\n  headland evaluate examples/demo.yaml -o out/demo\n\n"
      "Exits with 0 when the verdict is PASS or WARN, 1 when it is FAIL, 2 for bad input,\n"
      "130 after Ctrl-C (the finished stages are kept, the run in flight is dropped).");
  command->callback([options, &exit_code] { exit_code = evaluate(*options); });
}

}  // namespace headland
