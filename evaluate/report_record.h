// What a results folder still holds of a run, however damaged.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "planner/path.h"
#include "sim/run_record.h"
#include "terrains/field.h"

namespace headland {

struct RecordedRun {
  Path path;                       // without segments when it cannot be read
  RunRecord run;                   // the rows before a faulty one; totals of metrics.json
  nlohmann::ordered_json metrics;  // metrics.json; null when it cannot be read
  // What is missing and why, one sentence each; empty: the record is whole, as read_run has it.
  std::vector<std::string> missing;
};

// Throws InputError when the folder holds neither metrics.json nor run.csv: there is no run in it.
RecordedRun read_recorded_run(const std::filesystem::path& folder, const Field& field);

}  // namespace headland
