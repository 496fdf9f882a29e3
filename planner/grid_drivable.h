// Grid plans made drivable for one vehicle.
#pragma once

#include <string>
#include <vector>

#include "planner/drivable_path.h"
#include "planner/grid_plan.h"

namespace headland {

// What of a cell the implement does not come to, and why.
struct UnworkedCell {
  GridCell cell;
  double share = 0.0;  // of the cell
  std::string why;
};

// A straight piece of the plan that is not driven; other runs may work its cells all the same.
struct LeftOutRun {
  GridCell first;
  GridCell last;
  std::string why;
};

struct GridDrive {
  Plan plan;  // the passes as they are driven, added ones included
  Path path;
  std::vector<LeftOutRun> left_out;    // in the plan's order
  int added_passes = 0;                // for what the plan's own cannot reach
  std::vector<UnworkedCell> unworked;  // by row and column; cells with more than kUnworkedShare
  double unworked_ratio = 0.0;         // of all free cells
};

inline constexpr double kUnworkedShare = 0.01;

// `field` is the map's (field_of_grid, with ground to turn on) or the one it was made from. Every
// straight piece of the plan is driven forward along the middle of its cells with the implement
// down (work_runs), and joined to the next like the passes of any plan: by the cheapest of arcs,
// U, omega and three-point turns that the hull has room for, else by a route around what is in the
// way. These do not follow the plan's cells where there is a better way.
// - Runs are entered straight for a metre where there is room, which makes their begin exact.
// - The implement works behind the hull's front: facing what is blocked a run ends as far from it
//   as the hull needs, and begins as far from what is behind it.
// - Where no turn joins a run's end to the next run's begin, both are drawn back until one does, by
//   up to kDrawnBack_m; else the run is left out.
// - What is not worked then is worked by further passes along rows and columns, each put where it
//   makes the path least longer, as long as one brings kLeastGain of a cell or more.
// With overruns allowed nothing is drawn back, left out or added: runs work whole cells and what
// does not fit is recorded. Clearance as make_path: runs along walls keep what they do.
// Throws PlanInfeasible for a plan without cells, when nothing can be driven; Cancelled.
GridDrive make_grid_path(const Field& field, const Vehicle& vehicle, const GridMap& map,
                         const GridPlan& plan, const PathOptions& options,
                         const CancelAsked& cancelled = {});

// Ground around a map on which the vehicle turns from row to row: its hull swings no further out.
double grid_margin_m(const Vehicle& vehicle, const PathOptions& options);

inline constexpr double kDrawnBack_m = 8.0;
inline constexpr double kLeastGain = 0.1;

}  // namespace headland
