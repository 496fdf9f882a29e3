// What planning by measured costs saves when driven, on made-up fields that nothing was fitted to,
// and the most that any plan could save. Usage: savings [fields|maps] [--count N] [--area M2]
// [--vehicle NAME] [--store FILE] [--jobs N] [--json]. `fields`: irregular ones with holes and
// trees on rolling ground, over boustrophedon in one direction for all, rows as they lie; `maps`:
// grid maps, over the same planner with two papers' printed weights.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "bench/figures.h"
#include "bench/scratch.h"
#include "evaluate/method_savings.h"
#include "evaluate/planner_cost.h"
#include "evaluate/sweep.h"
#include "terrains/field_generator.h"
#include "terrains/grid_map_file.h"
#include "terrains/grid_map_generator.h"

namespace headland::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Asked {
  std::string suite = "fields";
  std::string vehicle = "transplanter";
  std::string store;  // empty: a scratch one
  double area_m2 = 5000.0;
  int count = 10;
  int jobs = 2;
  bool json = false;
};

constexpr FieldShape kShapes[] = {FieldShape::kConcave, FieldShape::kConvex, FieldShape::kL};
constexpr int kHoles = 2;
constexpr int kTrees = 3;
constexpr int kIterations = 20;  // of the local search
constexpr double kObstacleShare = 0.12;

std::string ring_text(const Ring& ring) {
  std::vector<std::string> points;
  for (const Eigen::Vector2d& p_W : ring) {
    points.push_back(fmt::format("[{:.3f}, {:.3f}]", p_W.x(), p_W.y()));
  }
  return fmt::format("[{}]", fmt::join(points, ", "));
}

std::string field_text(int i, const Asked& asked) {
  FieldRecipe recipe;
  recipe.shape = kShapes[static_cast<std::size_t>(i) % std::size(kShapes)];
  recipe.area_m2 = asked.area_m2;
  recipe.holes = kHoles;
  recipe.trees = kTrees;
  recipe.seed = static_cast<std::uint64_t>(1000 + i);
  const Field field = made_up_field(recipe);
  std::vector<std::string> holes;
  for (const Ring& hole : field.holes) holes.push_back(ring_text(hole));
  std::vector<std::string> trees;
  for (const Obstacle& tree : field.obstacles) {
    trees.push_back(fmt::format("{{kind: tree, at: [{:.3f}, {:.3f}], radius_m: {:g}, height_m: 5}}",
                                tree.p_W.x(), tree.p_W.y(), tree.radius_m));
  }
  return fmt::format("  {}_{}: {{boundary: {}, holes: [{}], obstacles: [{}]}}\n",
                     field_shape_name(recipe.shape), i + 1, ring_text(field.boundary),
                     fmt::join(holes, ", "), fmt::join(trees, ", "));
}

std::string map_text(int i, const Asked& asked, const Scratch& scratch) {
  const double width_m = load_vehicle(asked.vehicle).implement.working_width_m;
  const int side = static_cast<int>(std::round(std::sqrt(asked.area_m2) / width_m));
  const GridMapRecipe recipe{side, side, kObstacleShare, std::max(2, side / 5),
                             static_cast<std::uint64_t>(1000 + i)};
  const std::string name = fmt::format("map_{}", i + 1);
  std::ofstream(scratch.folder / (name + ".txt"))
      << grid_map_text(made_up_grid_map(recipe, "savings"));
  return fmt::format("  {}: {{grid_map: {}.txt}}\n", name, name);
}

struct Suite {
  std::string planners;
  std::vector<std::string> references;
};

Suite suite_of(const Asked& asked) {
  if (asked.suite == "fields") {
    return {
        "  boustrophedon: {name: boustrophedon, swath_direction_deg: 0, "
        "swath_order: boustrophedon, predict: COSTS}\n"
        "  best direction: {name: boustrophedon, predict: COSTS}\n"
        "  in parts: {name: decomposed, predict: COSTS}\n"
        "  measured costs: {name: boustrophedon, cost: COSTS}\n"
        "  measured, in parts: {name: decomposed, cost: COSTS}\n",
        {"boustrophedon", "best direction"}};
  }
  std::string text = "  boustrophedon: {name: grid_boustrophedon, predict: COSTS}\n";
  const auto add = [&](const char* label, const char* cost) {
    text += fmt::format(
        "  {}: {{name: grid_local_search, predict: COSTS, cost: {{{}}}, stop: {{iterations: "
        "{}}}}}\n",
        label, cost, kIterations);
  };
  add("Wu et al. weights", "objective: weighted");
  add("Wang et al. weights", "objective: tractor");
  add("length", "objective: length");
  add("measured costs", "objective: measured, file: COSTS");
  return {text, {"Wu et al. weights", "Wang et al. weights", "length", "boustrophedon"}};
}

