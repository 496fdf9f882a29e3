// The tables of a store of runs, as SQL.
#pragma once

#include <string>
#include <vector>

namespace headland {

// results (one row a run), scenarios (the same keys), cells (the runs of sweeps), and the view
// `runs` of what the cells' runs came to, which is what queries see.
std::string store_tables_sql();

// INSERT OR IGNORE of a row of results, with a question mark for every column.
std::string insert_result_sql();

// How many rows of the attached database `other` differ from the one of the same key here, apart
// from seconds.
std::string count_different_sql();

// Columns of the view `runs`, in their order.
const std::vector<std::string>& stored_run_columns();

}  // namespace headland
