// The tables of two papers on grid planners beside ours, on maps drawn by what the papers publish
// of theirs: numbers side by side, not a reproduction.
// `paper_tables [RUNS] [--json] [--only TEXT] [--free-end]`: RUNS seeds a row (3 unless told), rows
// whose table or name has TEXT; Wang et al. from the north-west corner to the south-east one, or to
// any. Everything with 3 runs takes about ten minutes on one core, half of it ant colonies.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "bench/figures.h"
#include "bench/paper_lines.h"
#include "bench/paper_rows.h"
#include "planner/algorithms/grid_ant_colony.h"
#include "planner/algorithms/grid_student_psychology.h"
#include "planner/algorithms/grid_tplp.h"
#include "planner/greedy_order.h"
#include "planner/grid_planners.h"
#include "terrains/grid_map_file.h"

namespace headland::bench {
namespace {

struct Asked {
  int runs = 3;
  std::string only;
  bool free_end = false;
  bool json = false;
};

// Wu et al., Table 2: what IGA saves, by the rows of Table 1.
constexpr std::string_view kTable1 = "001 Table 1";
constexpr std::string_view kReductions = "001 Table 2";

bool is_asked(const Asked& asked, std::string_view table, const std::string& name) {
  return (std::string(table) + " " + name).find(asked.only) != std::string::npos;
}

// Table 2 alone takes what Table 1 measures, unprinted.
bool only_reductions(const Asked& asked) {
  return !asked.only.empty() && (std::string(kReductions) + " ").starts_with(asked.only) &&
         !std::string(kTable1).starts_with(asked.only);
}

double value_of(const GridPlan& plan, Quantity quantity, double cell_m) {
  switch (quantity) {
    case Quantity::kSteps:
      return plan.counts.steps;
    case Quantity::kRepeatRate:
      return 100.0 * repeat_rate(plan);
    case Quantity::kConvergence:
      return plan.convergence.back().iteration;
    case Quantity::kFitness:
      return plan.fitness;
    case Quantity::kRepeats_m2:
      return plan.counts.repeats * cell_m * cell_m;
    case Quantity::kTurns:
      return plan.counts.turns;
    case Quantity::kUTurns:
      break;
  }
  return plan.counts.u_turns;
}

// Wang et al., 5.4.1: their heights, of another paper, are not published. A rise across the map
// with waves of some decimetres.
void add_heights(GridMap& map) {
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.height_m.push_back(0.05 * column + 0.3 * std::sin(0.7 * column) * std::sin(0.5 * row));
    }
  }
}

constexpr double kFieldCell_m = 2.0;  // Wu et al. 2023, 3.1

GridPlanRequest request_for(const PaperRow& row, const Asked& asked) {
  const bool is_field = row.map.starts_with("field");
  GridPlanRequest request;
  request.map = read_grid_map(HEADLAND_SOURCE_DIR "/examples/maps/" + std::string(row.map) + ".txt",
                              is_field ? kFieldCell_m : 1.0);
  if (row.objective == GridObjective::kTractor) add_heights(request.map);
  request.cost.objective = row.objective;
  if (!is_field) {
    request.start = GridCell{0, request.map.rows - 1};
    if (!asked.free_end) request.end = GridCell{request.map.columns - 1, 0};
  }
  request.parameters = resolve_parameters(find_grid_planner(row.planner, "paper_tables").parameters,
                                          row.parameters, "paper_tables", "");
  // Wu et al., 3.1 and 3.2.
  if (row.table == kTable1) request.stop = {5000, 0, 0.0, 500};
  if (row.table == "001 Figure 15") request.stop = {1000, 0, 0.0, 0};
  if (row.planner == "grid_local_search") request.stop.iterations = 50;
  return request;
}

std::vector<Line> begun_lines(std::string_view table, const std::string& name,
                              const std::vector<Printed>& printed) {
  std::vector<Line> lines;
  for (const Printed& one : printed) {
    lines.push_back(
        {std::string(table), name, one.quantity, {}, 0.0, one.mean, one.deviation, false});
  }
  return lines;
}

