// The output folder: which file holds what, and a whole run read back. docs/results.md.
#pragma once

#include <filesystem>
#include <string_view>

#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {

inline constexpr char kScenarioFile[] = "scenario.yaml";   // as resolved
inline constexpr char kPlanFile[] = "plan.geojson";        // evaluate/plan_file.h
inline constexpr char kGridPlanFile[] = "grid_plan.json";  // evaluate/grid_plan_file.h
inline constexpr char kJobFile[] = "job.json";             // evaluate/job_plan.h
inline constexpr char kPathFile[] = "path.geojson";        // evaluate/plan_file.h
inline constexpr char kRunFile[] = "run.csv";              // evaluate/run_tables.h
inline constexpr char kFootprintFile[] = "footprint.csv";  // evaluate/run_tables.h
inline constexpr char kSegmentsFile[] = "segments.csv";    // evaluate/run_tables.h
inline constexpr char kMetricsFile[] = "metrics.json";     // evaluate/metrics_file.h
inline constexpr char kFieldPicture[] = "field.png";       // render/pictures.h
inline constexpr char kViewPicture[] = "view.png";         // render/pictures.h
inline constexpr char kEnergyPicture[] = "energy.png";     // render/pictures.h
inline constexpr char kReportFile[] = "report.html";       // render/report_page.h

// Removes the files of stages after the one that has just been done again, so that a folder never
// mixes two runs. `first` and what follows it in the list above go.
void remove_results_from(const std::filesystem::path& folder, std::string_view first);

// Throws InputError when a run's results could not be written to `folder` (which need not exist
// yet): as check_output_folder does, and for a folder under the name of one of the files.
void check_results_folder(const std::filesystem::path& folder);

// Throws InputError when `file` is one of the files in `folder` that a run replaces.
void require_no_result(const std::filesystem::path& folder, const std::filesystem::path& file);

// A run back from its tables and metrics.json, to the decimals written. Throws InputError naming
// file, line and column: a file that is missing or cannot be read, a table that is none, time or
// travel running backwards, a place far from the path, a run that belongs to another path.
RunRecord read_run(const std::filesystem::path& folder, const Path& path);

}  // namespace headland
