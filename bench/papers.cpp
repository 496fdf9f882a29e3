// The plans of three papers' tables driven in physics: what the papers print beside what our
// planners of that name count and what driving their plans takes, and whether the papers' ranking
// of planners survives the drive. Usage: papers [RUNS] [--only TEXT] [--iterations N] [--store
// FILE]
// [--jobs N] [--json]: RUNS seeds a row (1 unless told), maps and scenes whose name has TEXT.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "bench/figures.h"
#include "bench/paper_rows.h"
#include "bench/paper_scenes.h"
#include "bench/scratch.h"
#include "evaluate/rank_tests.h"
#include "evaluate/sweep.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Asked {
  int runs = 1;
  int iterations = 100;  // enough that plans are typical of their planners
  int jobs = 2;
  std::string only;
  std::string store;  // empty: a scratch one
  bool json = false;
};

// What is driven of a table: its planners on one of its maps.
struct Course {
  std::string_view table;
  std::string_view map;
  std::string_view vehicle;
  std::string_view objective;
  std::string_view terrain;
  std::vector<std::string> planners;
};

// The heights of neither paper's fields are published; Wu et al. drive on level ground.
constexpr std::string_view kLevel = "generator: flat";
constexpr std::string_view kRolling = "generator: rolling, amplitude_m: 1, wavelength_m: 40";

const std::vector<std::string> kWangPlanners = {"grid_aco",   "grid_gwo",  "grid_spbo",
                                                "grid_djaya", "grid_dtsa", "grid_tplp"};
const std::vector<std::string> kWuPlanners = {"grid_boustrophedon", "grid_iga"};

std::vector<Course> courses() {
  std::vector<Course> all;
  for (const std::string_view map : {"field_A", "field_B", "field_C", "field_D"}) {
    all.push_back({"001 Table 1 and 2", map, "transplanter", "weighted", kLevel, kWuPlanners});
  }
  all.push_back(
      {"000 Table 9", "tractor", "horticultural_tractor", "tractor", kRolling, kWangPlanners});
  for (const std::string_view map : {"env_I", "env_II", "env_III", "env_IV"}) {
    all.push_back({"000 Table 8", map, "horticultural_tractor", "length", kLevel, kWangPlanners});
  }
  return all;
}

// Percent of the battery's charge, Wu et al. 2023, 3.4 and Table 2.
const std::map<std::string, std::pair<double, double>>& printed_charge() {
  static const std::map<std::string, std::pair<double, double>> kPrinted = {
      {"field_A", {29.0, 29.0}},
      {"field_B", {71.0, 66.0}},
      {"field_C", {56.0, 51.0}},
      {"field_D", {85.0, 72.0}}};
  return kPrinted;
}

// What the paper ranks the planner by, less being better: percent of charge, 1 / fitness, length.
// NaN where it prints none.
double printed_of(const Course& course, const std::string& planner) {
  if (course.objective == "weighted") {
    const auto& [rows, iga] = printed_charge().at(std::string(course.map));
    if (planner == "grid_boustrophedon") return rows;
    return planner == "grid_iga" ? iga : kNotPrinted;
  }
  for (const PaperRow& row : wang_rows()) {
    if (row.table != course.table || row.map != course.map || row.planner != planner) continue;
    for (const Printed& printed : row.printed) {
      if (printed.quantity == Quantity::kFitness) return 1.0 / printed.mean;
      if (course.objective == "length" && printed.quantity == Quantity::kSteps) return printed.mean;
    }
  }
  return kNotPrinted;
}

std::string printed_counts(const Course& course, const std::string& planner) {
  std::string text;
  for (const auto& rows : {wang_rows(), wu_rows()}) {
    for (const PaperRow& row : rows) {
      if (!course.table.starts_with(row.table) || row.map != course.map || row.planner != planner) {
        continue;
      }
      for (const Printed& printed : row.printed) {
        if (!std::isfinite(printed.mean)) continue;
        text += fmt::format("{}{:.4g}", text.empty() ? "" : "/", printed.mean);
      }
      return text;
    }
  }
  return text;
}

