// The straight pieces of a grid plan along which the implement works.
#pragma once

#include <array>
#include <vector>

#include "planner/grid_graph.h"
#include "planner/plan.h"
#include "terrains/grid_map.h"

namespace headland {

// Cells in a row, worked in one go. The implement goes down begin_m after the edge by which `first`
// is entered and up end_m after it.
struct GridRun {
  GridCell first;
  int direction = 0;  // see kStep
  int cells = 1;
  double begin_m = 0.0;
  double end_m = 0.0;
  double run_in_m = 0.0;  // straight on with the implement up before begin_m
};

// The steps of `cells` (a GridPlan's) as runs in their order. Each cell is worked once, by the
// longest straight piece that goes through it (the first one of equals): pieces whose cells are all
// worked by others - the steps from row to row, ways over worked ground - are left to the turns
// between runs, and a run is interrupted where it crosses what another works. A cell without a
// step to it or from it, of plans with jumps, is worked in direction 2. Runs work whole cells.
std::vector<GridRun> work_runs(const GridMap& map, const std::vector<GridCell>& cells);

// The k-th cell of a run.
inline GridCell cell_of(const GridRun& run, int k) {
  const GridCell& step = kStep[static_cast<std::size_t>(run.direction)];
  return {run.first.column + k * step.column, run.first.row + k * step.row};
}

// The way of the implement's middle.
Pass pass_of(const GridMap& map, const GridRun& run);

// What is worked of a cell: along its rows (x) over its whole height and along its columns (y) over
// its whole width, as parts of its side from 0 to 1.
struct WorkedSpan {
  double begin = 0.0;
  double end = 0.0;
};
struct WorkedCell {
  std::array<std::vector<WorkedSpan>, 2> along;  // x, y
};

// Adds what the run works to the cells of the map.
void add_worked(const GridMap& map, const GridRun& run, std::vector<WorkedCell>& worked);

// The share of a cell that is not worked.
double unworked_share(const WorkedCell& cell);

// The stretch of the k-th cell of a run, from 0 to 1 in its direction, that is not worked by it or
// any other run in its direction; none (begin >= end) where runs across have worked the cell.
WorkedSpan missing_along(const WorkedCell& cell, int direction);

}  // namespace headland
