#include "planner/drivable_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "planner/join_lines.h"
#include "planner/line_ends.h"
#include "planner/outline.h"
#include "planner/polygon.h"
#include "planner/work_line.h"

namespace headland {

namespace {

// The pass driven the other way, without what does not fit at its ends; empty where it does not fit
// in between.
std::vector<PathPoint> other_way(Pass pass, const FreeSpace& space, double implement_x_B_m,
                                 double clearance_m) {
  constexpr std::size_t kLeastPoints = 3;
  std::ranges::reverse(pass.points_W);
  std::vector<PathPoint> points = work_line(pass, implement_x_B_m).points;
  const auto fine = [&](const PathPoint& point) {
    return fits(space, pose_of(point), clearance_m - kFitTolerance_m);
  };
  const auto first = std::ranges::find_if(points, fine);
  points.erase(points.begin(), first);
  points.erase(std::find_if(points.rbegin(), points.rend(), fine).base(), points.end());
  if (points.size() < kLeastPoints || !std::ranges::all_of(points, fine)) return {};
  return points;
}

}  // namespace

Path make_path(const Field& field, const Vehicle& vehicle, const Plan& plan,
               const PathOptions& options, const CancelAsked& cancelled) {
  if (plan.passes.empty()) throw PlanInfeasible("the plan has no passes");
  const Field outline = simplified(field);
  const FreeSpace space = free_space(outline, hull_of(vehicle));
  std::vector<WorkLine> lines;
  lines.reserve(plan.passes.size());
  for (const Pass& pass : plan.passes) {
    if (!(length_m(pass.points_W) > 0.0)) {
      throw PlanInfeasible(fmt::format("pass {} has no length", lines.size() + 1));
    }
    lines.push_back(work_line(pass, vehicle.implement.x_B_m));
    if (pass.kind == PassKind::kSwath) add_run_in(lines.back(), run_in_m(vehicle));
    if (pass.optional) {
      lines.back().other_way = other_way(pass, space, vehicle.implement.x_B_m, options.clearance_m);
    }
  }
  const ConnectionOptions connection{planning_turning_radius_m(vehicle), options.clearance_m,
                                     cancelled};
  std::vector<double> cuts =
      make_room_for_turns(plan, outline, space, connection, vehicle.implement.x_B_m, lines);
  Path path = join_lines(field, vehicle, space, lines, options, cancelled);
  path.cut_back_m = std::move(cuts);
  return path;
}

}  // namespace headland
