// report.html of what was made of many runs: a comparison, a tuning.
#pragma once

#include <filesystem>
#include <string>

#include "apps/report_pictures.h"

namespace headland {

// The page of a comparison, from compare.json and the pictures beside it. Throws InputError for a
// file that is no comparison's.
ReportPage comparison_report(const std::filesystem::path& folder);

// The page of a tuning, from tune.json and the pictures beside it. Throws InputError for a file
// that is no tuning's.
ReportPage tuning_report(const std::filesystem::path& folder);

}  // namespace headland
