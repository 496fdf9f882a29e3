// What a stage came to, for people.
#pragma once

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "apps/stages.h"

namespace headland {

inline double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

// A headline with what was evaluated, one aligned figure a line with its unit, where the energy
// went, what each kind of movement cost, and the verdict with its reasons.
std::string run_summary(const Job& job, const DriveResult& result);

// What `delta_soc` used (negative: won back, downhill) did to the state of charge: "-2.3 %",
// "+0.1 %", and "+0.0 %" for either sign of nothing.
std::string charge_change_text(double delta_soc);

std::string plan_summary(const Job& job, const PlanResult& result);
nlohmann::ordered_json plan_summary_json(const Job& job, const PlanResult& result);

// The energy that measured costs predict for the plan; empty where there are none.
std::string predicted_row(const PlanResult& result);

// "note: ..." a line.
std::string notes_text(const std::vector<std::string>& notes);

// Lines on swaths cut back for their turns, on passes left out and why, and on the place where a
// pass keeps less than the clearance asked for; empty where there is nothing to say.
std::string path_notes(const Path& path);

// Lines on the cells of a grid plan that cannot be worked; empty for other plans.
std::string grid_notes(const PlanResult& result);

// What became of another tool's track.
std::string track_summary(const TrackReport& report);
nlohmann::ordered_json track_json(const TrackReport& report);

}  // namespace headland
