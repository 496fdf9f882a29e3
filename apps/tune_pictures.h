// Charts of a tuning and pictures of the plans that differ.
#pragma once

#include <vector>

#include "evaluate/atomic_file.h"
#include "evaluate/tuning_run.h"

namespace headland {

inline constexpr char kMostSavedPicture[] = "plans_most_saved.png";
inline constexpr char kLeastSavedPicture[] = "plans_least_saved.png";

// Plans the pictured fields anew. Throws InputError without gnuplot or fonts.
std::vector<FileText> tune_pictures(const Tuning& tuning, const TuneResult& result);

}  // namespace headland
