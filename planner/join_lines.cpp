#include "planner/join_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "planner/connection.h"
#include "planner/continuous_turns.h"
#include "planner/driven_lines.h"
#include "planner/entry_way.h"
#include "planner/line_joining.h"
#include "planner/turns.h"

namespace headland {
namespace {

std::string_view limit_name(Limit limit) {
  switch (limit) {
    case Limit::kBoundary:
      return "beyond the boundary";
    case Limit::kHole:
      return "inside a hole";
    case Limit::kObstacle:
      return "into an obstacle";
    case Limit::kNone:
      break;
  }
  return "";
}

void record(LineJoining& joining, const Overrun& worst, std::string_view what) {
  joining.path.violations.push_back({worst.p_W, joining.manoeuvre, worst.depth_m,
                                     fmt::format("{}: the hull reaches {:.2f} m {}", what,
                                                 worst.depth_m, limit_name(worst.limit))});
}

PathKind connection_kind(const LineJoining& joining, const Pose& from, const Pose& to,
                         const std::vector<Arc>& arcs) {
  const bool straight = std::ranges::all_of(arcs, [](const Arc& arc) {
    return arc.curvature_per_m == 0.0 && arc.sharpness_per_m2 == 0.0;
  });
  if (straight) return PathKind::kTransit;
  const double turn_like_m = 2.0 * std::numbers::pi * joining.radius_m +
                             kTransitWidths * joining.vehicle.implement.working_width_m;
  if (length_m(arcs) > turn_like_m) return PathKind::kTransit;
  const double turned_rad = std::abs(wrap_angle(to.heading_rad - from.heading_rad));
  return turned_rad >= kUTurnAngle_rad ? PathKind::kUTurn : PathKind::kTurn;
}

// A path that begins with the arcs begins at rest.
void count_jumps(const std::vector<Arc>& arcs, const PathPoint& to, Path& path) {
  if (!is_continuous(arcs)) {
    ++path.abrupt_turns;
    return;
  }
  const double before_per_m = path.segments.empty()
                                  ? arcs.front().curvature_per_m
                                  : path.segments.back().points.back().curvature_per_m;
  path.abrupt_joints += abrupt_joints(arcs, before_per_m, to.curvature_per_m);
}

// The sampled end is replaced by the pose meant, which it meets to within rounding.
void append_arcs(LineJoining& joining, const Pose& from, const std::vector<Arc>& arcs,
                 const PathPoint& to, PathKind kind) {
  auto segments = sample(from, arcs, kPathSpacing_m);
  if (segments.empty()) return;
  if (joining.options.continuous_turns) count_jumps(arcs, to, joining.path);
  PathPoint& end = segments.back().points.back();
  end.p_W = to.p_W;
  end.heading_rad = to.heading_rad;
  for (PathSegment& segment : segments) {
    segment.kind = kind;
    segment.manoeuvre = joining.manoeuvre;
    joining.path.segments.push_back(std::move(segment));
  }
  ++joining.manoeuvre;
}

void append_connection(LineJoining& joining, std::size_t before, const DrivenLine& next) {
  const PathPoint& from = joining.lines[before].points.back();
  const PathPoint& to = joining.lines[next.line].points.front();
  std::optional<std::vector<Arc>> arcs = next.arcs;
  if (!arcs) {
    arcs = connect_overrunning(joining.space, pose_of(from), pose_of(to), joining.radius_m);
    const Overrun worst = worst_overrun(joining.space, pose_of(from), *arcs);
    if (worst.depth_m > 0.0) {
      record(joining, worst,
             fmt::format("turn from {} to {}", line_name(joining.lines, before),
                         line_name(joining.lines, next.line)));
    } else if (joining.options.keep_off_worked) {
      joining.path.violations.push_back(
          {from.p_W, joining.manoeuvre, 0.0,
           fmt::format("turn from {} to {}: none keeps the wheels off the rows worked",
                       line_name(joining.lines, before), line_name(joining.lines, next.line))});
    }
  }
  append_arcs(joining, pose_of(from), *arcs, to,
              connection_kind(joining, pose_of(from), pose_of(to), *arcs));
}

void check_curvature(LineJoining& joining, std::size_t index) {
  const double limit_per_m = (1.0 + kCurvatureTolerance) / min_turning_radius_m(joining.vehicle);
  const std::vector<PathPoint>& points = joining.lines[index].points;
  const auto tightest =
      std::max_element(points.begin(), points.end(), [](const PathPoint& a, const PathPoint& b) {
        return std::abs(a.curvature_per_m) < std::abs(b.curvature_per_m);
      });
  const double curvature = std::abs(tightest->curvature_per_m);
  if (curvature <= limit_per_m) return;
  const double radius_m = 1.0 / curvature;
  const double least_m = min_turning_radius_m(joining.vehicle);
  const std::string what = fmt::format(
      "{} bends with a radius of {:.2f} m at {}, the vehicle's least is {:.2f} m",
      line_name(joining.lines, index), radius_m, place_name(joining.field, tightest->p_W), least_m);
  if (!joining.options.allow_overrun) {
    throw PlanInfeasible(what + "; widen the bend or allow overruns (--allow-overrun)");
  }
  joining.path.violations.push_back({tightest->p_W, joining.manoeuvre, least_m - radius_m, what});
}

// A run-in belongs to the turn that leads to it.
void append_run_in(LineJoining& joining, std::vector<PathPoint> points) {
  std::vector<PathSegment>& segments = joining.path.segments;
  if (segments.empty() || segments.back().implement_down) {
    segments.push_back(
        {PathKind::kTransit, Gear::kForward, false, joining.manoeuvre, std::move(points)});
    ++joining.manoeuvre;
    return;
  }
  if (segments.back().gear == Gear::kReverse) {
    segments.push_back({segments.back().kind, Gear::kForward, false, segments.back().manoeuvre,
                        std::move(points)});
    return;
  }
  std::vector<PathPoint>& turn = segments.back().points;
  turn.insert(turn.end(), points.begin() + 1, points.end());
}

void append_line(LineJoining& joining, std::size_t index) {
  const WorkLine& line = joining.lines[index];
  const Overrun worst = worst_overrun(joining.space, line.points);
  if (worst.depth_m > kFitTolerance_m) {
    if (!joining.options.allow_overrun) {
      // Too little room at the end of a swath is a matter of the headland.
      const double to_end_m = (worst.p_W - line.points.back().p_W).norm();
      const double reach = reach_m(joining.space.hull) + kPathSpacing_m;
      if (to_end_m <= reach && index + 1 < joining.lines.size()) {
        refuse_connection(joining, index, index + 1);
      }
      throw PlanInfeasible(
          fmt::format("{} takes the hull {:.2f} m {} at {}; keep passes further inside or allow "
                      "overruns (--allow-overrun)",
                      line_name(joining.lines, index), worst.depth_m, limit_name(worst.limit),
                      place_name(joining.field, worst.p_W)));
    }
    record(joining, worst, line_name(joining.lines, index));
  }
  check_curvature(joining, index);
  const auto work_begin = line.points.begin() + static_cast<std::ptrdiff_t>(line.run_in);
  if (line.run_in > 0) append_run_in(joining, {line.points.begin(), work_begin + 1});
  joining.path.segments.push_back({line.kind,
                                   Gear::kForward,
                                   true,
                                   joining.manoeuvre,
                                   {work_begin, line.points.end()},
                                   line.optional});
  ++joining.manoeuvre;
}

void append_entry(LineJoining& joining, const DrivenLine& first) {
  const PathPoint& to = joining.lines[first.line].points.front();
  if (first.arcs) {
    append_arcs(joining, *first.entry, *first.arcs, to, PathKind::kTransit);
    return;
  }
  const EntryWay way = overrunning_way_from_entry(joining, first.line);
  const Overrun worst = worst_overrun(joining.space, way.from, way.arcs);
  if (worst.depth_m > 0.0) record(joining, worst, "way from the entry");
  append_arcs(joining, way.from, way.arcs, to, PathKind::kTransit);
}

}  // namespace

Path join_lines(const Field& field, const Vehicle& vehicle, const FreeSpace& space,
                const std::vector<WorkLine>& lines, const PathOptions& options,
                const CancelAsked& cancelled, const TurnRemedies& remedies, int node_budget) {
  WorkedGround worked;
  FreeSpace off_rows;
  if (options.keep_off_worked) {
    worked = ground_to_work(field);
    off_rows = space;
    off_rows.worked = &worked;
  }
  LineJoining joining{field,    vehicle, lines, options, options.keep_off_worked ? off_rows : space,
                      cancelled};
  joining.worked = options.keep_off_worked ? &worked : nullptr;
  joining.node_budget = node_budget;
  joining.remedies = remedies;
  joining.radius_m = planning_turning_radius_m(vehicle);
  const std::vector<DrivenLine> driven = lines_to_drive(joining);
  if (field.entry_W) append_entry(joining, driven.front());
  for (std::size_t i = 0; i < driven.size(); ++i) {
    if (i > 0) append_connection(joining, driven[i - 1].line, driven[i]);
    append_line(joining, driven[i].line);
  }
  joining.path.tightest = tightest_place(space, joining.path, options.clearance_m);
  return std::move(joining.path);
}

}  // namespace headland
