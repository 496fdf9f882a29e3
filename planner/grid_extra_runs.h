// Further runs for what those of a grid plan cannot reach.
#pragma once

#include <vector>

#include "planner/grid_joining.h"

namespace headland {

// Inserts runs along rows and columns through cells that are not wholly worked, one at a time: the
// one that works most for its length and turns first, at the place in the order that makes the path
// least longer by the length of turns, and where both its turns fit; until none works kLeastGain of
// a cell. Adds what they work. Throws Cancelled.
struct AddedRuns {
  int added = 0;
  std::vector<GridRun> unreached;  // those that have room and no turn reaches
};
AddedRuns add_runs(GridJoining& joining, std::vector<GridRun>& runs,
                   std::vector<WorkedCell>& worked);

}  // namespace headland
