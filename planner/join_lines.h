// Joins work lines in their order into one path inside the field.
#pragma once

#include <vector>

#include "planner/drivable_path.h"
#include "planner/free_space.h"
#include "planner/work_line.h"

namespace headland {

// How a connection is named: opposite neighbours whose headings differ by this much are joined by
// a U-turn,
inline constexpr double kUTurnAngle_rad = 2.356;  // 135 degrees
// and what is longer than 2 pi R + kTransitWidths working widths is a transit, whatever its shape,
// as is what is straight.
inline constexpr double kTransitWidths = 4.0;

// Curvature estimated on passes may exceed the vehicle's by this fraction: it is a difference
// quotient on a smoothed line.
inline constexpr double kCurvatureTolerance = 0.02;

// Nodes that all routes of one path may take together: bounds the time of hopeless fields.
inline constexpr int kNodeBudget = 1000000;

// At least one line. `space` is the field's for this vehicle. The implement is down on the lines
// and up between them. Throws PlanInfeasible and Cancelled as make_path does.
Path join_lines(const Field& field, const Vehicle& vehicle, const FreeSpace& space,
                const std::vector<WorkLine>& lines, const PathOptions& options,
                const CancelAsked& cancelled, const TurnRemedies& remedies = {},
                int node_budget = kNodeBudget);

}  // namespace headland
