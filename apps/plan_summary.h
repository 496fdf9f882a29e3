// What a plan, or another tool's track made a path, came to, for people and programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/stages.h"
#include "evaluate/coverage.h"

namespace headland {

// What the path works of the field. Throws InputError as planned_coverage.
CoverageFigures coverage_of(const Job& job, const PlanResult& result);

std::string plan_summary(const Job& job, const PlanResult& result, const CoverageFigures& coverage);
nlohmann::ordered_json plan_summary_json(const Job& job, const PlanResult& result,
                                         const CoverageFigures& coverage);

// The energy that measured costs predict for the plan; empty where there are none.
std::string predicted_row(const PlanResult& result);

// Lines on swaths cut back for their turns, on turns that are not continuous though asked for, and
// on the place where a pass keeps less than the clearance asked for; empty where there is nothing
// to say.
std::string path_notes(const Path& path);

// How far wheels run over rows that are worked, implement up; empty where they do not, unless
// `options` ask them to keep off.
std::string over_worked_row(const Stage& stage, const Path& path, const PathOptions& options);

// Lines on the cells of a grid plan that cannot be worked; empty for other plans.
std::string grid_notes(const PlanResult& result);

// What became of another tool's track.
std::string track_summary(const TrackReport& report);
nlohmann::ordered_json track_json(const TrackReport& report);

}  // namespace headland
