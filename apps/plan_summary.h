// What a plan, or another tool's track made a path, came to, for people and programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/stages.h"

namespace headland {

std::string plan_summary(const Job& job, const PlanResult& result);
nlohmann::ordered_json plan_summary_json(const Job& job, const PlanResult& result);

// The energy that measured costs predict for the plan; empty where there are none.
std::string predicted_row(const PlanResult& result);

// Lines on swaths cut back for their turns, on turns that are not continuous though asked for, and
// on the place where a pass keeps less than the clearance asked for; empty where there is nothing
// to say.
std::string path_notes(const Path& path);

// How far wheels run over rows that are worked, implement up; empty where they do not.
std::string over_worked_row(const Stage& stage, const Path& path);

// Lines on the cells of a grid plan that cannot be worked; empty for other plans.
std::string grid_notes(const PlanResult& result);

// What became of another tool's track.
std::string track_summary(const TrackReport& report);
nlohmann::ordered_json track_json(const TrackReport& report);

}  // namespace headland
