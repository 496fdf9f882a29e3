// Grid planners' plans on examples/maps driven in physics: paper 001's fields by the transplanter,
// paper 000's tractor map by the horticultural tractor.
// Usage: grid_drive [--margin METRES] [--only TEXT] [--json], of rows whose name has the text.
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bench/figures.h"
#include "evaluate/coverage.h"
#include "evaluate/metrics.h"
#include "planner/grid_drivable.h"
#include "planner/grid_planners.h"
#include "sim/simulation.h"
#include "terrains/grid_field.h"
#include "terrains/grid_map_file.h"
#include "terrains/input_error.h"
#include "terrains/soil_source.h"
#include "terrains/terrain_source.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {
namespace {

// The battery's voltage at the end of Wu et al. 2023 (10.20944/preprints202305.1306.v1), 3.4 and
// Table 2: percent consumed by boustrophedon and by their genetic algorithm.
struct Course {
  std::string_view map;
  std::string_view vehicle;
  GridObjective objective = GridObjective::kWeighted;
  std::string_view printed_boustrophedon;
  std::string_view printed_iga;
};

constexpr std::array<Course, 5> kCourses = {{
    {"field_A", "transplanter", GridObjective::kWeighted, "29", "29"},
    {"field_B", "transplanter", GridObjective::kWeighted, "71", "66"},
    {"field_C", "transplanter", GridObjective::kWeighted, "56", "51"},
    {"field_D", "transplanter", GridObjective::kWeighted, "85", "72"},
    {"tractor", "horticultural_tractor", GridObjective::kTractor, "", ""},
}};

// Iterations: enough that the plans are typical of their planners, few enough for all rows.
constexpr int kIterations = 100;
constexpr int kLocalSearchIterations = 20;  // each is as many moves as there are cells

struct Asked {
  double margin_m = -1.0;  // negative: what the vehicle turns on
  std::string only;
  bool json = false;
};

std::string_view printed(const Course& course, const GridPlannerEntry& planner) {
  if (planner.name == "grid_boustrophedon") return course.printed_boustrophedon;
  return planner.name == "grid_iga" ? course.printed_iga : "";
}

nlohmann::ordered_json driven(const Course& course, const GridPlannerEntry& planner,
                              const Asked& asked) {
  const Vehicle vehicle = load_vehicle(std::string(course.vehicle));
  GridPlanRequest request;
  request.map =
      read_grid_map(HEADLAND_SOURCE_DIR "/examples/maps/" + std::string(course.map) + ".txt",
                    vehicle.implement.working_width_m);
  request.cost.objective = course.objective;
  request.parameters = resolve_parameters(planner.parameters, {}, "grid_drive", "");
  request.stop.iterations =
      planner.name == "grid_local_search" ? kLocalSearchIterations : kIterations;
  const PathOptions options;
  const double margin_m = asked.margin_m < 0.0 ? grid_margin_m(vehicle, options) : asked.margin_m;
  const Field field = field_of_grid(request.map, margin_m, "grid_drive");
  nlohmann::ordered_json row;
  row["map"] = course.map;
  row["planner"] = planner.name;
  auto begun = std::chrono::steady_clock::now();
  const GridPlan plan = planner.plan(request);
  row["plan_s"] = seconds_since(begun);
  row["grid_turns"] = plan.counts.turns;
  row["grid_u_turns"] = plan.counts.u_turns;
  row["grid_repeats"] = plan.counts.repeats;
  begun = std::chrono::steady_clock::now();
  const GridDrive drive = make_grid_path(field, vehicle, request.map, plan, options);
  row["path_s"] = seconds_since(begun);
  row["runs"] = drive.plan.passes.size();
  row["added"] = drive.added_passes;
  row["left_out"] = drive.left_out.size();
  row["unworked_percent"] = 100.0 * drive.unworked_ratio;
  const Heightfield terrain = read_terrain({}, field, "grid_drive");
  const SoilMap soil = read_soil({}, field, "grid_drive").map;
  begun = std::chrono::steady_clock::now();
  const RunRecord run = simulate({field, terrain, soil, vehicle, drive.path, {}, {}});
  constexpr double kCoverageCell_m = 0.05;
  const Metrics metrics =
      measure_run(drive.path, run,
                  coverage_figures(measure_coverage(
                      field, run.footprints, vehicle.implement.working_width_m, kCoverageCell_m)));
  row["drive_s"] = seconds_since(begun);
  row["outcome"] = outcome_name(run.outcome);
  row["overrun_m"] = run.peaks.boundary_overrun_m.value;
  row["coverage_percent"] = 100.0 * metrics.coverage_ratio;
  row["overlap_percent"] = 100.0 * metrics.overlap_ratio;
  row["outside_percent"] = 100.0 * metrics.outside_area_ratio;
  row["time_min"] = metrics.time_s / 60.0;
  row["distance_m"] = metrics.distance_m;
  row["energy_wh"] = metrics.energy_wh;
  row["turns"] = metrics.turns;
  row["u_turns"] = metrics.u_turns;
  row["delta_soc_percent"] = 100.0 * metrics.delta_soc;
  row["voltage_drop_v"] = metrics.rested_voltage_drop_v;
  row["printed_percent"] = printed(course, planner);
  return row;
}

void print_row(const nlohmann::ordered_json& row) {
  std::puts(fmt::format("{:<8} {:<19} {:>3}/{:>3}/{:>3} {:>5} {:>5} {:>5} {:<9} {:>7.3f} {:>8.2f} "
                        "{:>7.1f} {:>6.2f} {:>6.1f} {:>7.0f} {:>6.0f} {:>4}/{:<4} {:>6.2f} {:>4} "
                        "{:>5.1f} {:>5.1f} {:>5.1f}",
                        row["map"].get<std::string>(), row["planner"].get<std::string>(),
                        row["grid_repeats"].get<int>(), row["grid_turns"].get<int>(),
                        row["grid_u_turns"].get<int>(), row["runs"].get<int>(),
                        row["added"].get<int>(), row["left_out"].get<int>(),
                        row["outcome"].get<std::string>(), row["overrun_m"].get<double>(),
                        row["coverage_percent"].get<double>(), row["overlap_percent"].get<double>(),
                        row["outside_percent"].get<double>(), row["time_min"].get<double>(),
                        row["distance_m"].get<double>(), row["energy_wh"].get<double>(),
                        row["turns"].get<int>(), row["u_turns"].get<int>(),
                        row["delta_soc_percent"].get<double>(),
                        row["printed_percent"].get<std::string>(), row["plan_s"].get<double>(),
                        row["path_s"].get<double>(), row["drive_s"].get<double>())
                .c_str());
  std::fflush(stdout);
}

int run_courses(const Asked& asked) {
  if (!asked.json) {
    std::puts(
        "map      planner             rep/trn/u-t  runs added  left outcome   overrun cover % "
        "overlap outs %  t min     m     Wh  turns/U  dSOC % 001% plan s path s drive s");
  }
  auto rows = nlohmann::ordered_json::array();
  for (const Course& course : kCourses) {
    for (const GridPlannerEntry& planner : grid_planners()) {
      const std::string name = std::string(course.map) + " " + std::string(planner.name);
      if (name.find(asked.only) == std::string::npos) continue;
      const auto row = driven(course, planner, asked);
      if (!asked.json) print_row(row);
      rows.push_back(row);
    }
  }
  if (asked.json) std::puts(rows.dump(2).c_str());
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::Asked asked;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--json") asked.json = true;
    if (word == "--only" && i + 1 < argc) asked.only = argv[++i];
    if (word == "--margin" && i + 1 < argc) asked.margin_m = std::atof(argv[++i]);
  }
  try {
    return headland::bench::run_courses(asked);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "grid_drive: %s\n", error.what());
    return 2;
  }
}
