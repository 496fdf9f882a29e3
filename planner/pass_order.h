// The order of passes that stand alone: corners, nooks, slivers.
#pragma once

#include <optional>
#include <vector>

#include "planner/free_space.h"
#include "planner/plan.h"

namespace headland {

// The passes in an order with little driving between them, each in its own direction: the nearest
// next, then single ones and stretches of up to three moved while that saves something (Or-opt).
// Two passes are as far apart as the way inside the field (way_lengths.h) or the shortest curve of
// Reeds and Shepp, whichever is longer. `from` is where the vehicle comes from. Throws Cancelled.
std::vector<Pass> ordered(std::vector<Pass> passes, const std::optional<Eigen::Vector2d>& from_W,
                          const FreeSpace& space, double turning_radius_m,
                          const CancelAsked& cancelled = {});

}  // namespace headland
