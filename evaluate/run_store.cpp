#include "evaluate/run_store.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
#include <thread>

#include "evaluate/digest.h"
#include "evaluate/program_version.h"
#include "evaluate/run_store_tables.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// "hdld", by which `file` and others know a store of headland's.
constexpr std::int64_t kApplicationId = 0x68646c64;

// Any change of the tables is another version, told by nothing but the tables themselves.
std::int64_t tables_version() {
  constexpr int kHexadecimal = 16;
  constexpr std::size_t kDigits = 7;  // 28 bits: SQLite's user_version has 31
  return std::stoll(digest_of(store_tables_sql()).substr(0, kDigits), nullptr, kHexadecimal);
}

void check_version(const RunStore& store) {
  const std::int64_t application = whole_number_of(store.database, "PRAGMA application_id");
  if (application != kApplicationId) {
    throw InputError(store.file.string(), "", "",
                     "a SQLite database, but not a store of runs of headland");
  }
  const std::int64_t version = whole_number_of(store.database, "PRAGMA user_version");
  if (version == tables_version()) return;
  throw InputError(store.file.string(), "", fmt::format("tables {:07x}", version),
                   fmt::format("a store of another version of headland; this one ({}) has tables "
                               "{:07x}: take a new store, its runs would be driven anew anyway",
                               program_version(), tables_version()));
}

bool is_empty(const RunStore& store) {
  return whole_number_of(store.database, "SELECT count(*) FROM sqlite_schema") == 0;
}

// The first to come makes the tables, all others wait.
void make_tables(const RunStore& store) {
  Transaction transaction(store.database);
  if (is_empty(store)) {
    execute(store.database, store_tables_sql());
    execute(store.database, fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                                        kApplicationId, tables_version()));
  }
  transaction.commit();
}

// SQLite does not wait of itself for a change of this mode.
void write_ahead(const RunStore& store) {
  constexpr auto kPause = std::chrono::milliseconds(20);
  const auto begun = std::chrono::steady_clock::now();
  while (true) {
    const int code =
        sqlite3_exec(store.database.get(), "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
    const bool wait =
        code != SQLITE_OK && (sqlite3_errcode(store.database.get()) & 0xff) == SQLITE_BUSY;
    if (!wait || std::chrono::steady_clock::now() - begun > std::chrono::seconds(kBusy_s)) break;
    std::this_thread::sleep_for(kPause);
  }
  execute(store.database, "PRAGMA journal_mode = WAL");
  // A program that is killed loses nothing by it, a machine without power its last few runs.
  execute(store.database, "PRAGMA synchronous = NORMAL");
}

void bind_or_null(const Statement& statement, int place, std::string_view text) {
  if (!text.empty()) bind_value(statement, place, text);
}

void insert_result(const RunStore& store, const StoredRun& stored) {
  const EvaluatedRun& run = stored.run;
  const Statement insert = prepare(store.database, insert_result_sql());
  int place = 0;
  bind_value(insert, ++place, stored.key);
  bind_value(insert, ++place, program_version());
  bind_value(insert, ++place, run_end_name(run.end));
  bind_or_null(insert, ++place, run.reason);
  const bool driven = run.end == RunEnd::kDriven;
  bind_or_null(insert, ++place, driven ? outcome_name(run.outcome) : "");
  bind_or_null(insert, ++place, run.outcome_detail);
  bind_or_null(insert, ++place, driven ? grade_name(run.verdict) : "");
  for (const double figure : run.figures) bind_value(insert, ++place, figure);
  step(insert);
}

}  // namespace

void open_run_store(const std::filesystem::path& file, DatabaseMode mode, RunStore& store) {
  store.file = file;
  store.database = open_database(file, mode);
  if (mode == DatabaseMode::kWrite && is_empty(store)) {
    write_ahead(store);
    make_tables(store);
  }
  check_version(store);
  if (mode == DatabaseMode::kWrite) write_ahead(store);
}

bool holds_run(RunStore& store, const std::string& key) {
  const std::scoped_lock lock(store.mutex);
  const Statement look = prepare(store.database, "SELECT 1 FROM results WHERE key = ?");
  bind_value(look, 1, key);
  return step(look);
}

void keep_run(RunStore& store, const StoredRun& run) {
  const std::scoped_lock lock(store.mutex);
  Transaction transaction(store.database);
  insert_result(store, run);
  const Statement scenario =
      prepare(store.database, "INSERT OR IGNORE INTO scenarios VALUES (?, ?)");
  bind_value(scenario, 1, run.key);
  bind_value(scenario, 2, run.scenario);
  step(scenario);
  transaction.commit();
}

void keep_cells(RunStore& store, const std::string& sweep, const std::vector<SweepCell>& cells) {
  const std::scoped_lock lock(store.mutex);
  Transaction transaction(store.database);
  const Statement remove = prepare(store.database, "DELETE FROM cells WHERE sweep = ?");
  bind_value(remove, 1, sweep);
  step(remove);
  const Statement insert =
      prepare(store.database, "INSERT INTO cells VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const SweepCell& cell : cells) {
    reset(insert);
    int place = 0;
    bind_value(insert, ++place, sweep);
    bind_value(insert, ++place, number++);
    for (const std::string* label :
         {&cell.field, &cell.terrain, &cell.soil, &cell.vehicle, &cell.planner}) {
      bind_value(insert, ++place, *label);
    }
    bind_value(insert, ++place, static_cast<std::int64_t>(cell.seed));
    bind_value(insert, ++place, cell.key);
    step(insert);
  }
  transaction.commit();
}

MergeCounts merge_run_store(RunStore& store, const std::filesystem::path& from) {
  {
    RunStore other;
    open_run_store(from, DatabaseMode::kRead, other);
  }
  const std::scoped_lock lock(store.mutex);
  const Statement attach = prepare(store.database, "ATTACH DATABASE ? AS other");
  bind_value(attach, 1, from.string());
  step(attach);
  MergeCounts counts;
  {
    Transaction transaction(store.database);
    counts.known = whole_number_of(store.database,
                                   "SELECT count(*) FROM other.results JOIN results USING (key)");
    counts.different = whole_number_of(store.database, count_different_sql());
    counts.runs =
        whole_number_of(store.database, "SELECT count(*) FROM other.results") - counts.known;
    execute(store.database,
            "INSERT OR IGNORE INTO results SELECT * FROM other.results;"
            "INSERT OR IGNORE INTO scenarios SELECT * FROM other.scenarios;"
            "DELETE FROM cells WHERE sweep IN (SELECT sweep FROM other.cells);"
            "INSERT INTO cells SELECT * FROM other.cells");
    transaction.commit();
  }
  execute(store.database, "DETACH DATABASE other");
  return counts;
}

}  // namespace headland
