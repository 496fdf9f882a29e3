#include "planner/drivable_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "planner/continuous_turns.h"
#include "planner/join_lines.h"
#include "planner/line_ends.h"
#include "planner/line_joining.h"
#include "planner/outline.h"
#include "planner/polygon.h"
#include "planner/work_line.h"
#include "planner/worked_rows.h"
#include "terrains/input_error.h"

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

// Ends moved for turns that keep off the rows before them, if asked.
std::vector<double> with_room(const Plan& plan, const Field& outline, FreeSpace space,
                              const ConnectionOptions& connection, const Vehicle& vehicle,
                              const PathOptions& options, std::vector<WorkLine>& lines) {
  WorkedGround worked;
  if (options.keep_off_worked) {
    worked = ground_to_work(outline);
    space.worked = &worked;
  }
  return make_room_for_turns(plan, outline, space, connection, vehicle,
                             options.keep_off_worked ? &worked : nullptr, lines);
}

// A plan of which less than this can be driven, by the ground that its passes work, is none.
constexpr double kLeastDriven = 0.5;

// Measures the ground that passes left out would work and the path does not. Returns what the path
// works [m2].
double measure_left_out(const Field& outline, const Vehicle& vehicle,
                        const std::vector<Pass>& passes, Path& path) {
  const double width_m = vehicle.implement.working_width_m;
  WorkedGround ground = ground_to_work(outline);
  double worked_m2 = 0.0;
  for (const PathSegment& segment : path.segments) {
    if (!segment.implement_down) continue;
    worked_m2 += work_driven(ground, segment.points, vehicle.implement.x_B_m, width_m);
  }
  for (LeftOutPass& left_out : path.left_out) {
    left_out.area_m2 = work_along(ground, passes[left_out.pass].points_W, width_m);
  }
  std::ranges::stable_sort(path.left_out, std::greater{}, &LeftOutPass::area_m2);
  return worked_m2;
}

// A vehicle that gets nowhere is refused, however well it would work the little that it reaches.
void refuse_if_most_left_out(const Field& field, double worked_m2, const Path& path) {
  double all_m2 = worked_m2;
  for (const LeftOutPass& left_out : path.left_out) all_m2 += left_out.area_m2;
  if (worked_m2 >= kLeastDriven * all_m2) return;
  const std::size_t others = path.left_out.size() - 1;
  throw PlanInfeasible(fmt::format(
      "turns lead{} to no more than {:.0f} of {:.0f} m² that passes would work: {}{}. Take a "
      "smaller vehicle or one that turns tighter, remove what is in the way, or accept a plan of "
      "the rest (--allow-overrun)",
      field.entry_W ? " from the entry at " + place_name(field, *field.entry_W) : "", worked_m2,
      all_m2, path.left_out.front().why,
      others == 0   ? ""
      : others == 1 ? "; 1 other is left out"
                    : fmt::format("; {} others are left out", others)));
}

}  // namespace

void check_path_options(const Vehicle& vehicle, const PathOptions& options) {
  if (!options.continuous_turns || vehicle.steering.kind != SteeringKind::kSkid) return;
  throw InputError("path", "continuous_turns", "true",
                   fmt::format("only of vehicles with steered wheels; {} steers by its sides' "
                               "speeds, which takes no way",
                               vehicle.name));
}

Path make_path(const Field& field, const Vehicle& vehicle, const Plan& plan,
               const PathOptions& options, const CancelAsked& cancelled) {
  check_path_options(vehicle, options);
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
  ConnectionOptions connection{planning_turning_radius_m(vehicle), options.clearance_m, cancelled};
  if (options.continuous_turns) connection.sharpness_per_m2 = turning_sharpness_per_m2(vehicle);
  std::vector<double> cuts = with_room(plan, outline, space, connection, vehicle, options, lines);
  Path path = join_lines(field, vehicle, space, lines, options, cancelled, plan.remedies);
  if (!path.left_out.empty()) {
    const double worked_m2 = measure_left_out(outline, vehicle, plan.passes, path);
    if (!options.allow_overrun) refuse_if_most_left_out(field, worked_m2, path);
  }
  path.cut_back_m = std::move(cuts);
  return path;
}

}  // namespace headland
