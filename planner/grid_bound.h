// How short a path on a grid map can be at best.
#pragma once

#include "planner/cancel.h"
#include "planner/grid_plan.h"

namespace headland {

// No path that visits every cell and keeps start and end is shorter [steps]. Every cell is entered
// and left, the path's ends only one of the two, and no step serves two cells of which none is
// beside another: the heaviest such set of cells, weighing each by how often it is entered or left,
// is a bound. It is found as a least vertex cover (Koenig's theorem; Hopcroft and Karp, 'An n^5/2
// algorithm for maximum matchings in bipartite graphs', 1973): the two colours of a chessboard are
// the graph's sides. What one colour has too many is thus counted, obstacle by obstacle, and what
// dead ends cost. Rounded up to the parity that given ends ask for. Throws Cancelled.
int least_steps(const GridProblem& problem, const CancelAsked& cancelled = {});

}  // namespace headland
