// Planning of irregular fields: how long it takes, and whether the paths stay inside and cover what
// can be reached.
// Usage: polygon_bench suite [--fields N] [--first N] [--vehicle NAME] [--set KEY=VALUE] [--json]
//        polygon_bench drive [--fields N] [--most-ha HA] [--vehicle NAME] [--set KEY=VALUE]
//        [--json]
//        polygon_bench times [--swaths N] [--field FILE] [--set KEY=VALUE] [--json]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <string>
#include <vector>

#include "bench/field_drives.h"
#include "bench/field_suite_rows.h"
#include "bench/figures.h"
#include "bench/planning_times.h"
#include "evaluate/parallel_runs.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

struct Asked {
  int fields = 200;
  int first = 0;
  int jobs = 2;
  double most_ha = 1e9;
  std::vector<std::string> vehicles = {"transplanter", "utility_tractor"};
  std::vector<std::string> set;
  bool json = false;
};

Parameters parameters_of(const Asked& asked) {
  Parameters parameters;
  for (const std::string& text : asked.set) {
    const std::size_t at = text.find('=');
    const std::string value = at == std::string::npos ? "" : text.substr(at + 1);
    const auto number = parse_number(value);
    parameters[text.substr(0, at)] = number ? ParameterValue(*number) : ParameterValue(value);
  }
  return parameters;
}

void print_row(const SuiteRow& row) {
  std::string text =
      fmt::format("{:<8} {:>4} {:>8.2f} {:>2} {:<16}", field_shape_name(row.recipe.shape),
                  row.recipe.seed, 1e-4 * row.recipe.area_m2, row.recipe.holes, row.vehicle);
  if (!row.refusal.empty()) {
    std::puts((text + " refused: " + row.refusal).c_str());
  } else {
    double largest_m2 = row.missed.empty() ? 0.0 : row.missed.front().area_m2;
    std::puts(fmt::format("{} {:>5} {:>8.3f} {:>8.2f} {:>7.2f} {:>7.2f} {:>5} {:>5} {:>5} {:>8.1f} "
                          "{:>6.2f} {:>6.2f}",
                          text, row.passes, covered_percent(row),
                          100.0 * row.reachable_m2 / row.field_m2,
                          100.0 * row.overlap_m2 / row.field_m2,
                          100.0 * row.outside_m2 / row.field_m2, row.states_outside,
                          row.other_faults, row.missed.size(), largest_m2, row.plan_s, row.path_s)
                  .c_str());
  }
  std::fflush(stdout);
}

int run_suite(const Asked& asked) {
  std::vector<SuiteRow> rows;
  for (const FieldRecipe& recipe : field_suite(asked.first + asked.fields)) {
    if (recipe.seed <= static_cast<std::uint64_t>(asked.first)) continue;
    if (1e-4 * recipe.area_m2 > asked.most_ha) continue;
    for (const std::string& vehicle : asked.vehicles) {
      rows.emplace_back();
      rows.back().recipe = recipe;
      rows.back().vehicle = vehicle;
    }
  }
  if (!asked.json) {
    std::puts(
        "shape    seed       ha  h vehicle          passes cov/reach reach/field overlap outside "
        "hull< fault patch  largest plan_s path_s");
  }
  const Parameters parameters = parameters_of(asked);
  ParallelOptions options;
  options.jobs = asked.jobs;
  std::mutex mutex;
  run_in_parallel(rows.size(), options, [&](std::size_t i, const CancelAsked&) {
    rows[i] = suite_row(rows[i].recipe, rows[i].vehicle, parameters, PathOptions{}.clearance_m);
    const std::scoped_lock lock(mutex);
    if (!asked.json) print_row(rows[i]);
    return true;
  });
  if (asked.json) {
    auto json = nlohmann::ordered_json::array();
    for (const SuiteRow& row : rows) json.push_back(row_json(row));
    std::puts(json.dump(2).c_str());
    return EXIT_SUCCESS;
  }
  for (const std::string& vehicle : asked.vehicles) {
    int planned = 0, refused = 0, outside = 0, below = 0;
    double reachable = 0, missed = 0, field = 0, overlap = 0, worst = 100.0;
    for (const SuiteRow& row : rows) {
      if (row.vehicle != vehicle) continue;
      if (!row.refusal.empty()) {
        ++refused;
        continue;
      }
      ++planned;
      outside += row.states_outside + row.other_faults > 0 ? 1 : 0;
      below += covered_percent(row) < 99.5 ? 1 : 0;
      worst = std::min(worst, covered_percent(row));
      reachable += row.reachable_m2;
      missed += row.missed_m2;
      field += row.field_m2;
      overlap += row.overlap_m2;
    }
    std::puts(
        fmt::format("{}: planned {}, refused {}, with faults {}, below 99.5 % {}, worst {:.3f} %, "
                    "all together {:.3f} % of reachable, {:.3f} % reachable, overlap {:.2f} %",
                    vehicle, planned, refused, outside, below, worst,
                    100.0 * (1.0 - missed / reachable), 100.0 * reachable / field,
                    100.0 * overlap / field)
            .c_str());
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::Asked asked;
  CLI::App app("Planning of irregular fields");
  app.require_subcommand(1);
  auto* suite = app.add_subcommand("suite", "Made-up fields, planned and audited");
  suite->add_option("--fields", asked.fields, "How many");
  suite->add_option("--first", asked.first, "Leave out so many before");
  suite->add_option("--most-ha", asked.most_ha, "Leave out larger ones");
  suite->add_option("--jobs", asked.jobs, "Threads");
  suite->add_option("--vehicle", asked.vehicles, "Vehicles");
  suite->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner");
  suite->add_flag("--json", asked.json, "Print JSON");
  auto* drive = app.add_subcommand("drive", "Made-up fields, planned and driven in physics");
  headland::bench::DrivesAsked drives;
  drive->add_option("--fields", drives.fields, "How many");
  drive->add_option("--most-ha", drives.most_ha, "Leave out larger ones");
  drive->add_option("--clearance", drives.clearance_m, "Kept by the hull [m]");
  drive->add_option("--jobs", drives.jobs, "Threads");
  drive->add_option("--vehicle", drives.vehicles, "Vehicles");
  drive->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner");
  drive->add_flag("--json", asked.json, "Print JSON");
  auto* times = app.add_subcommand("times", "Time and memory over the number of swaths");
  headland::bench::TimesAsked sizes;
  times->add_option("--swaths", sizes.swaths, "How many");
  times->add_option("--field", sizes.files, "Files with fields to be planned too");
  times->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner for them");
  times->add_flag("--json", asked.json, "Print JSON");
  CLI11_PARSE(app, argc, argv);
  try {
    if (times->parsed()) {
      sizes.parameters = headland::bench::parameters_of(asked);
      sizes.json = asked.json;
      headland::bench::print_planning_times(sizes);
      return EXIT_SUCCESS;
    }
    if (drive->parsed()) {
      drives.parameters = headland::bench::parameters_of(asked);
      drives.json = asked.json;
      headland::bench::print_drives(drives);
      return EXIT_SUCCESS;
    }
    return headland::bench::run_suite(asked);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "polygon_bench: %s\n", error.what());
    return 2;
  }
}
