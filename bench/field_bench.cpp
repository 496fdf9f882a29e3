// How long the stages of one scenario take, and what comes out.
// Usage: field_bench SCENARIO.yaml [--json]
#include <cstdlib>

#include "bench/figures.h"
#include "evaluate/coverage.h"
#include "evaluate/metrics.h"
#include "evaluate/scenario.h"
#include "planner/planners.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

std::vector<bench::Figure> measure(const char* file) {
  std::vector<bench::Figure> figures;
  auto start = std::chrono::steady_clock::now();
  const auto lap = [&](const char* name, const char* target) {
    figures.push_back({name, bench::seconds_since(start), "s", target});
    start = std::chrono::steady_clock::now();
  };
  const Scenario scenario = read_scenario(file);
  const Stage stage = load_stage(scenario);
  lap("read scenario, field and terrain", "");
  const Plan plan = find_planner(scenario.planner.name, file).plan(plan_request(scenario, stage));
  const Path path = make_path(stage.field, stage.vehicle, plan, scenario.path);
  lap("plan and make it drivable", "< 5");
  const RunRecord run = simulate(
      {stage.field, stage.terrain, stage.soil, stage.vehicle, path, scenario.simulation, {}});
  lap("drive", "< 120");
  const double drive_s = figures.back().value;
  const CoverageFigures coverage = coverage_figures(
      measure_coverage(stage.field, run.footprints, stage.vehicle.implement.working_width_m,
                       scenario.coverage_cell_m));
  lap("measure coverage", "");
  const double both_s = drive_s + figures.back().value;
  figures.push_back(
      {"drive and coverage, times real time", run.duration_s / both_s, "x", ">= 1000"});
  const Metrics metrics = measure_run(path, run, coverage);
  figures.push_back({"distance", metrics.distance_m / 1000.0, "km", ""});
  figures.push_back({"simulated time", metrics.time_s / 3600.0, "h", ""});
  figures.push_back({"coverage", 100.0 * metrics.coverage_ratio, "%", ""});
  figures.push_back({"energy", metrics.energy_wh / 1000.0, "kWh", ""});
  figures.push_back({"ledger residual", 100.0 * metrics.ledger_residual_ratio, "%", "< 0.1"});
  return figures;
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: field_bench SCENARIO.yaml [--json]\n", stderr);
    return 2;
  }
  try {
    headland::bench::print(headland::measure(argv[1]), headland::bench::wants_json(argc, argv));
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "field_bench: %s\n", error.what());
    return 2;
  }
  return EXIT_SUCCESS;
}
