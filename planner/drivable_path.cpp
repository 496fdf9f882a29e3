#include "planner/drivable_path.h"

#include <utility>

#include "planner/join_lines.h"
#include "planner/line_ends.h"
#include "planner/work_line.h"

namespace headland {

Path make_path(const Field& field, const Vehicle& vehicle, const Plan& plan,
               const PathOptions& options) {
  if (plan.passes.empty()) throw PlanInfeasible("the plan has no passes");
  std::vector<WorkLine> lines;
  lines.reserve(plan.passes.size());
  for (const Pass& pass : plan.passes) {
    lines.push_back(work_line(pass, vehicle.implement.x_B_m));
  }
  const ConnectionOptions connection{planning_turning_radius_m(vehicle), options.clearance_m};
  const FreeSpace space = free_space(field, hull_of(vehicle));
  std::vector<double> cuts =
      make_room_for_turns(plan, field, space, connection, vehicle.implement.x_B_m, lines);
  Path path = join_lines(field, vehicle, space, lines, options);
  path.cut_back_m = std::move(cuts);
  return path;
}

}  // namespace headland
