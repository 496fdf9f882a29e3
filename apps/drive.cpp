// headland drive: drives a path in physics, ours or another tool's, and judges it.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/plan_summary.h"
#include "apps/summary.h"
#include "apps/terminal_text.h"
#include "evaluate/results.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct DriveOptions {
  CommonOptions common;
  std::string path;
  std::optional<double> tolerance_m;
};

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// Puts the path to drive into the job's folder; tells about the track it comes from, if any.
std::optional<TrackReport> prepare_path(const Job& job, const fs::path& given, bool from_plan,
                                        bool quiet) {
  if (!from_plan) return given_path_with_progress(job, quiet);
  if (!same_folder(given, job.folder)) adopt_plan(job, given);
  return std::nullopt;
}

void apply(const DriveOptions& options, Scenario& scenario) {
  if (!options.path.empty()) scenario.path_file = options.path;
  if (options.tolerance_m) scenario.path_tolerance_m = *options.tolerance_m;
}

// What made the plan is written in its folder; changed now it would not be the plan's any more.
void refuse_planning_options(const CommonOptions& options) {
  const char* allowed = "is for planning; give it to 'headland plan', or here along with --path";
  if (options.seed) throw InputError("--seed", "", fmt::format("{}", *options.seed), allowed);
  if (options.allow_overrun) throw InputError("--allow-overrun", "", "", allowed);
}

int drive(const DriveOptions& options) {
  const fs::path given = options.common.scenario;
  const bool planned = fs::is_directory(given);
  const bool from_plan = planned && options.path.empty();
  if (from_plan) {
    refuse_planning_options(options.common);
    if (!fs::exists(given / kPathFile)) {
      throw InputError((given / kPathFile).string(), "", "",
                       "no such file: 'headland plan' writes it");
    }
  } else if (options.common.folder.empty()) {
    throw InputError("-o", "", "",
                     "a folder for the results is needed when no planned folder is driven");
  }
  const double tolerance_m = options.tolerance_m.value_or(kMinTrackTolerance_m);
  if (!(tolerance_m >= kMinTrackTolerance_m && tolerance_m <= kMaxTrackTolerance_m)) {
    throw InputError("--tolerance", "", fmt::format("{}", tolerance_m),
                     fmt::format("from {} to {} m", kMinTrackTolerance_m, kMaxTrackTolerance_m));
  }
  const fs::path folder = options.common.folder.empty() ? given : fs::path(options.common.folder);
  Job job = make_job(planned ? given / kScenarioFile : given, folder, options.common);
  apply(options, job.scenario);
  if (!from_plan && job.scenario.path_file.empty()) {
    throw InputError(given.string(), "", "",
                     "no path to drive: give the folder that 'headland plan' wrote, or --path FILE "
                     "(path.file in the scenario)");
  }
  const std::optional<TrackReport> track =
      prepare_path(job, given, from_plan, options.common.quiet);
  stop_if_interrupted();
  DriveResult result = drive_with_progress(job, options.common);
  if (options.common.json) {
    if (track) result.json["track"] = track_json(*track);
    fmt::print("{}\n", json_text(result.json, 2));
  } else if (!options.common.quiet) {
    fmt::print("{}{}\nresults and tables are in {}; 'headland render {}' draws them\n",
               track ? track_summary(*track) : "", run_summary(job, result),
               terminal_text(folder.string()), terminal_text(folder.string()));
  }
  return exit_code_of(result.verdict);
}

}  // namespace

void add_drive_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("drive", "Drive a path in physics and judge it");
  auto options = std::make_shared<DriveOptions>();
  command
      ->add_option("SCENARIO_OR_DIR", options->common.scenario,
                   "Folder that 'headland plan' wrote, or a scenario with --path")
      ->required();
  command->add_option(
      "-o,--output", options->common.folder,
      "Folder for the results; default: the folder of the plan. Needed with --path");
  command->add_option("--path", options->path,
                      "Drive another tool's plan or a logged track instead: lines (GeoJSON, GPKG, "
                      "GPX...) or CSV with lon,lat in degrees or x,y in metres; docs/paths.md. A "
                      "path.geojson of headland is driven as it is");
  command->add_option("--tolerance", options->tolerance_m,
                      "How far from its points the track may be smoothed, in metres [0.3]");
  add_scenario_options(*command, options->common);
  add_record_option(*command, options->common);
  command->footer(
      "Examples:\n  headland drive out/demo\n"
      "  headland drive examples/real_field.yaml --path track.csv -o out/track\n\n"
      "Exits with 0 when the verdict is PASS or WARN, 1 when it is FAIL, 2 for bad input,\n"
      "130 after Ctrl-C (the run in flight is dropped, its plan is kept).");
  command->callback([options, &exit_code] { exit_code = drive(*options); });
}

}  // namespace headland
