// Swaths grouped into cells that are driven up and down, and the order of the cells.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "planner/swaths.h"

namespace headland {

// Swaths (indices into SwathGrid::swaths) on consecutive lines, each with one neighbour on the
// next line and that one with no other: between two lines where the ground splits or joins, cells
// end (boustrophedon decomposition: Choset, 'Coverage of known spaces', 2000, on lines instead of
// a continuous sweep).
using SwathCell = std::vector<std::size_t>;

std::vector<SwathCell> cells_of(const SwathGrid& grid);

// A cell driven up and down from one of its four corners: its swaths in their order or in that from
// the last to the first, which may be any (swath_pattern.h).
struct CellVisit {
  std::size_t cell = 0;
  bool from_last_line = false;
  bool from_far_end = false;  // begins at the first swath's to_m
};

// Every cell once, the transits between them (straight distances) short in sum: exact by dynamic
// programming for up to kExactCells cells, beyond that nearest neighbour improved by 2-opt and
// or-opt until neither helps. `start_W` is where the vehicle comes from; without it the first
// entry is free. Throws Cancelled.
inline constexpr std::size_t kExactCells = 9;
std::vector<CellVisit> order_cells(const SwathGrid& grid, const std::vector<SwathCell>& cells,
                                   const std::optional<Eigen::Vector2d>& start_W,
                                   const CancelAsked& cancelled = {});

// The swaths of a visit in driving order, alternating in direction.
std::vector<Pass> passes_of(const SwathGrid& grid, const SwathCell& cell, const CellVisit& visit);

}  // namespace headland
