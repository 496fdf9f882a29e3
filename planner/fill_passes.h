// Straight passes over ground that rounds and swaths leave: corners, slivers along edges, nooks.
#pragma once

#include <vector>

#include "planner/free_space.h"
#include "planner/plan.h"
#include "planner/worked_ground.h"

namespace headland {

struct FillOptions {
  double working_width_m = 0.0;
  double turning_radius_m = 0.0;
  double clearance_m = 0.0;
  double overhang_m = 0.0;      // by which the implement may work beyond boundary and holes
  double least_patch_m2 = 1.0;  // smaller patches, and passes that gain less, are not worth it
  std::vector<double> directions_rad{};  // tried besides those of edges near a patch
  CancelAsked cancelled{};
};

// Works patch by patch, the largest first, until no pass gains least_patch_m2: of straight lines
// along and across nearby edges, along the patch and in the directions given, flush with either
// side of the patch or in its middle, the one that works most for its length and a turn; where none
// of these gains enough, of lines all across the patch in every direction. Every pose
// of a pass keeps the clearance, ends included: it begins backed into its corner or stops with the
// front before the boundary. The passes are `optional`, in the order found; `ground` is worked by
// them. Throws Cancelled.
std::vector<Pass> fill_passes(const FreeSpace& space, const FillOptions& options,
                              WorkedGround& ground);

}  // namespace headland
