#include "planner/edge_filling.h"

#include <utility>

#include "planner/fill_passes.h"
#include "planner/free_space.h"
#include "planner/headland_order.h"
#include "planner/hull.h"
#include "planner/pass_order.h"
#include "planner/worked_ground.h"

namespace headland {
void append_passes_beside(const PlanRequest& request, const Headland& headland,
                          std::span<const SwathGrid> grids, std::vector<Pass>& passes) {
  if (headland.beyond.parts.empty() || request.forward_only) return;
  const double width_m = request.working_width_m;
  WorkedGround ground = ground_to_work(request.field);
  leave_to_work(ground,
                intersection(headland.inside, zone_beside(headland.edged, {0, 0}, width_m)));
  for (const HeadlandRing& ring : headland.rings) work_along(ground, ring.line_W, width_m);
  FillOptions options;
  options.working_width_m = width_m;
  options.turning_radius_m = request.turning_radius_m;
  options.clearance_m = request.clearance_m;
  options.least_patch_m2 = kLeastBesideEdge * width_m * width_m;
  options.cancelled = request.cancelled;
  for (const SwathGrid& grid : grids) {
    options.directions_rad.push_back(grid.direction_rad);
    work_swaths(ground, grid, width_m);
  }
  const FreeSpace space = free_space(request.field, hull_of(request));
  for (Pass& pass :
       ordered(fill_passes(space, options, ground), end_of(passes, request.field.entry_W), space,
               request.turning_radius_m, request.cancelled)) {
    passes.push_back(std::move(pass));
  }
}

}  // namespace headland