Sweep sweep_of(const Asked& asked, const Suite& suite, const Scratch& scratch) {
  std::string text = fmt::format("name: {} {}\nfields:\n", asked.suite, asked.vehicle);
  for (int i = 0; i < asked.count; ++i) {
    text += asked.suite == "fields" ? field_text(i, asked) : map_text(i, asked, scratch);
  }
  text += fmt::format(
      "terrains: {{rolling: {{generator: rolling, amplitude_m: 2, wavelength_m: 80}}}}\n"
      "soils: [firm]\nvehicles: [{}]\nsimulation: {{record_hz: 1}}\nplanners:\n",
      asked.vehicle);
  std::string planners = suite.planners;
  for (std::size_t at = 0; (at = planners.find("COSTS", at)) != std::string::npos;) {
    planners.replace(at, std::string_view("COSTS").size(), asked.vehicle + ".yaml");
  }
  const fs::path file = scratch.folder / "savings.sweep.yaml";
  std::ofstream(file) << text << planners;
  return read_sweep(file);
}

// W h a metre, worked in the direction that is best at each place, up and down in turn: the mean
// over the field.
double least_wh_per_m(const Stage& stage, const DriveCost& cost) {
  constexpr double kStep_m = 2.0;
  constexpr int kDirections = 18;  // of half a circle
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : stage.field.boundary) box.extend(p_W);
  double sum = 0.0;
  int places = 0;
  for (double x_m = box.min().x(); x_m < box.max().x(); x_m += kStep_m) {
    for (double y_m = box.min().y(); y_m < box.max().y(); y_m += kStep_m) {
      if (!inside_field(stage.field, {x_m, y_m})) continue;
      const double slope = surface_at(stage.terrain, x_m, y_m).gradient.norm();
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i < kDirections; ++i) {
        const double angle_rad = M_PI * i / kDirections;
        const double along = slope * std::cos(angle_rad);
        const double across = slope * std::sin(angle_rad);
        least = std::min(least, 0.5 * (wh_per_m(cost.working, along, across) +
                                       wh_per_m(cost.working, -along, across)));
      }
      sum += least;
      ++places;
    }
  }
  return sum / places;
}

// Where a method's energy went, as shares of it, means over its fields.
struct Shares {
  double unavoidable = 0.0;  // its ground worked once, in the best direction at each place
  double working = 0.0;      // swaths and headland passes
  double turning = 0.0;      // turns and transits
  double overlap = 0.0;      // working what was worked before
};

Shares shares_of(const Sweep& sweep, RunStore& store, const DriveCost& cost, double width_m,
                 const std::string& method) {
  const Statement row = prepare(
      store.database,
      "SELECT place, energy_wh, covered_m2, overlap_m2, swath_wh + headland_pass_wh, turn_wh + "
      "u_turn_wh + transit_wh FROM runs WHERE sweep = ? AND planner = ? AND outcome = 'finished'");
  bind_value(row, 1, sweep.name);
  bind_value(row, 2, method);
  Shares sum;
  int runs = 0;
  while (step(row)) {
    const Stage stage = load_stage(scenario_at(sweep, static_cast<std::size_t>(number_at(row, 0))));
    const double wh = number_at(row, 1);
    const double wh_per_m2 = least_wh_per_m(stage, cost) / width_m;
    sum.unavoidable += number_at(row, 2) * wh_per_m2 / wh;
    sum.overlap += number_at(row, 3) * wh_per_m2 / wh;
    sum.working += number_at(row, 4) / wh;
    sum.turning += number_at(row, 5) / wh;
    ++runs;
  }
  for (double* share : {&sum.unavoidable, &sum.working, &sum.turning, &sum.overlap}) {
    *share /= std::max(1, runs);
  }
  return sum;
}

void print_table(const std::vector<MethodFigures>& all, const Suite& suite) {
  fmt::print("  {:<22}{:>6}{:>9}{:>9}{:>9}", "planned by", "runs", "Wh", "min", "cover %");
  for (const std::string& reference : suite.references) fmt::print("  {:>29}", "over " + reference);
  fmt::print("\n");
  for (const MethodFigures& one : all) {
    fmt::print("  {:<22}{:>6}{:>9.1f}{:>9.1f}{:>9.1f}", one.method, one.runs - one.faults,
               one.mean.energy_wh, one.mean.time_s / 60.0, 100.0 * one.mean.coverage_ratio);
    for (const std::string& reference : suite.references) {
      const Saving* saving = energy_saving(one, reference);
      fmt::print("  {:>29}",
                 saving == nullptr
                     ? std::string()
                     : fmt::format("{:.1f} +- {:.1f} %, p {:.2g}", 100.0 * saving->ratio.mean,
                                   100.0 * saving->ratio.ci95.value_or(0.0), saving->test.p));
    }
    fmt::print("{}\n", one.faults > 0 ? "  not driven: " + one.first_fault : "");
  }
}

