// metrics.json: what a run came to, and what else of its record is needed to read it back.
// Keys: docs/results.md.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluate/metrics.h"
#include "evaluate/scenario.h"
#include "evaluate/verdict.h"

namespace headland {

// Everything a report on a run speaks of. Nothing is owned.
struct RunReport {
  const Scenario& scenario;
  const Field& field;
  const Vehicle& vehicle;
  const Path& path;
  const RunRecord& run;
  const Metrics& metrics;
  const Verdict& verdict;
  const std::vector<std::string>& notes;  // what the user should know besides
};

// A place also has its longitude and latitude when the field is georeferenced. Numbers that are
// not finite (of a run that diverged) become null.
nlohmann::ordered_json metrics_json(const RunReport& report, const std::string& version);

// The record's totals and peaks back from the file; samples, footprints and segments are in the
// tables. Throws InputError naming the key.
RunRecord read_run_totals(const std::filesystem::path& file);

}  // namespace headland
