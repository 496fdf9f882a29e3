// Orders in which neighbouring swaths are driven: one after the other, or with some left between.
#pragma once

#include <cstddef>
#include <vector>

namespace headland {

enum class SwathPattern {
  kNext,    // 0 1 2 3 ...
  kSkip,    // `skip` swaths or more are left between any two that follow each other
  kSpiral,  // from both sides to the middle: 0 n-1 1 n-2 ...
};

// 0 .. count - 1 in driving order. Skipping works in lands of 2 skip + 3 swaths or little more,
// whose halves are driven in turn (0 3 1 4 2 with one left between), so that turns are no wider
// than need be; fewer than 2 skip + 3 swaths leave as many between as they can, half of them.
std::vector<std::size_t> swath_sequence(std::size_t count, SwathPattern pattern, std::size_t skip);

// The fewest swaths to leave between two so that a plain U-turn joins them: it needs two turning
// radii.
std::size_t skip_for_u_turns(double spacing_m, double turning_radius_m);

}  // namespace headland