std::vector<Line> measured_row(const PaperRow& row, const Asked& asked) {
  std::vector<Line> lines = begun_lines(row.table, row.name, row.printed);
  GridPlanRequest request = request_for(row, asked);
  const double begun = cpu_seconds();
  for (int run = 0; run < asked.runs; ++run) {
    request.seed = static_cast<std::uint64_t>(run + 1);
    const GridPlan plan = find_grid_planner(row.planner, "paper_tables").plan(request);
    for (Line& line : lines) {
      line.values.push_back(value_of(plan, line.quantity, request.map.cell_m));
    }
  }
  for (Line& line : lines) line.seconds = (cpu_seconds() - begun) / asked.runs;
  return lines;
}

// Of tables that try a part of a planner: the least length that `part` comes to.
struct PartRow {
  std::string_view table;
  std::string name;
  Printed length;
  Printed repeat_rate;
  std::function<double(OrderTask&)> part;
};

double shortest(const OrderTask& task, const std::vector<std::vector<int>>& orders) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& order : orders) least = std::min(least, full_cost(task.cost, order));
  return least;
}

constexpr int kPopulation = 50;

template <typename Order>  // std::vector<int>()
double shortest_of(const OrderTask& task, Order order) {
  std::vector<std::vector<int>> orders;
  for (int i = 0; i < kPopulation; ++i) orders.push_back(order());
  return shortest(task, orders);
}

Parameters defaults_of(std::string_view planner) {
  return resolve_parameters(find_grid_planner(planner, "paper_tables").parameters, {},
                            "paper_tables", "");
}

double evolved_from_ants(OrderTask& task, const Improve& improve) {
  Population population;
  for (const std::vector<int>& order : first_ants(task, defaults_of("grid_aco"))) {
    population.push_back(individual_of(task.cost, order));
  }
  evolve(task, population, improve);
  return population.front().cost;
}

std::vector<PartRow> part_rows() {
  return {
      {"000 Table 2",
       "random orders",
       {Quantity::kSteps, 4606.7, 54.935},
       {Quantity::kRepeatRate, 47.54, 3.6},
       [](OrderTask& task) {
         return shortest_of(task, [&] { return random_order(task.problem, task.random); });
       }},
      {"000 Table 2",
       "first ants",
       {Quantity::kSteps, 529.5, 14.795},
       {Quantity::kRepeatRate, 37.57, 2.3},
       [](OrderTask& task) { return shortest(task, first_ants(task, defaults_of("grid_aco"))); }},
      {"000 Table 2",
       "greedy orders",
       {Quantity::kSteps, 418.6, 7.950},
       {Quantity::kRepeatRate, 9.99, 0.8},
       [](OrderTask& task) {
         return shortest_of(
             task, [&] { return greedy_order(task.problem, task.table, 1.0, 5.0, task.random); });
       }},
      {"000 Table 3",
       "ants",
       {Quantity::kSteps, 451.2, 4.467},
       {Quantity::kRepeatRate, 22.99, 1.7},
       [](OrderTask& task) {
         const Parameters parameters = defaults_of("grid_aco");
         const auto first = first_ants(task, parameters);
         return full_cost(task.cost, best_of_ants(task, parameters, first));
       }},
      {"000 Table 3",
       "student psychology",
       {Quantity::kSteps, 441.8, 7.194},
       {Quantity::kRepeatRate, 22.04, 2.1},
       [](OrderTask& task) { return evolved_from_ants(task, student_psychology()); }},
      {"000 Table 3",
       "learning perturbation",
       {Quantity::kSteps, 395.3, 4.219},
       {Quantity::kRepeatRate, 10.60, 1.1},
       [](OrderTask& task) {
         return evolved_from_ants(task, learning_perturbation(defaults_of("grid_tplp")));
       }},
  };
}

constexpr int kPartIterations = 100;  // Wang et al., 5.2.2

