// A store of runs: a SQLite file in which every run stands under its key, and sweeps tell which run
// is theirs where. Any number of programs may use one at the same time; a program that is killed
// loses the runs in flight and nothing else. Tables and columns: docs/sweep.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/database.h"
#include "evaluate/evaluated_run.h"

namespace headland {

struct RunStore {
  std::filesystem::path file;
  Database database;
  std::mutex mutex;  // of the program's threads
};

// Makes it when it is not there. Throws InputError as open_database, for a database that is none of
// headland's and for a store whose tables are those of another version.
void open_run_store(const std::filesystem::path& file, DatabaseMode mode, RunStore& store);

struct StoredRun {
  std::string key;       // run_key
  std::string scenario;  // scenario_yaml
  EvaluatedRun run;
};

bool holds_run(RunStore& store, const std::string& key);

// Of two runs with one key the first stays. On disk when it returns, unless the machine loses
// power.
void keep_run(RunStore& store, const StoredRun& run);

// A place in a sweep's matrix, by labels.
struct SweepCell {
  std::string field;
  std::string terrain;
  std::string soil;
  std::string vehicle;
  std::string planner;
  std::uint64_t seed = 1;
  std::string key;
};

// The cells of this sweep, in their order; replaces what the store says of it.
void keep_cells(RunStore& store, const std::string& sweep, const std::vector<SweepCell>& cells);

struct MergeCounts {
  std::int64_t runs = 0;       // taken over
  std::int64_t known = 0;      // were there already
  std::int64_t different = 0;  // of those, with other figures than here (seconds apart)
};

// Takes runs and sweeps of `from` over. A sweep that both have becomes that of `from`.
// Throws InputError as open_run_store.
MergeCounts merge_run_store(RunStore& store, const std::filesystem::path& from);

}  // namespace headland
