// What two papers print of grid planners, and how to ask ours for the same.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "planner/grid_cost.h"
#include "terrains/parameter.h"

namespace headland::bench {

// Of a plan: what a column of a table holds.
enum class Quantity {
  kSteps,
  kRepeatRate,   // percent; Crr of Wang et al.
  kConvergence,  // iteration of the last improvement
  kFitness,
  kRepeats_m2,
  kTurns,
  kUTurns
};

inline constexpr double kNotPrinted = std::numeric_limits<double>::quiet_NaN();

struct Printed {
  Quantity quantity = Quantity::kSteps;
  double mean = kNotPrinted;
  double deviation = -1.0;  // less than 0: not printed
};

struct PaperRow {
  std::string_view table;
  std::string name;
  std::string_view map;
  std::string_view planner;
  Parameters parameters;  // other than the planner's defaults
  GridObjective objective = GridObjective::kLength;
  std::vector<Printed> printed;
};

// Wang et al. 2025 (10.20944/preprints202504.0101.v1): 600 iterations, population 50. Tables 2 and
// 3, which try parts of a planner, are not among them.
std::vector<PaperRow> wang_rows();
// Wu et al. 2023 (10.20944/preprints202305.1306.v1).
std::vector<PaperRow> wu_rows();

// Why our figures differ from those of a table; the tables in the order in which they are printed.
struct TableNote {
  std::string_view table;
  std::string_view why;
};
std::vector<TableNote> table_notes();

}  // namespace headland::bench
