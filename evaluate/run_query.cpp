#include "evaluate/run_query.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <iterator>

#include "evaluate/run_store.h"
#include "evaluate/run_store_tables.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kStepsBetweenAsking = 100000;  // of SQLite's machine: a millisecond or so

// What a condition may do: read the tables that the view is made of, and compute.
int allowed(void*, int action, const char* table, const char*, const char*, const char*) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_FUNCTION:
      return SQLITE_OK;
    case SQLITE_READ: {
      const std::string_view name = table;
      return name == "runs" || name == "cells" || name == "results" ? SQLITE_OK : SQLITE_DENY;
    }
    default:
      return SQLITE_DENY;
  }
}

int ask(void* cancelled) { return (*static_cast<const CancelAsked*>(cancelled))() ? 1 : 0; }

std::vector<std::string> columns_of(const RunQuery& query) {
  if (query.columns.empty()) return usual_run_columns();
  const std::vector<std::string>& known = stored_run_columns();
  if (query.columns == std::vector<std::string>{"all"}) return known;
  for (const std::string& column : query.columns) {
    if (std::find(known.begin(), known.end(), column) != known.end()) continue;
    throw InputError("--columns", "", column,
                     fmt::format("unknown column; did you mean '{}'? (all: every column; "
                                 "docs/sweep.md lists them)",
                                 nearest_name(column, known)));
  }
  return query.columns;
}

// A condition cannot be at fault where there is none, nor for what the disk holds.
[[noreturn]] void refuse(const RunStore& store, const RunQuery& query, int code) {
  const std::string reason = sqlite3_errmsg(store.database.get());
  const int primary = code & 0xff;
  if (query.where.empty() || primary == SQLITE_CORRUPT || primary == SQLITE_IOERR) {
    throw InputError(store.file.string(), "", "", reason);
  }
  throw InputError("--where", "", query.where,
                   code == SQLITE_AUTH ? "a condition on columns of runs is needed; it may read "
                                         "them and nothing else"
                                       : reason);
}

// One SELECT and nothing after it, whatever the condition's text holds.
Statement prepared(const RunStore& store, const RunQuery& query,
                   const std::vector<std::string>& columns) {
  // On lines of its own a comment in the condition ends with it.
  const std::string sql =
      fmt::format("SELECT {} FROM runs {} ORDER BY sweep, place", fmt::join(columns, ", "),
                  query.where.empty() ? "" : fmt::format("WHERE (\n{}\n)", query.where));
  sqlite3_stmt* statement = nullptr;
  const char* rest = nullptr;
  const int code = sqlite3_prepare_v2(store.database.get(), sql.c_str(),
                                      static_cast<int>(sql.size()), &statement, &rest);
  Statement owned(statement);
  if (code != SQLITE_OK) refuse(store, query, code);
  if (rest != nullptr && *rest != '\0') {
    throw InputError("--where", "", query.where, "one condition is needed, not several statements");
  }
  return owned;
}

void append_text(std::string& csv, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    csv += text;
    return;
  }
  csv += '"';
  for (const char letter : text) csv.append(letter == '"' ? 2 : 1, letter);
  csv += '"';
}

void append_value(std::string& csv, const Statement& row, int column) {
  switch (sqlite3_column_type(row.get(), column)) {
    case SQLITE_NULL:
      return;
    case SQLITE_FLOAT:
      fmt::format_to(std::back_inserter(csv), "{}", number_at(row, column));
      return;
    default:
      append_text(csv, text_at(row, column));
  }
}

}  // namespace

const std::vector<std::string>& usual_run_columns() {
  static const std::vector<std::string> columns = {
      "sweep",         "field",     "terrain",    "soil",           "vehicle",
      "planner",       "seed",      "state",      "outcome",        "verdict",
      "energy_wh",     "time_s",    "distance_m", "coverage_ratio", "overlap_ratio",
      "path_length_m", "delta_soc", "turns",      "u_turns",        "reason"};
  return columns;
}

std::string query_runs(const std::filesystem::path& file, const RunQuery& query,
                       const CancelAsked& cancelled) {
  RunStore store;
  open_run_store(file, DatabaseMode::kRead, store);
  const std::vector<std::string> columns = columns_of(query);
  sqlite3_set_authorizer(store.database.get(), allowed, nullptr);
  CancelAsked asked = cancelled;
  if (asked) sqlite3_progress_handler(store.database.get(), kStepsBetweenAsking, ask, &asked);
  const Statement row = prepared(store, query, columns);
  std::string csv = fmt::format("{}\n", fmt::join(columns, ","));
  while (true) {
    stop_if(cancelled);
    const int code = sqlite3_step(row.get());
    if (code == SQLITE_DONE) return csv;
    if ((code & 0xff) == SQLITE_INTERRUPT) throw Cancelled{};
    if (code != SQLITE_ROW) refuse(store, query, code);
    for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
      if (i > 0) csv += ',';
      append_value(csv, row, i);
    }
    csv += '\n';
  }
}

}  // namespace headland