// The paper's planners by the paper's objective; ours by the same, and by measured costs.
Sweep sweep_of(const Course& course, const Scratch& scratch, const Asked& asked) {
  constexpr int kLocalSearchIterations = 50;  // each is as many moves as there are cells
  const Vehicle vehicle = load_vehicle(std::string(course.vehicle));
  std::string text = fmt::format(
      "name: {}\nfields: {{{}: {{grid_map: {}/examples/maps/{}.txt, cell_m: {}}}}}\n"
      "terrains: {{ground: {{{}}}}}\nsoils: [firm]\nvehicles: [{}]\nseeds: {{count: {}}}\n"
      "simulation: {{record_hz: 1}}\nplanners:\n",
      course.map, course.map, HEADLAND_SOURCE_DIR, course.map, vehicle.implement.working_width_m,
      course.terrain, course.vehicle, asked.runs);
  const auto add = [&](std::string_view label, std::string_view planner, const std::string& cost,
                       int iterations) {
    text += fmt::format(
        "  {}: {{name: {}, predict: {}.yaml, cost: {{{}}}, stop: {{iterations: {}}}}}\n", label,
        planner, course.vehicle, cost, iterations);
  };
  const std::string objective = fmt::format("objective: {}", course.objective);
  for (const std::string& planner : course.planners) {
    add(planner, planner, objective, asked.iterations);
  }
  add("ours", "grid_local_search", objective, kLocalSearchIterations);
  add("ours by measured costs", "grid_local_search",
      fmt::format("objective: measured, file: {}.yaml", course.vehicle), kLocalSearchIterations);
  const fs::path file = scratch.folder / fmt::format("{}.sweep.yaml", course.map);
  std::ofstream(file) << text;
  return read_sweep(file);
}

// Means over the runs that finished.
struct Driven {
  std::string planner;
  int runs = 0;
  int finished = 0;
  std::map<std::string, double> mean;
};

constexpr const char* kColumns[] = {
    "grid_steps",          "grid_repeats", "grid_turns", "grid_u_turns",          "energy_wh",
    "predicted_energy_wh", "time_s",       "delta_soc",  "rested_voltage_drop_v", "coverage_ratio"};

std::vector<Driven> driven(const Sweep& sweep, RunStore& store, int jobs) {
  ParallelOptions options;
  options.jobs = jobs;
  run_sweep(sweep, store, {}, options);
  const Statement row = prepare(
      store.database, fmt::format("SELECT planner, outcome, {} FROM runs WHERE sweep = ? ORDER BY "
                                  "place",
                                  fmt::join(kColumns, ", ")));
  bind_value(row, 1, sweep.name);
  std::vector<Driven> all;
  for (const std::string& planner : sweep.planners) all.push_back({planner, 0, 0, {}});
  while (step(row)) {
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Driven& one) { return one.planner == text_at(row, 0); });
    ++found->runs;
    if (text_at(row, 1) != "finished") continue;
    ++found->finished;
    int column = 2;
    for (const char* key : kColumns) {
      double& mean = found->mean[key];
      mean += (number_at(row, column++) - mean) / found->finished;
    }
  }
  return all;
}

// Of the planners that the paper has figures of, its ranking against that of driven energy.
std::string finding(const Course& course, const std::vector<Driven>& all) {
  std::vector<double> printed;
  std::vector<double> wh;
  for (const Driven& one : all) {
    const double figure = printed_of(course, one.planner);
    if (!std::isfinite(figure) || one.finished == 0) continue;
    printed.push_back(figure);
    wh.push_back(one.mean.at("energy_wh"));
  }
  if (printed.size() < 2) return "too few planners were driven to rank";
  if (printed.size() == 2) {
    if (printed[0] == printed[1]) return "the paper has no difference";
    const bool same = (printed[0] < printed[1]) == (wh[0] < wh[1]);
    return fmt::format("the paper's order {} when driven ({:+.1f} % printed, {:+.1f} % driven)",
                       same ? "holds" : "is reversed", 100.0 * (printed[1] / printed[0] - 1.0),
                       100.0 * (wh[1] / wh[0] - 1.0));
  }
  return fmt::format("Spearman of the paper's ranking and the driven one: {:.2f} over {} planners",
                     spearman(printed, wh), printed.size());
}

