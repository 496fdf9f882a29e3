// The tables of two papers on grid planners beside ours, on maps drawn by what the papers publish
// of theirs: numbers side by side, not a reproduction.
// `paper_tables [RUNS] [--json] [--only TEXT] [--free-end]`: RUNS seeds a row (3 unless told), rows
// whose table or name has TEXT; Wang et al. from the north-west corner to the south-east one, or to
// any. Everything with 3 runs takes about ten minutes on one core, half of it ant colonies.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "bench/figures.h"
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

// One column of one row, ours and theirs.
struct Line {
  std::string table;
  std::string name;
  Quantity quantity = Quantity::kSteps;
  std::vector<double> values;  // by run
  double seconds = 0.0;        // of processor time a run
  double printed_mean = -1.0;
  double printed_deviation = -1.0;
};

// Wu et al., Table 2: what IGA saves.
constexpr std::string_view kReductions = "001 Table 2";

bool is_asked(const Asked& asked, std::string_view table, const std::string& name) {
  return (std::string(table) + " " + name).find(asked.only) != std::string::npos;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Of a sample; 0 of a single value.
double deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean(values)) * (value - mean(values));
  return std::sqrt(squares / (static_cast<double>(values.size()) - 1.0));
}

double best(const Line& line) {
  const bool most = line.quantity == Quantity::kFitness || line.table == kReductions;
  return most ? *std::ranges::max_element(line.values) : *std::ranges::min_element(line.values);
}

std::string_view unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kSteps:
      return "steps";
    case Quantity::kFitness:
      return "fitness";
    case Quantity::kRepeats_m2:
      return "m2 again";
    case Quantity::kTurns:
      return "turns";
    case Quantity::kUTurns:
      break;
  }
  return "U-turns";
}

double value_of(const GridPlan& plan, Quantity quantity, double cell_m) {
  switch (quantity) {
    case Quantity::kSteps:
      return plan.counts.steps;
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
  if (row.table == "001 Table 1") request.stop = {5000, 0, 0.0, 500};
  if (row.table == "001 Figure 15") request.stop = {1000, 0, 0.0, 0};
  if (row.planner == "grid_local_search") request.stop.iterations = 50;
  return request;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<Line> measured_row(const PaperRow& row, const Asked& asked) {
  std::vector<Line> lines;
  for (const Printed& printed : row.printed) {
    lines.push_back({std::string(row.table),
                     row.name,
                     printed.quantity,
                     {},
                     0.0,
                     printed.mean,
                     printed.deviation});
  }
  GridPlanRequest request = request_for(row, asked);
  const double begun = processor_seconds();
  for (int run = 0; run < asked.runs; ++run) {
    request.seed = static_cast<std::uint64_t>(run + 1);
    const GridPlan plan = find_grid_planner(row.planner, "paper_tables").plan(request);
    for (Line& line : lines) {
      line.values.push_back(value_of(plan, line.quantity, request.map.cell_m));
    }
  }
  for (Line& line : lines) line.seconds = (processor_seconds() - begun) / asked.runs;
  return lines;
}

// Of tables that try a part of a planner: the least length that `part` comes to.
struct PartRow {
  std::string_view table;
  std::string name;
  double printed_mean;
  double printed_deviation;
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
      {"000 Table 2", "random orders", 4606.7, 54.935,
       [](OrderTask& task) {
         return shortest_of(task, [&] { return random_order(task.problem, task.random); });
       }},
      {"000 Table 2", "first ants", 529.5, 14.795,
       [](OrderTask& task) { return shortest(task, first_ants(task, defaults_of("grid_aco"))); }},
      {"000 Table 2", "greedy orders", 418.6, 7.950,
       [](OrderTask& task) {
         return shortest_of(
             task, [&] { return greedy_order(task.problem, task.table, 1.0, 5.0, task.random); });
       }},
      {"000 Table 3", "ants", 451.2, 4.467,
       [](OrderTask& task) {
         const Parameters parameters = defaults_of("grid_aco");
         const auto first = first_ants(task, parameters);
         return full_cost(task.cost, best_of_ants(task, parameters, first));
       }},
      {"000 Table 3", "student psychology", 441.8, 7.194,
       [](OrderTask& task) { return evolved_from_ants(task, student_psychology()); }},
      {"000 Table 3", "learning perturbation", 395.3, 4.219,
       [](OrderTask& task) {
         return evolved_from_ants(task, learning_perturbation(defaults_of("grid_tplp")));
       }},
  };
}

constexpr int kPartIterations = 100;  // Wang et al., 5.2.2

Line measured_part(const PartRow& row, const Asked& asked) {
  Line line{std::string(row.table), row.name, Quantity::kSteps, {}, 0.0, row.printed_mean,
            row.printed_deviation};
  const PaperRow like{row.table, row.name, "env_I", "grid_tplp", {}, GridObjective::kLength, {}};
  GridPlanRequest request = request_for(like, asked);
  request.stop.iterations = kPartIterations;
  const double begun = processor_seconds();
  for (int run = 0; run < asked.runs; ++run) {
    request.seed = static_cast<std::uint64_t>(run + 1);
    OrderTask task(request);
    line.values.push_back(row.part(task));
  }
  line.seconds = (processor_seconds() - begun) / asked.runs;
  return line;
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
    line.name = iga.name.substr(0, space) + " less by IGA";
    for (double& value : line.values) value = rows->values.front() - value;
    line.printed_mean = rows->printed_mean - iga.printed_mean;
    lines.push_back(line);
  }
  return lines;
}

