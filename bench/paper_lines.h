// Figures of papers' tables, ours beside the printed ones.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bench/paper_rows.h"

namespace headland::bench {

// One column of one row, ours and theirs.
struct Line {
  std::string table;
  std::string name;
  Quantity quantity = Quantity::kSteps;
  std::vector<double> values;  // by run
  double seconds = 0.0;        // of processor time a run
  double printed_mean = kNotPrinted;
  double printed_deviation = -1.0;  // less than 0: not printed
  bool more_is_better = false;
};

double mean(const std::vector<double>& values);

void print_line(const Line& line);
nlohmann::ordered_json json_of(const Line& line, std::string_view why);

// By planner and quantity the mean over the maps, of lines named "MAP PLANNER" of tables that have
// such a column: run by run, and of the printed ones.
std::vector<Line> averages(const std::vector<Line>& lines);

}  // namespace headland::bench