// Why the planners count otherwise than the paper prints.
std::string why_different(const Course& course) {
  for (const auto& [table, why] : table_notes()) {
    if (course.table.starts_with(table)) return std::string(why);
  }
  return "";
}

void print_course(const Course& course, const std::vector<Driven>& all) {
  fmt::print("{}, {}: {}\n", course.table, course.map, finding(course, all));
  fmt::print("  {:<24}{:>20}{:>10}{:>22}{:>9}{:>9}{:>8}{:>8}{:>9}{:>9}\n", "planner",
             "paper prints", "ranked by", "steps/rep/turns/U", "Wh", "told", "min", "dSOC %",
             "drop V", "cover %");
  for (const Driven& one : all) {
    const double figure = printed_of(course, one.planner);
    fmt::print("  {:<24}{:>20}{:>10}", one.planner, printed_counts(course, one.planner),
               std::isfinite(figure) ? fmt::format("{:.4g}", figure) : "");
    if (one.finished == 0) {
      fmt::print("   none of {} runs finished\n", one.runs);
      continue;
    }
    const auto mean = [&](const char* key) { return one.mean.at(key); };
    fmt::print(
        "{:>22}{:>9.1f}{:>9.1f}{:>8.1f}{:>8.2f}{:>9.3f}{:>9.1f}{}\n",
        fmt::format("{:.0f}/{:.0f}/{:.0f}/{:.0f}", mean("grid_steps"), mean("grid_repeats"),
                    mean("grid_turns"), mean("grid_u_turns")),
        mean("energy_wh"), mean("predicted_energy_wh"), mean("time_s") / 60.0,
        100.0 * mean("delta_soc"), mean("rested_voltage_drop_v"), 100.0 * mean("coverage_ratio"),
        one.finished < one.runs ? fmt::format("  {} of {} runs", one.finished, one.runs) : "");
  }
  fmt::print("  {}\n", why_different(course));
  std::fflush(stdout);
}

Json json_of(const Course& course, const std::vector<Driven>& all) {
  Json json = {{"table", course.table},
               {"map", course.map},
               {"finding", finding(course, all)},
               {"why", why_different(course)}};
  for (const Driven& one : all) {
    const double figure = printed_of(course, one.planner);
    json["planners"].push_back({{"planner", one.planner},
                                {"printed", printed_counts(course, one.planner)},
                                {"ranked_by", std::isfinite(figure) ? Json(figure) : Json()},
                                {"runs", one.runs},
                                {"finished", one.finished},
                                {"mean", one.mean}});
  }
  return json;
}

void run_courses(const Asked& asked) {
  const Scratch scratch("papers");
  RunStore store;
  open_run_store(asked.store.empty() ? scratch.folder / "runs.db" : fs::path(asked.store),
                 DatabaseMode::kWrite, store);
  Json json = Json::array();
  for (const Course& course : courses()) {
    if (course.map.find(asked.only) == std::string_view::npos) continue;
    measure_vehicle(scratch, std::string(course.vehicle), asked.jobs);
    const std::vector<Driven> all = driven(sweep_of(course, scratch, asked), store, asked.jobs);
    if (asked.json) {
      json.push_back(json_of(course, all));
    } else {
      print_course(course, all);
    }
  }
  for (const Json& scene : run_scenes(scratch, asked.only, asked.runs, asked.json)) {
    json.push_back(scene);
  }
  if (asked.json) std::puts(json.dump(2).c_str());
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::Asked asked;
  CLI::App app("The plans of three papers' tables, driven");
  app.add_option("RUNS", asked.runs, "Seeds a row")->check(CLI::Range(1, 1000));
  app.add_option("--only", asked.only, "Maps and scenes whose name has this");
  app.add_option("--iterations", asked.iterations, "Of every planner but ours")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--store", asked.store, "SQLite file with the runs; what it holds is not driven");
  app.add_option("--jobs", asked.jobs, "Runs at the same time")->check(CLI::Range(1, 1024));
  app.add_flag("--json", asked.json, "For machines");
  CLI11_PARSE(app, argc, argv);
  try {
    headland::bench::run_courses(asked);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "papers: %s\n", error.what());
    return 2;
  }
  return EXIT_SUCCESS;
}
