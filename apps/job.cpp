// headland job: plans several fields and the transits between them as one path, and drives it if
// asked to.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/left_out.h"
#include "apps/plan_summary.h"
#include "apps/progress.h"
#include "apps/summary.h"
#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/audit.h"
#include "evaluate/coverage.h"
#include "evaluate/duration_text.h"
#include "evaluate/job_plan.h"
#include "evaluate/plan_file.h"
#include "evaluate/results.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

struct JobOptions {
  CommonOptions common;
  bool drive = false;
};

constexpr double kHectare_m2 = 1e4;
constexpr double kJoulesPerWh = 3600.0;

Audit audit_of(const JobPlan& plan) {
  const double width_m = plan.stage.vehicle.implement.working_width_m;
  return audit_path(plan.stage.field, plan.stage.vehicle, lines_of(plan.path),
                    std::min(plan.scenario.coverage_cell_m, 0.5 * width_m));
}

nlohmann::ordered_json report_json(const JobPlan& plan, const Audit& audit,
                                   const std::vector<JobPartRun>& runs) {
  nlohmann::ordered_json json = job_json(plan, runs, HEADLAND_VERSION);
  const CoverageFigures& coverage = audit.coverage;
  json["audit"] = {{"passes", passes(audit)},
                   {"places", audit.places.size()},
                   {"covered_ratio", coverage.covered_m2 / coverage.workable_m2},
                   {"overlap_ratio", coverage.overlap_m2 / coverage.workable_m2}};
  return json;
}

void warn_of_left_out(const JobPlan& plan, const Audit& audit, const JobSpec& spec) {
  std::vector<PlannedField> fields;
  for (const JobField& field : spec.fields) fields.push_back({field.name, field.planner});
  print_warning(left_out_warning(plan.path, audit.coverage, fields, spec.common.path));
}

std::string part_row(const JobPart& part, const JobPartRun* run) {
  const std::string name =
      part.transit ? fmt::format("transit {} to {}", part.from, part.to)
                   : fmt::format("{}, {:.3f} ha, {}", part.name, part.area_m2 / kHectare_m2,
                                 counted(part.passes, "pass", "passes"));
  std::string text = fmt::format("  {:<40} {:>8.0f} m  {:>9}", terminal_text(name), part.length_m,
                                 duration_text(part.expected_time_s));
  if (run != nullptr) {
    text += fmt::format("  driven {:>9}, {:.0f} Wh", duration_text(run->time_s),
                        run->battery_j / kJoulesPerWh);
  }
  return text + "\n";
}

std::string summary_of(const JobPlan& plan, const Audit& audit,
                       const std::vector<JobPartRun>& runs) {
  std::string text =
      fmt::format("{}: {} with {:g} m\n\n", terminal_text(plan.scenario.name),
                  plan.stage.vehicle.name, plan.stage.vehicle.implement.working_width_m);
  JobPart transits;
  JobPart all;
  for (std::size_t i = 0; i < plan.parts.size(); ++i) {
    const JobPart& part = plan.parts[i];
    text += part_row(part, runs.empty() ? nullptr : &runs[i]);
    for (JobPart* sum : {&all, &transits}) {
      if (sum == &transits && !part.transit) continue;
      sum->length_m += part.length_m;
      sum->expected_time_s += part.expected_time_s;
    }
  }
  text += fmt::format("  {:<40} {:>8.0f} m  {:>9}\n", "all", all.length_m,
                      duration_text(all.expected_time_s));
  text += fmt::format("  {:<40} {:>8.0f} m  {:>9}\n", "of it transits", transits.length_m,
                      duration_text(transits.expected_time_s));
  const CoverageFigures& coverage = audit.coverage;
  text += fmt::format(
      "  audit: {}, {}; covered {:.2f} % of {:.3f} ha, overlap {:.2f} %\n",
      passes(audit) ? "PASS" : "FAIL", counted(audit.places.size(), "place", "places"),
      100.0 * coverage.covered_m2 / coverage.workable_m2, coverage.workable_m2 / kHectare_m2,
      100.0 * coverage.overlap_m2 / coverage.workable_m2);
  for (const PathViolation& violation : plan.path.violations) {
    text += fmt::format("  does not fit at x {:.1f}, y {:.1f} m: {}\n", violation.p_W.x(),
                        violation.p_W.y(), violation.what);
  }
  for (const std::string& note : plan.stage.notes) text += "note: " + terminal_text(note) + "\n";
  return text + left_out_rows(plan.path, coverage, plan.scenario.path) +
         over_worked_row(plan.stage, plan.path, plan.scenario.path) + path_notes(plan.path);
}

