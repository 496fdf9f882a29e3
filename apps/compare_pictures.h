// The pictures of a comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/atomic_file.h"
#include "evaluate/comparison.h"

namespace headland {

inline constexpr char kComparisonFile[] = "compare.json";

// For each map the convergence chart (convergence_MAP.svg and .png) and the planners' best plans
// side by side (plans_MAP.png); for each map and planner its best plan (plan_MAP_LABEL.png). Throws
// InputError when gnuplot or the fonts are missing.
std::vector<FileText> comparison_pictures(const Comparison& comparison,
                                          const std::vector<ComparedRun>& runs);

// The pictures that an earlier comparison left beside its compare.json, which names them; none when
// there is no such file. It may have had other maps and planners.
std::vector<std::filesystem::path> earlier_pictures(const std::filesystem::path& compare_json);

// Name of the picture with all best plans on a map.
std::string plans_picture_name(const std::string& map);

}  // namespace headland
