// Selecting runs from a store.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "planner/cancel.h"

namespace headland {

struct RunQuery {
  std::vector<std::string> columns;  // of stored_run_columns(); empty: the usual ones, "all": all
  std::string where;                 // a SQL condition on them; empty: every run
};

// CSV with a header, by sweep and in the sweep's order. What is not known is empty, texts with
// commas, quotes or line ends are quoted (RFC 4180). The condition can read the view `runs` and
// nothing else, and nothing is written. Throws InputError for an unknown column (with the nearest
// known one), a condition that SQLite does not understand or that does more than read, and as
// open_run_store; Cancelled.
std::string query_runs(const std::filesystem::path& store, const RunQuery& query,
                       const CancelAsked& cancelled = {});

const std::vector<std::string>& usual_run_columns();

}  // namespace headland
