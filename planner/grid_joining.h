// Fits runs of a grid plan between what is in the way, and joins them.
#pragma once

#include <optional>

#include "planner/connection.h"
#include "planner/grid_runs.h"
#include "planner/work_line.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct GridJoining {
  const GridMap& map;
  const Vehicle& vehicle;
  const FreeSpace& space;
  ConnectionOptions connection;
  // Nodes of hybrid A* left for ways that are found, and for looking where there is none.
  int found_nodes = 500000;
  int lost_nodes = 200000;
};

// The longest part of a run, at least kPathSpacing_m, that the hull has room for, with the
// clearance ahead and behind; none when there is none. With a run-in: what a trailed implement
// needs, else a straight metre, and where walls are nearer than the clearance from before them, as
// far as there is room.
std::optional<GridRun> with_room(const GridJoining& joining, const GridRun& run);

// The way of B's origin, with a run-in where the vehicle needs one.
WorkLine line_of(const GridJoining& joining, const GridRun& run);

// Where B's origin begins and ends, to the bit as on the line: a search that just finds a way may
// not from a place a rounding away.
Pose begin_of(const GridJoining& joining, const GridRun& run);
Pose end_of(const GridJoining& joining, const GridRun& run);

// Whether something fits from the end of one run to the begin of the next. Throws Cancelled.
bool joined(GridJoining& joining, const GridRun& from, const GridRun& to);

// Ends the one earlier and begins the other later, by as little as lets a turn join them; false
// when up to kDrawnBack_m does not. Throws Cancelled.
bool draw_back(const GridJoining& joining, GridRun& from, GridRun& to);

}  // namespace headland
