// What a comparison leaves for programs: every run, the table, the tests. Keys and columns:
// docs/compare.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/comparison_ranks.h"

namespace headland {

// One line a run, in the order of the runs.
std::string comparison_runs_csv(const Comparison& comparison, const std::vector<ComparedRun>& runs);

// One line for each map and planner: how the runs ended, and mean, standard deviation, best and
// worst of every figure.
std::string comparison_table_csv(const Comparison& comparison,
                                 const std::vector<ComparedRun>& runs);

// All of it, convergence and the best paths too.
nlohmann::ordered_json comparison_json(const Comparison& comparison,
                                       const std::vector<ComparedRun>& runs,
                                       const ComparisonRanks& ranks, const std::string& version);

}  // namespace headland