bool is_printed(const Line& line) {
  return line.printed_mean > 0.0 || line.table.starts_with("001");
}

void print_line(const Line& line) {
  std::string printed = is_printed(line) ? fmt::format("{:.6g}", line.printed_mean) : "-";
  if (line.printed_deviation >= 0.0) printed += fmt::format(" +- {:.3g}", line.printed_deviation);
  fmt::print("  {:<30} {:<8} {:>10.5g} +- {:<9.3g} best {:<9.5g} {:>8.3f} s   printed {}\n",
             line.name, unit_of(line.quantity), mean(line.values), deviation(line.values),
             best(line), line.seconds, printed);
}

nlohmann::ordered_json json_of(const Line& line, std::string_view why) {
  nlohmann::ordered_json json = {{"table", line.table},
                                 {"name", line.name},
                                 {"unit", unit_of(line.quantity)},
                                 {"runs", line.values.size()},
                                 {"mean", mean(line.values)},
                                 {"deviation", deviation(line.values)},
                                 {"best", best(line)},
                                 {"processor_s", line.seconds}};
  json["printed_mean"] = is_printed(line) ? nlohmann::ordered_json(line.printed_mean) : nullptr;
  json["printed_deviation"] =
      line.printed_deviation >= 0.0 ? nlohmann::ordered_json(line.printed_deviation) : nullptr;
  json["why_they_differ"] = why;
  return json;
}

std::vector<Line> measured_table(std::string_view table, const Asked& asked,
                                 const std::vector<Line>& before) {
  if (table == kReductions) return reductions(before);
  std::vector<Line> lines;
  for (const PartRow& row : part_rows()) {
    if (row.table == table && is_asked(asked, table, row.name)) {
      lines.push_back(measured_part(row, asked));
    }
  }
  for (const auto& rows : {wang_rows(), wu_rows()}) {
    for (const PaperRow& row : rows) {
      if (row.table != table || !is_asked(asked, table, row.name)) continue;
      const std::vector<Line> more = measured_row(row, asked);
      lines.insert(lines.end(), more.begin(), more.end());
    }
  }
  return lines;
}

void run_tables(const Asked& asked) {
  auto json = nlohmann::ordered_json::array();
  std::vector<Line> lines;
  for (const auto& [table, why] : table_notes()) {
    lines = measured_table(table, asked, lines);
    if (lines.empty()) continue;
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
  if (asked.json) std::puts(json.dump(2).c_str());
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
  headland::bench::run_tables(asked);
  return 0;
}
