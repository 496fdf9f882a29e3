#include "apps/stages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>

#include "apps/interrupt.h"
#include "evaluate/atomic_file.h"
#include "evaluate/coverage.h"
#include "evaluate/grid_plan_file.h"
#include "evaluate/metrics_file.h"
#include "evaluate/plan_file.h"
#include "evaluate/results.h"
#include "evaluate/run_tables.h"
#include "render/image.h"
#include "render/vehicle_mesh.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"
#include "terrains/track.h"

namespace headland {
namespace {

CoverageRaster coverage_of(const Job& job, const RunRecord& run) {
  return measure_coverage(job.stage.field, run.footprints, job.scenario.working_width_m,
                          job.scenario.coverage_cell_m);
}

std::vector<std::string> notes_on(const Stage& stage) {
  std::vector<std::string> notes = stage.notes;
  for (const std::string& note : vehicle_notes(stage.vehicle)) {
    notes.push_back(fmt::format("vehicle {}: {}", stage.vehicle.name, note));
  }
  return notes;
}

// Names the file in a refusal, which knows of the field alone.
template <typename Make>
auto fitted(const std::filesystem::path& file, Make make) {
  try {
    const InterruptAtOnce at_once;
    return make();
  } catch (const PlanInfeasible& refused) {
    throw PlanInfeasible(fmt::format("{}: {}", file.string(), refused.what()));
  }
}

void remove_file(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

}  // namespace

PlanResult plan_stage(const Job& job, const CancelAsked& cancelled) {
  const PlanResult result =
      fitted(job.scenario.file, [&] { return plan_scenario(job.scenario, job.stage, cancelled); });
  const GeoFrame& frame = job.stage.field.frame;
  std::vector<FileText> files = {{kScenarioFile, scenario_yaml(job.scenario)},
                                 {kPlanFile, plan_geojson(result.plan, frame)},
                                 {kPathFile, path_geojson(result.path, frame)}};
  if (result.grid_plan) {
    files.push_back(
        {kGridPlanFile, grid_plan_json(*job.stage.grid, *result.grid_plan, *result.grid_drive)});
  }
  write_together(job.folder, files);
  if (!result.grid_plan) remove_file(job.folder / kGridPlanFile);
  remove_file(job.folder / kJobFile);
  remove_results_from(job.folder, kRunFile);
  return result;
}

std::optional<TrackReport> given_path_stage(const Job& job, const CancelAsked& cancelled) {
  const std::filesystem::path& file = job.scenario.path_file;
  require_no_result(job.folder, file);
  std::string path_text;
  std::optional<TrackReport> report;
  if (is_path_file(file)) {
    const Path path = read_path(file, job.stage.field);
    path_text =
        file.extension() == ".csv" ? path_geojson(path, job.stage.field.frame) : read_text(file);
  } else {
    const Path path = fitted(file, [&] {
      return make_drivable(job.stage.field, job.stage.vehicle, read_track(file, job.stage.field),
                           job.scenario.path_tolerance_m, job.scenario.path, &report.emplace(),
                           cancelled);
    });
    path_text = path_geojson(path, job.stage.field.frame);
  }
  write_together(job.folder,
                 {{kScenarioFile, scenario_yaml(job.scenario)}, {kPathFile, path_text}});
  remove_file(job.folder / kPlanFile);
  remove_file(job.folder / kGridPlanFile);
  remove_file(job.folder / kJobFile);
  remove_results_from(job.folder, kRunFile);
  return report;
}

void adopt_plan(const Job& job, const std::filesystem::path& from) {
  // What cannot be driven is not taken over.
  static_cast<void>(read_path(from / kPathFile, job.stage.field));
  std::vector<FileText> files = {{kScenarioFile, scenario_yaml(job.scenario)},
                                 {kPathFile, read_text(from / kPathFile)}};
  std::vector<const char*> absent;
  for (const char* name : {kPlanFile, kGridPlanFile, kJobFile}) {
    if (std::filesystem::exists(from / name)) {
      files.push_back({name, read_text(from / name)});
    } else {
      absent.push_back(name);
    }
  }
  write_together(job.folder, files);
  for (const char* name : absent) remove_file(job.folder / name);
  remove_results_from(job.folder, kRunFile);
}

DriveResult drive_stage(const Job& job,
                        const std::function<bool(const SimulationProgress&)>& progress) {
  const Field& field = job.stage.field;
  DriveResult result;
  result.path = read_path(job.folder / kPathFile, field);
  result.notes = notes_on(job.stage);
  result.run = simulate({field, job.stage.terrain, job.stage.soil, job.stage.vehicle, result.path,
                         job.scenario.simulation, progress});
  if (result.run.outcome == Outcome::kInterrupted) throw Interrupted{};
  result.metrics =
      measure_run(result.path, result.run, coverage_figures(coverage_of(job, result.run)));
  result.verdict = judge(result.path, result.run, result.metrics, job.scenario.verdict);
  result.json = metrics_json({job.scenario, field, job.stage.vehicle, result.path, result.run,
                              result.metrics, result.verdict, result.notes},
                             HEADLAND_VERSION);
  write_together(job.folder, {{kScenarioFile, scenario_yaml(job.scenario)},
                              {kRunFile, run_csv(result.run.samples, field.frame)},
                              {kFootprintFile, footprint_csv(result.run.footprints)},
                              {kSegmentsFile, segments_csv(result.path, result.run.segments)},
                              {kMetricsFile, json_text(result.json, 2) + "\n"}});
  remove_results_from(job.folder, kFieldPicture);
  return result;
}

RecordedRun recorded_run(const Job& job) {
  const InterruptAtOnce at_once;
  return read_recorded_run(job.folder, job.stage.field);
}

void draw_stage(const Job& job, const RecordedRun& recorded, const PictureSize& size) {
  const Stage& stage = job.stage;
  std::vector<FileText> pictures;
  {
    const InterruptAtOnce at_once;
    const auto& [path, run, metrics, missing] = recorded;
    const CoverageRaster coverage = coverage_of(job, run);
    std::optional<Verdict> verdict;
    if (missing.empty()) {
      verdict = judge(path, run, measure_run(path, run, coverage_figures(coverage)),
                      job.scenario.verdict);
    }
    const PictureScene scene{stage.field,
                             stage.terrain,
                             stage.vehicle,
                             path,
                             run,
                             coverage,
                             verdict ? &*verdict : nullptr,
                             job.scenario.path_file.filename().string(),
                             std::nullopt,
                             fmt::format("{}", fmt::join(missing, "; "))};
    pictures = {{kFieldPicture, png_of(draw_field_map(scene, size))},
                {kViewPicture, png_of(draw_view(scene, size))},
                {kEnergyPicture, png_of(draw_energy_map(scene, size))}};
  }
  write_together(job.folder, pictures);
}

}  // namespace headland
