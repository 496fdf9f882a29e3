#include "planner/drivable_path.h"

#include "planner/join_lines.h"
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
  return join_lines(field, vehicle, lines, options);
}

}  // namespace headland
