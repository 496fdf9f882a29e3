// Lines that summaries of plans and of runs have in common.
#pragma once

#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "apps/stages.h"

namespace headland {

inline double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

std::string hectares(double area_m2);  // "1.234 ha"

// "1 pass", "2 passes".
std::string counted(std::size_t count, std::string_view one, std::string_view several);

// An aligned figure: "  label   value   note".
std::string summary_row(std::string_view label, const std::string& value,
                        const std::string& note = "");

// What is evaluated: vehicle, working width, field, soil, terrain, seed.
std::string headline(const Job& job);

// "note: ..." a line.
std::string notes_text(const std::vector<std::string>& notes);

}  // namespace headland
