// Where a closed round is begun, and which way round it is driven.
#pragma once

#include <cstddef>
#include <vector>

#include "planner/polygon.h"

namespace headland {

struct RoundBegin {
  std::size_t point = 0;
  bool reversed = false;
};

// The choices looked at are about this far apart along the round [m]; finer changes no turn.
inline constexpr double kBeginSpacing_m = 1.0;

// Both ways round at each place, those first that are nearest to `from_W`.
std::vector<RoundBegin> round_begins(const Polyline& round, const Eigen::Vector2d& from_W);

// The round (first point == last) from its begin to its begin.
Polyline begun_at(const Polyline& round, const RoundBegin& begin);

}  // namespace headland
