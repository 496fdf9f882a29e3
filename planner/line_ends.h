// Moves the ends of a plan's work lines where the turn between them lacks room.
#pragma once

#include <vector>

#include "planner/connection.h"
#include "planner/free_space.h"
#include "planner/plan.h"
#include "planner/work_line.h"
#include "planner/worked_rows.h"

namespace headland {

// `lines` are those of the plan's passes. Between two lines that no turn with the clearance joins:
// - a closed round is begun elsewhere, or driven the other way round, at the cheapest place that a
//   turn reaches;
// - swaths are cut back. Planners let them reach into headland ground that no round covers, for
//   its coverage; they are shortened by as little as makes a turn fit and never further than the
//   headland's edge (kept_whole or headland_width_m of the plan). Beyond that the headland itself
//   is too narrow, and the lines stay as they are;
// - headland passes along some edges alone are cut back likewise, by up to 3 turning radii.
// Swath ends that no turn is sought at - at the ends of a plan that has kept_whole, and beside
// optional passes of one - are cut by as little as makes the hull fit, no further either.
// Rows are worked in `worked` (null: none is kept off) as they come, where `space` looks them up.
// Returns the lengths [m] cut off ends of passes. Throws Cancelled.
std::vector<double> make_room_for_turns(const Plan& plan, const Field& field,
                                        const FreeSpace& space, const ConnectionOptions& options,
                                        const Vehicle& vehicle, WorkedGround* worked,
                                        std::vector<WorkLine>& lines);

}  // namespace headland
