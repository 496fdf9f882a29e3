// report.html of a results folder.
#pragma once

#include <filesystem>
#include <string>

#include "apps/stages.h"

namespace headland {

// The page of the run in the job's folder, from its files alone: what is missing or damaged is left
// out and told on the page. Throws InputError when there is no run at all.
std::string run_report(const Job& job);

// Writes it to report.html there.
void report_stage(const Job& job);

// The page of a comparison, from compare.json and the pictures beside it. Throws InputError for a
// file that is no comparison's.
std::string comparison_report(const std::filesystem::path& folder);

}  // namespace headland
