// Parts of a field in which the hull gets around easily; from one to another there are tight gaps
// at most.
#pragma once

#include <vector>

#include "planner/disc_cells.h"
#include "planner/free_space.h"

namespace headland {

inline constexpr int kNoPart = -1;  // it is not known in which part

struct RoomyParts {
  DiscCells cells;
  std::vector<int> part;    // of each cell, counted from 0; kNoPart: the hull does not fit there
  double middle_x_m = 0.0;  // of the chassis, ahead of B's origin

  // Of the cell that the chassis's middle is in.
  int at(const Pose& pose) const;
};

// A gap is tight where less than this [m] is left on both sides of a chassis that keeps its
// clearance: in the middle of such a gap it cannot turn.
inline constexpr double kTightGap_m = 0.25;

// Where the middle of a disc may be that has room for the chassis with the clearance and
// kTightGap_m around it, and joined to these parts what is as wide as the chassis alone, by
// nearness. Cells are 0.15 m wide on fields of up to 0.9 ha and as many on larger ones, 1.6 m on
// 100 ha, so that somewhat wider gaps may count as tight there.
RoomyParts roomy_parts(const FreeSpace& space, double clearance_m);

}  // namespace headland
