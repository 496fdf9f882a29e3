#include "evaluate/run_store_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "evaluate/run_figures.h"

namespace headland {
namespace {

const std::vector<std::string> kCellColumns = {"sweep",   "field",   "terrain", "soil",
                                               "vehicle", "planner", "seed",    "key"};
const std::vector<std::string> kTextColumns = {"program", "state",          "reason",
                                               "outcome", "outcome_detail", "verdict"};

}  // namespace

std::string store_tables_sql() {
  std::string results;
  for (const std::string& column : kTextColumns) results += ", " + column + " TEXT";
  for (const std::string& key : run_figure_keys()) results += ", " + key + " REAL";
  // State is the only column that is known of a run that is not there.
  std::string view;
  for (const std::string& column : kCellColumns) view += "cells." + column + ", ";
  for (const std::string& column : kTextColumns) {
    view += column == "state" ? "coalesce(state, 'not run') AS state, " : column + ", ";
  }
  return fmt::format(
      "CREATE TABLE results (key TEXT PRIMARY KEY{});"
      "CREATE TABLE scenarios (key TEXT PRIMARY KEY, scenario TEXT);"
      "CREATE TABLE cells (sweep TEXT, place INTEGER, field TEXT, terrain TEXT, soil TEXT, "
      "vehicle TEXT, planner TEXT, seed INTEGER, key TEXT, PRIMARY KEY (sweep, place)) "
      "WITHOUT ROWID;"
      "CREATE VIEW runs AS SELECT {}place, {} FROM cells LEFT JOIN results USING (key);",
      results, view, fmt::join(run_figure_keys(), ", "));
}

std::string insert_result_sql() {
  std::string marks = "?";
  for (std::size_t i = 0; i < kTextColumns.size() + run_figure_keys().size(); ++i) marks += ", ?";
  return fmt::format("INSERT OR IGNORE INTO results VALUES ({})", marks);
}

std::string count_different_sql() {
  std::string different = "here.state IS NOT there.state";
  const auto compare = [&](const std::string& column) {
    different += fmt::format(" OR here.{0} IS NOT there.{0}", column);
  };
  for (const char* column : {"outcome", "verdict"}) compare(column);
  for (const std::string& key : run_figure_keys()) {
    if (key != kPlanSeconds && key != kDriveSeconds) compare(key);
  }
  return fmt::format(
      "SELECT count(*) FROM main.results AS here JOIN other.results AS there USING (key) WHERE {}",
      different);
}

const std::vector<std::string>& stored_run_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = kCellColumns;
    all.insert(all.end(), kTextColumns.begin(), kTextColumns.end());
    all.insert(all.end(), run_figure_keys().begin(), run_figure_keys().end());
    return all;
  }();
  return columns;
}

}  // namespace headland
