#include "bench/field_drives.h"

#include <algorithm>
#include <mutex>

#include "bench/field_suite_rows.h"
#include "bench/figures.h"
#include "evaluate/metrics.h"
#include "evaluate/parallel_runs.h"
#include "evaluate/reachable_ground.h"
#include "sim/simulation.h"
#include "terrains/terrain_source.h"

namespace headland::bench {
namespace {

struct DriveRow {
  SuiteRow planned;
  std::string outcome;
  std::string detail;  // where and why it did not finish
  double overrun_m = 0.0;
  double driven_percent = 0.0;  // of the reachable ground
  double overlap_percent = 0.0;
  double track_rms_m = 0.0;  // with the implement down
  double energy_wh = 0.0;
  double drive_s = 0.0;
};

// 1.5 m up and down over 120 m: slopes up to 16 %.
TerrainSource rolling(std::uint64_t seed) {
  TerrainSource terrain;
  terrain.generator = "rolling";
  terrain.parameters = {{"amplitude_m", 1.5}, {"wavelength_m", 120.0}};
  terrain.seed = seed;
  return terrain;
}

void drive(const SuiteField& made, DriveRow& row) {
  const Stage& stage = made.stage;
  const Heightfield terrain = read_terrain(rolling(row.planned.recipe.seed), stage.field, "bench");
  const SoilMap soil = read_soil({}, stage.field, "bench").map;
  const auto begun = std::chrono::steady_clock::now();
  const RunRecord run = simulate({stage.field, terrain, soil, stage.vehicle, made.path, {}, {}});
  row.drive_s = seconds_since(begun);
  const CoverageRaster raster =
      measure_coverage(stage.field, run.footprints, stage.vehicle.implement.working_width_m,
                       coverage_cell_m(stage.field));
  const Metrics metrics = measure_run(made.path, run, coverage_figures(raster));
  const CoverageFigures reachable = coverage_figures(
      reachable_part(raster, stage.field, stage.vehicle, made.scenario.path.clearance_m));
  row.outcome = outcome_name(run.outcome);
  row.detail = run.outcome_detail;
  row.overrun_m = run.peaks.boundary_overrun_m.value;
  row.driven_percent = 100.0 * (1.0 - reachable.missed_m2 / std::max(reachable.workable_m2, 1e-9));
  row.overlap_percent = 100.0 * metrics.overlap_ratio;
  row.track_rms_m = metrics.track_rms_working_m;
  row.energy_wh = metrics.energy_wh;
}

nlohmann::ordered_json drive_json(const DriveRow& row) {
  nlohmann::ordered_json json = row_json(row.planned);
  if (!row.planned.refusal.empty()) return json;
  json["outcome"] = row.outcome;
  json["detail"] = row.detail;
  json["overrun_m"] = row.overrun_m;
  json["driven_of_reachable_percent"] = row.driven_percent;
  json["driven_overlap_percent"] = row.overlap_percent;
  json["track_rms_working_m"] = row.track_rms_m;
  json["energy_wh"] = row.energy_wh;
  json["drive_s"] = row.drive_s;
  return json;
}

void print_row(const DriveRow& row) {
  const FieldRecipe& recipe = row.planned.recipe;
  const std::string name =
      fmt::format("{:<8} {:>4} {:>6.2f} {:>2} {:<16}", field_shape_name(recipe.shape), recipe.seed,
                  1e-4 * recipe.area_m2, recipe.holes, row.planned.vehicle);
  if (!row.planned.refusal.empty()) {
    std::puts((name + " refused: " + row.planned.refusal).c_str());
  } else {
    std::puts(fmt::format(
                  "{} {:<14} {:>7.3f} {:>8.3f} {:>8.3f} {:>7.2f} {:>7.3f} {:>8.0f} {:>6.1f}", name,
                  row.outcome, row.overrun_m, covered_percent(row.planned), row.driven_percent,
                  row.overlap_percent, row.track_rms_m, row.energy_wh, row.drive_s)
                  .c_str());
    if (!row.detail.empty()) std::puts(("  " + row.detail).c_str());
  }
  std::fflush(stdout);
}

}  // namespace

void print_drives(const DrivesAsked& asked) {
  std::vector<DriveRow> rows;
  int fields = 0;
  // Of the suite's recipes one in three or so is small enough.
  for (const FieldRecipe& recipe : field_suite(40 * asked.fields)) {
    if (fields == asked.fields) break;
    if (1e-4 * recipe.area_m2 > asked.most_ha) continue;
    ++fields;
    for (const std::string& vehicle : asked.vehicles) {
      rows.emplace_back();
      rows.back().planned.recipe = recipe;
      rows.back().planned.vehicle = vehicle;
    }
  }
  if (!asked.json) {
    std::puts(
        "shape    seed     ha  h vehicle          outcome        overrun  planned   driven "
        "overlap  rms m       Wh drive_s");
  }
  ParallelOptions options;
  options.jobs = asked.jobs;
  std::mutex mutex;
  run_in_parallel(rows.size(), options, [&](std::size_t i, const CancelAsked&) {
    SuiteField made;
    rows[i].planned = suite_row(rows[i].planned.recipe, rows[i].planned.vehicle, asked.parameters,
                                asked.clearance_m, &made);
    if (rows[i].planned.refusal.empty()) drive(made, rows[i]);
    const std::scoped_lock lock(mutex);
    if (!asked.json) print_row(rows[i]);
    return true;
  });
  if (asked.json) {
    print_json(rows, drive_json);
    return;
  }
  int finished = 0;
  int inside = 0;
  int covered = 0;
  int driven = 0;
  for (const DriveRow& row : rows) {
    if (!row.planned.refusal.empty()) continue;
    ++driven;
    finished += row.outcome == outcome_name(Outcome::kFinished) ? 1 : 0;
    inside += row.overrun_m <= 0.0 ? 1 : 0;
    covered += row.driven_percent >= 99.0 ? 1 : 0;
  }
  std::puts(fmt::format("driven {} of {}: finished {}, never outside {}, 99 % or more covered {}",
                        driven, rows.size(), finished, inside, covered)
                .c_str());
}

}  // namespace headland::bench
