// headland plan: plans the field and makes the plan drivable.
#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/left_out.h"
#include "apps/plan_summary.h"
#include "apps/terminal_text.h"
#include "evaluate/results.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

int plan(const CommonOptions& options) {
  const Job job = make_job(options.scenario, options.folder, options);
  if (!job.scenario.path_file.empty()) {
    throw InputError(options.scenario, "path.file", job.scenario.path_file.string(),
                     "is driven as it is, there is nothing to plan; 'headland evaluate' drives it");
  }
  const bool had_run = std::filesystem::exists(job.folder / kRunFile);
  const PlanResult result = plan_with_progress(job, options.quiet);
  stop_if_interrupted();
  if (had_run && !options.quiet) {
    fmt::print(stderr, "headland: removed what an earlier drive had left in {}\n",
               terminal_text(job.folder.string()));
  }
  const bool told = options.json || !options.quiet || !result.path.left_out.empty();
  const CoverageFigures coverage = told ? coverage_of(job, result) : CoverageFigures{};
  warn_of_left_out(job, result, coverage);
  if (options.json) {
    fmt::print("{}\n", json_text(plan_summary_json(job, result, coverage), 2));
  } else if (!options.quiet) {
    fmt::print("{}\nplan and path are in {}\n", plan_summary(job, result, coverage),
               terminal_text(job.folder.string()));
  }
  return kExitRan;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("plan", "Plan a field and make the plan drivable");
  auto options = std::make_shared<CommonOptions>();
  command->add_option("SCENARIO", options->scenario, "Scenario file (YAML)")->required();
  command->add_option("-o,--output", options->folder, "Folder for the results")->required();
  add_scenario_options(*command, *options);
  add_cost_option(*command, options->cost);
  add_weights_option(*command, options->weights);
  command->footer(
      "Example:\n  headland plan examples/demo.yaml -o out/plan\n\n"
      "Writes scenario.yaml, plan.geojson and path.geojson; 'headland drive out/plan' goes on.\n"
      "Exits with 0, 2 when there is no plan or the input is bad, 130 after Ctrl-C.");
  command->callback([options, &exit_code] { exit_code = plan(*options); });
}

}  // namespace headland