// Lengths, and the repeat rates that follow from them: repeats are the steps above the least.
std::vector<Line> measured_part(const PartRow& row, const Asked& asked) {
  std::vector<Line> lines = begun_lines(row.table, row.name, {row.length, row.repeat_rate});
  const PaperRow like{row.table, row.name, "env_I", "grid_tplp", {}, GridObjective::kLength, {}};
  GridPlanRequest request = request_for(like, asked);
  request.stop.iterations = kPartIterations;
  const double begun = cpu_seconds();
  for (int run = 0; run < asked.runs; ++run) {
    request.seed = static_cast<std::uint64_t>(run + 1);
    OrderTask task(request);
    const double steps = row.part(task);
    const double cells = task.problem.graph.size();
    lines[0].values.push_back(steps);
    lines[1].values.push_back(100.0 * (steps - cells + 1.0) / cells);
  }
  for (Line& line : lines) line.seconds = (cpu_seconds() - begun) / asked.runs;
  return lines;
}

// Wu et al., Table 2: by how much IGA's means are below boustrophedon's.
std::vector<Line> reductions(const std::vector<Line>& table_1) {
  std::vector<Line> lines;
  for (const Line& iga : table_1) {
    const auto space = iga.name.find(' ');
    const auto rows = std::ranges::find_if(table_1, [&](const Line& line) {
      return line.name == iga.name.substr(0, space) + " grid_boustrophedon" &&
             line.quantity == iga.quantity;
    });
    if (rows == table_1.end() || !iga.name.ends_with("grid_iga")) continue;
    Line line = iga;
    line.table = kReductions;
    line.more_is_better = true;
    line.name = iga.name.substr(0, space) + " less by IGA";
    for (double& value : line.values) value = rows->values.front() - value;
    line.printed_mean = rows->printed_mean - iga.printed_mean;
    lines.push_back(line);
  }
  return lines;
}

std::vector<Line> measured_table(std::string_view table, const Asked& asked,
                                 const std::vector<Line>& before) {
  if (table == kReductions) return reductions(before);
  std::vector<Line> lines;
  for (const PartRow& row : part_rows()) {
    if (row.table == table && is_asked(asked, table, row.name)) {
      const std::vector<Line> more = measured_part(row, asked);
      lines.insert(lines.end(), more.begin(), more.end());
    }
  }
  for (const auto& rows : {wang_rows(), wu_rows()}) {
    for (const PaperRow& row : rows) {
      const bool wanted =
          is_asked(asked, table, row.name) || (table == kTable1 && only_reductions(asked));
      if (row.table != table || !wanted) continue;
      const std::vector<Line> more = measured_row(row, asked);
      lines.insert(lines.end(), more.begin(), more.end());
    }
  }
  if (table == kTable1) {
    const std::vector<Line> more = averages(lines);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

// Whether any row was asked for.
bool run_tables(const Asked& asked) {
  auto json = nlohmann::ordered_json::array();
  std::vector<Line> lines;
  bool any = false;
  for (const auto& [table, why] : table_notes()) {
    lines = measured_table(table, asked, lines);
    if (lines.empty() || (table == kTable1 && only_reductions(asked))) continue;
    any = true;
    if (!asked.json) fmt::print("{}: {}\n", table, why);
    for (const Line& line : lines) {
      if (asked.json) {
        json.push_back(json_of(line, why));
      } else {
        print_line(line);
      }
    }
    std::fflush(stdout);
  }
  if (asked.json && any) std::puts(json.dump(2).c_str());
  return any;
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::Asked asked;
  CLI::App app("The tables of two papers on grid planners, ours beside the printed ones");
  app.add_option("RUNS", asked.runs, "Seeds a row")->check(CLI::Range(1, 1000));
  app.add_option("--only", asked.only, "Rows whose table or name has this");
  app.add_flag("--free-end", asked.free_end, "Wang et al. end anywhere");
  app.add_flag("--json", asked.json, "For machines");
  CLI11_PARSE(app, argc, argv);
  if (headland::bench::run_tables(asked)) return 0;
  fmt::print(stderr, "paper_tables: no row has '{}'\n", asked.only);
  return 2;
}
