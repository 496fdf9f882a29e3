// Energy predicted from measured costs against energy driven, of plans that no cost was measured
// on. Measures the vehicles, plans fields and grid maps on level and rolling ground in several
// ways, drives every plan and compares. Usage: cost_check [--quick] [--json]: with --quick one
// vehicle on the small fields
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "bench/figures.h"
#include "bench/scratch.h"
#include "evaluate/rank_tests.h"
#include "evaluate/sweep.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kJobs = 2;

// With the micro-relief that costs are measured on.
constexpr const char* kTerrains =
    "terrains:\n"
    "  level: {generator: flat, micro_relief: {rms_m: 0.01}, cell_m: 0.5}\n"
    "  rolling: {generator: rolling, amplitude_m: 1.5, wavelength_m: 60, cell_m: 0.5, "
    "micro_relief: {rms_m: 0.01}}\n"
    "  hills: {generator: rolling, amplitude_m: 3, wavelength_m: 120, cell_m: 0.5, "
    "micro_relief: {rms_m: 0.01}}\n"
    "simulation: {record_hz: 1}\ncoverage: {cell_m: 0.5}\n";

constexpr const char* kSmallFields =
    "fields:\n"
    "  square: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\n"
    "  pond: {boundary: [[0, 0], [66, -4], [70, 45], [10, 50]], "
    "holes: [[[30, 20], [38, 20], [38, 28], [30, 28]]]}\n"
    "  wedge: {boundary: [[0, 0], [90, 10], [70, 60], [15, 45]]}\n";
constexpr const char* kLargeFields =
    "fields:\n"
    "  strip: {boundary: [[0, 0], [180, 0], [180, 90], [0, 90]]}\n"
    "  pond: {boundary: [[0, 0], [165, -10], [175, 112], [25, 125]], "
    "holes: [[[75, 50], [95, 50], [95, 70], [75, 70]]]}\n"
    "  wedge: {boundary: [[0, 0], [225, 25], [175, 150], [37, 112]]}\n";
constexpr const char* kDirections =
    "planners:\n"
    "  best direction: boustrophedon\n"
    "  30 degrees: {name: boustrophedon, swath_direction_deg: 30}\n"
    "  90 degrees: {name: boustrophedon, swath_direction_deg: 90}\n";

std::string grid_spec() {
  std::string text = "fields:\n";
  for (const char* map : {"field_A", "field_B", "field_C", "field_D"}) {
    text +=
        fmt::format("  {0}: {{grid_map: {1}/examples/maps/{0}.txt}}\n", map, HEADLAND_SOURCE_DIR);
  }
  const auto planner = [&](const char* label, const char* name, const char* objective) {
    text += fmt::format(
        "  {}: {{name: {}, cost: {{file: transplanter.yaml, objective: {}}}, stop: {{iterations: "
        "10}}}}\n",
        label, name, objective);
  };
  text += "planners:\n";
  planner("rows", "grid_boustrophedon", "measured");
  planner("fewest steps", "grid_local_search", "length");
  planner("fewest turns", "grid_local_search", "weighted");
  planner("measured costs", "grid_local_search", "measured");
  planner("TPLP", "grid_tplp", "measured");
  return text;
}

struct Pair {
  std::string where;  // vehicle, field, terrain, planner
  double predicted_wh = 0.0;
  double driven_wh = 0.0;
  double error() const { return predicted_wh / driven_wh - 1.0; }
};

// Runs the sweep; the finished drives, and the others' number.
int add_pairs(const Scratch& scratch, const std::string& name, const std::string& spec,
              std::vector<Pair>& pairs) {
  const fs::path file = scratch.folder / (name + ".yaml");
  std::ofstream(file) << spec;
  RunStore store;
  open_run_store(scratch.folder / (name + ".db"), DatabaseMode::kWrite, store);
  ParallelOptions options;
  options.jobs = kJobs;
  run_sweep(read_sweep(file), store, {}, options);
  const Statement row =
      prepare(store.database,
              "SELECT vehicle || ', ' || field || ', ' || terrain || ', ' || planner, "
              "predicted_energy_wh, energy_wh FROM runs WHERE outcome = 'finished' ORDER BY place");
  while (step(row)) {
    pairs.push_back({std::string(text_at(row, 0)), number_at(row, 1), number_at(row, 2)});
  }
  return static_cast<int>(
      whole_number_of(store.database, "SELECT count(*) FROM runs WHERE outcome IS NOT 'finished'"));
}

void add_summary(const std::string& name, const std::vector<Pair>& pairs, int others,
                 std::vector<Figure>& figures) {
  std::vector<double> predicted;
  std::vector<double> driven;
  double sum = 0.0;
  double bias = 0.0;
  double worst = 0.0;
  for (const Pair& pair : pairs) {
    predicted.push_back(pair.predicted_wh);
    driven.push_back(pair.driven_wh);
    sum += std::abs(pair.error());
    bias += pair.error();
    worst = std::max(worst, std::abs(pair.error()));
  }
  const double n = static_cast<double>(pairs.size());
  figures.push_back({name + ": plans", n, "", ""});
  figures.push_back({name + ": drives that did not finish", static_cast<double>(others), "", ""});
  figures.push_back({name + ": mean absolute error", 100.0 * sum / n, "%", "<= 3"});
  figures.push_back({name + ": mean error", 100.0 * bias / n, "%", ""});
  figures.push_back({name + ": worst error", 100.0 * worst, "%", ""});
  figures.push_back({name + ": Spearman", spearman(predicted, driven), "", ">= 0.95"});
}

void check(bool quick, bool as_json) {
  const Scratch scratch("cost-check");
  std::vector<Figure> figures;
  std::vector<Pair> all;
  int all_others = 0;
  const auto add = [&](const std::string& name, const std::string& spec) {
    std::vector<Pair> pairs;
    const int others = add_pairs(scratch, name, spec, pairs);
    for (const Pair& pair : pairs) {
      if (as_json) break;
      std::puts(fmt::format("{:<62}{:>10.1f} Wh predicted{:>10.1f} driven{:>8.2f} %", pair.where,
                            pair.predicted_wh, pair.driven_wh, 100.0 * pair.error())
                    .c_str());
    }
    add_summary(name, pairs, others, figures);
    all.insert(all.end(), pairs.begin(), pairs.end());
    all_others += others;
  };
  const auto vehicles = [](const char* name) {
    return fmt::format("vehicles: {{{0}: {{vehicle: {0}, cost: {0}.yaml}}}}\n", name);
  };
  measure_vehicle(scratch, "transplanter", kJobs);
  add("transplanter on fields", kSmallFields + vehicles("transplanter") + kDirections + kTerrains);
  if (!quick) {
    add("transplanter on grid maps", grid_spec() + vehicles("transplanter") + kTerrains);
    for (const char* name : {"utility_tractor", "four_wheel_steer_robot", "skid_steer_robot"}) {
      measure_vehicle(scratch, name, kJobs);
      add(fmt::format("{} on fields", name),
          kLargeFields + vehicles(name) + kDirections + kTerrains);
    }
    add_summary("all", all, all_others, figures);
  }
  print(figures, as_json);
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  try {
    const bool quick = std::any_of(argv + 1, argv + argc, [](const char* word) {
      return std::string_view(word) == "--quick";
    });
    headland::bench::check(quick, headland::bench::wants_json(argc, argv));
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "cost_check: %s\n", error.what());
    return 2;
  }
  return EXIT_SUCCESS;
}