Json json_of(const std::vector<MethodFigures>& all) {
  Json json = Json::array();
  for (const MethodFigures& one : all) {
    Json method = {{"method", one.method},          {"runs", one.runs},
                   {"without_figures", one.faults}, {"energy_wh", one.mean.energy_wh},
                   {"time_s", one.mean.time_s},     {"coverage_ratio", one.mean.coverage_ratio}};
    for (const MethodSavings& over : one.over) {
      const Saving& saving = over.savings.front();
      method["saves_over"][over.reference] = {{"mean_ratio", saving.ratio.mean},
                                              {"ci95_ratio", saving.ratio.ci95.value_or(0.0)},
                                              {"fields", saving.blocks},
                                              {"p", saving.test.p}};
    }
    json.push_back(std::move(method));
  }
  return json;
}

void run(const Asked& asked) {
  const Scratch scratch("savings");
  measure_vehicle(scratch, asked.vehicle, asked.jobs);
  const Suite suite = suite_of(asked);
  const Sweep sweep = sweep_of(asked, suite, scratch);
  RunStore store;
  open_run_store(asked.store.empty() ? scratch.folder / "runs.db" : fs::path(asked.store),
                 DatabaseMode::kWrite, store);
  ParallelOptions options;
  options.jobs = asked.jobs;
  run_sweep(sweep, store, {}, options);
  const std::vector<PlanRun> plans = plan_runs(sweep, store);
  const std::vector<MethodFigures> all = method_figures(plans, suite.references);
  std::vector<double> told;
  for (const PlanRun& plan : plans) {
    if (plan.fault.empty()) told.push_back(std::abs(plan.predicted_wh / plan.energy_wh - 1.0));
  }
  const double told_error = estimate_of(told).mean;
  Json json = {{"suite", asked.suite},
               {"vehicle", asked.vehicle},
               {"methods", json_of(all)},
               {"prediction_mean_absolute_error", told_error}};
  if (!asked.json) {
    fmt::print("{} of {:g} m2, {}\n", asked.suite, asked.area_m2, asked.vehicle);
    print_table(all, suite);
    fmt::print("  energy told by measured costs, mean absolute error: {:.2f} %\n",
               100.0 * told_error);
  }
  const Vehicle vehicle = load_vehicle(asked.vehicle);
  std::vector<std::string> notes;
  const DriveCost cost =
      read_drive_cost(scratch.folder / (asked.vehicle + ".yaml"), vehicle, "firm", notes);
  if (!asked.json) {
    fmt::print("  {:<22}{:>16}{:>16}{:>16}{:>22}\n", "of its energy", "working", "turns, ways",
               "overlap", "least possible");
  }
  for (const MethodFigures& one : all) {
    const Shares shares =
        shares_of(sweep, store, cost, vehicle.implement.working_width_m, one.method);
    json["shares"][one.method] = {{"working", shares.working},
                                  {"turning", shares.turning},
                                  {"overlap", shares.overlap},
                                  {"least_possible", shares.unavoidable}};
    if (asked.json) continue;
    fmt::print("  {:<22}{:>14.1f} %{:>14.1f} %{:>14.1f} %{:>20.1f} %\n", one.method,
               100.0 * shares.working, 100.0 * shares.turning, 100.0 * shares.overlap,
               100.0 * shares.unavoidable);
  }
  if (asked.json) std::puts(json.dump(2).c_str());
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::Asked asked;
  CLI::App app("What planning by measured costs saves when driven");
  app.add_option("SUITE", asked.suite, "What is planned")->check(CLI::IsMember({"fields", "maps"}));
  app.add_option("--count", asked.count, "Fields or maps")->check(CLI::Range(2, 1000));
  app.add_option("--area", asked.area_m2, "Of each [m2]")->check(CLI::Range(400.0, 1e6));
  app.add_option("--vehicle", asked.vehicle, "A built-in one");
  app.add_option("--store", asked.store, "SQLite file with the runs; what it holds is not driven");
  app.add_option("--jobs", asked.jobs, "Runs at the same time")->check(CLI::Range(1, 1024));
  app.add_flag("--json", asked.json, "For machines");
  CLI11_PARSE(app, argc, argv);
  try {
    headland::bench::run(asked);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "savings: %s\n", error.what());
    return 2;
  }
  return EXIT_SUCCESS;
}
