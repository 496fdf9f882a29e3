// headland query and headland merge: what stores of runs hold.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/run_query.h"
#include "evaluate/run_store.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct QueryCommand {
  std::string store;
  std::string file;
  RunQuery query;
};

int query(const QueryCommand& command) {
  const fs::path file = command.file;
  if (!command.file.empty()) {
    require_replaceable(file);
    std::error_code ignored;
    if (fs::equivalent(file, command.store, ignored)) {
      throw InputError("-o", "", command.file, "another file than the store is needed");
    }
  }
  std::string csv;
  try {
    csv = query_runs(command.store, command.query, interrupted);
  } catch (const Cancelled&) {
    throw Interrupted{};
  }
  if (command.file.empty()) {
    fmt::print("{}", csv);
  } else {
    write_together(file.has_parent_path() ? file.parent_path() : ".",
                   {{file.filename().string(), csv}});
  }
  return kExitRan;
}

struct MergeCommand {
  std::string store;
  std::vector<std::string> others;
};

int merge(const MergeCommand& command) {
  for (const std::string& other : command.others) {
    std::error_code ignored;
    if (fs::equivalent(other, command.store, ignored)) {
      throw InputError("IN", "", other, "other stores than the one they are joined in are needed");
    }
    // None is made when one of the others is none.
    RunStore readable;
    open_run_store(other, DatabaseMode::kRead, readable);
  }
  RunStore store;
  open_run_store(command.store, DatabaseMode::kWrite, store);
  for (const std::string& other : command.others) {
    const MergeCounts counts = merge_run_store(store, other);
    fmt::print("{}: {} runs taken over, {} were there\n", terminal_text(other), counts.runs,
               counts.known);
    if (counts.different == 0) continue;
    fmt::print(stderr,
               "headland: {}: {} runs have other figures there than here, as on another machine; "
               "those here are kept\n",
               terminal_text(other), counts.different);
  }
  return kExitRan;
}

}  // namespace

void add_query_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("query", "Select runs from a store");
  auto given = std::make_shared<QueryCommand>();
  command->add_option("STORE", given->store, "Store that 'headland sweep' wrote")->required();
  command->add_option("--where", given->query.where,
                      "SQL condition: \"planner = 'boustrophedon' AND energy_wh < 300\"");
  command
      ->add_option("--columns", given->query.columns,
                   "Columns, with commas between them (docs/sweep.md); all: every one")
      ->delimiter(',');
  command->add_option("-o,--output", given->file, "CSV file (default: standard output)");
  command->footer(
      "Examples:\n  headland query out/runs.db -o out/runs.csv\n"
      "  headland query out/runs.db --where \"state <> 'driven'\" --columns "
      "planner,state,reason\n\n"
      "The store is only read. Exits with 0, 2 for bad input, 130 after Ctrl-C.");
  command->callback([given, &exit_code] { exit_code = query(*given); });
}

void add_merge_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("merge", "Join stores of runs");
  auto given = std::make_shared<MergeCommand>();
  command->add_option("OUT", given->store, "Store to join them in; made when it is not there")
      ->required();
  command->add_option("IN", given->others, "Stores, which stay as they are")->required();
  command->footer(
      "Example:\n  headland merge out/runs.db out/runs_1.db out/runs_2.db\n\n"
      "Exits with 0, 2 for bad input.");
  command->callback([given, &exit_code] { exit_code = merge(*given); });
}

}  // namespace headland
