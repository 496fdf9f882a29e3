// The numbers of a run that are kept of it as data: plan, path and drive.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evaluate/metrics.h"
#include "evaluate/plan_scenario.h"

namespace headland {

// Keys of all figures in their order, with their units: docs/sweep.md.
const std::vector<std::string>& run_figure_keys();

// The place of a key in them, which is one.
std::size_t run_figure_place(std::string_view key);

// By the keys' order; NaN where a figure is not known.
using RunFigures = std::vector<double>;

RunFigures no_run_figures();
void set_plan_figures(const PlanResult& planned, RunFigures& figures);
void set_drive_figures(const Metrics& metrics, const RunRecord& run, RunFigures& figures);

// Taken by the clock: they differ from drive to drive.
inline constexpr std::string_view kPlanSeconds = "plan_s";  // with reading field and terrain
inline constexpr std::string_view kDriveSeconds = "drive_s";

}  // namespace headland
