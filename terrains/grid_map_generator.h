// Made-up grid maps: rectangular obstacles thrown at random.
#pragma once

#include <cstdint>
#include <string>

#include "terrains/grid_map.h"

namespace headland {

struct GridMapRecipe {
  int columns = 20;
  int rows = 20;
  double blocked_share = 0.105;  // of all cells, 0 to kMaxBlockedShare
  int obstacles = 3;
  std::uint64_t seed = 1;
};

inline constexpr double kMaxBlockedShare = 0.5;

// A map by the three numbers of Wang et al. 2025 (10.20944/preprints202504.0101.v1), Table 7: size,
// share, and number of discrete obstacles. Obstacles are rectangles, one row of which may be
// shorter so that the number of blocked cells is exact (columns * rows * blocked_share, rounded);
// no two touch, not even at a corner; all four corners of the map are free, and all free cells are
// connected. The maps in examples/maps were drawn by the same rules, not by this code. Throws
// InputError: sizes out of range, share out of range or too small or large for the number of
// obstacles, no such map found.
GridMap made_up_grid_map(const GridMapRecipe& recipe, const std::string& source);

}  // namespace headland
