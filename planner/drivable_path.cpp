#include "planner/drivable_path.h"

#include <fmt/format.h>

#include <utility>

#include "planner/join_lines.h"
#include "planner/line_ends.h"
#include "planner/outline.h"
#include "planner/polygon.h"
#include "planner/work_line.h"

namespace headland {

Path make_path(const Field& field, const Vehicle& vehicle, const Plan& plan,
               const PathOptions& options, const CancelAsked& cancelled) {
  if (plan.passes.empty()) throw PlanInfeasible("the plan has no passes");
  std::vector<WorkLine> lines;
  lines.reserve(plan.passes.size());
  for (const Pass& pass : plan.passes) {
    if (!(length_m(pass.points_W) > 0.0)) {
      throw PlanInfeasible(fmt::format("pass {} has no length", lines.size() + 1));
    }
    lines.push_back(work_line(pass, vehicle.implement.x_B_m));
    if (pass.kind == PassKind::kSwath) add_run_in(lines.back(), run_in_m(vehicle));
  }
  const ConnectionOptions connection{planning_turning_radius_m(vehicle), options.clearance_m,
                                     cancelled};
  const Field outline = simplified(field);
  const FreeSpace space = free_space(outline, hull_of(vehicle));
  std::vector<double> cuts =
      make_room_for_turns(plan, outline, space, connection, vehicle.implement.x_B_m, lines);
  Path path = join_lines(field, vehicle, space, lines, options, cancelled);
  path.cut_back_m = std::move(cuts);
  return path;
}

}  // namespace headland
