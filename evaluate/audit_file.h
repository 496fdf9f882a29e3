// audit.json: what is wrong with a path, and where. Keys: docs/audit.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "evaluate/audit.h"
#include "evaluate/verdict.h"
#include "planner/path.h"

namespace headland {

// A place also has its longitude and latitude when the field is georeferenced.
nlohmann::ordered_json audit_json(const Audit& audit, const Field& field, const Vehicle& vehicle,
                                  const std::string& path_file, const std::string& version);

// "hull 0.42 m beyond the boundary", for people.
std::string audit_place_text(const AuditPlace& place);

// The worst places of every fault and the largest missed patches as a verdict's reasons, each
// marked on pictures: faults fail, missed ground alone is a warning that leaves the grade at PASS,
// as passes() says.
Verdict audit_verdict(const Audit& audit);

// The lines as a path, for pictures: worked lines are swaths, others turns.
Path drawn_path(const std::vector<PathLine>& lines);

}  // namespace headland