JobSpec spec_of(const CommonOptions& options) {
  JobSpec spec = read_job(options.scenario, options.seed);
  if (options.allow_overrun) spec.common.path.allow_overrun = true;
  return spec;
}

int run_job(const JobOptions& options) {
  const CommonOptions& common = options.common;
  const std::filesystem::path folder = common.folder;
  const PictureSize size = picture_size(common);
  check_results_folder(folder);
  JobPlan plan;
  std::optional<Audit> audit;
  {
    const InterruptAtOnce at_once;
    const JobSpec spec = spec_of(common);
    PlanningLine line(common.quiet);
    plan = plan_job(spec, line.shown());
    check_coverage_size(plan.stage.field, plan.scenario.working_width_m,
                        plan.scenario.coverage_cell_m, common.scenario);
    audit = audit_of(plan);
    warn_of_left_out(plan, *audit, spec);
  }
  plan.scenario.path_file = folder / kPathFile;
  const GeoFrame& frame = plan.stage.field.frame;
  const auto report = [&](const std::vector<JobPartRun>& runs) {
    return json_text(report_json(plan, *audit, runs), 2) + "\n";
  };
  write_together(folder, {{kScenarioFile, scenario_yaml(plan.scenario)},
                          {kPlanFile, plan_geojson(plan.plan, frame)},
                          {kJobFile, report({})},
                          {kPathFile, path_geojson(plan.path, frame)}});
  remove_results_from(folder, kRunFile);
  std::vector<JobPartRun> runs;
  int exit_code = kExitRan;
  if (options.drive) {
    stop_if_interrupted();
    const Job job{plan.scenario, plan.stage, folder};
    const DriveResult driven = drive_with_progress(job, common);
    runs = runs_of_parts(plan, driven.run);
    write_together(folder, {{kJobFile, report(runs)}});
    stop_if_interrupted();
    draw_stage(job, recorded_run(job), size);
    exit_code = exit_code_of(driven.verdict);
    if (!common.json && !common.quiet) fmt::print("{}\n", run_summary(job, driven));
  }
  if (common.json) {
    fmt::print("{}", report(runs));
  } else if (!common.quiet) {
    const std::string shown = terminal_text(folder.string());
    fmt::print("{}\nplan and path are in {}{}\n", summary_of(plan, *audit, runs), shown,
               options.drive ? "" : fmt::format("; 'headland drive {}' drives it", shown));
  }
  return exit_code;
}

}  // namespace

void add_job_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("job", "Plan several fields and the transits between their gates");
  auto options = std::make_shared<JobOptions>();
  command->add_option("JOB", options->common.scenario, "Job file (YAML); docs/jobs.md")->required();
  command->add_option("-o,--output", options->common.folder, "Folder for the results")->required();
  command->add_flag("--drive", options->drive, "Drive it in physics, judge it and draw it as well");
  add_scenario_options(*command, options->common);
  add_size_option(*command, options->common);
  command->footer(
      "Example:\n  headland job examples/job.yaml -o out/job\n\n"
      "Writes scenario.yaml (fields and roads as one field), plan.geojson, path.geojson and\n"
      "job.json. Exits with 0, with --drive with 1 when the verdict is FAIL, 2 when there is no\n"
      "plan or the input is bad, 130 after Ctrl-C.");
  command->callback([options, &exit_code] { exit_code = run_job(*options); });
}

}  // namespace headland
