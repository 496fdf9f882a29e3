// The chart of a cost table: what a metre costs by slope, and what turns cost by cause.
#pragma once

#include <string>

#include "evaluate/cost_table.h"

namespace headland {

// A script for chart_of: above, energy per metre over the slope along the drive, a line for every
// speed with its 95 % interval, and the formula of paper 000; below, the energy of stop and start,
// implement cycle and turns, stacked by cause.
std::string cost_chart_script(const CostTable& table);

inline constexpr int kCostChartWidth_px = 1200;
inline constexpr int kCostChartHeight_px = 1100;

}  // namespace headland
