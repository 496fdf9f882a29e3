// Everything that the page of a run shows but for its pictures, as one JSON object. The page's side
// of it: web/src/data.js.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "evaluate/coverage.h"
#include "evaluate/report_record.h"
#include "evaluate/scenario.h"

namespace headland {

// Nothing is owned.
struct RunPageSource {
  const Scenario& scenario;
  const Stage& stage;
  const RecordedRun& recorded;
  const CoverageRaster& coverage;    // of the footprints there are
  std::span<const double> wh_per_m;  // one a sample, or none
};

// "kind": "run", and: version, missing, scenario (name, seed, file, text), metrics (metrics.json as
// it is), judged, areas_m2, field, vehicle, path (planned lines), series, footprints, movements,
// tracking, missed_patches, assumptions. Places are p_W in metres. What is missing is null or
// empty.
nlohmann::ordered_json run_page_json(const RunPageSource& source, const std::string& version);

}  // namespace headland
