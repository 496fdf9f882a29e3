#include "planner/join_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "planner/connection.h"
#include "planner/turns.h"

namespace headland {
namespace {

// Nodes that a route to or from an optional pass may take: there are many, and the next one may do.
constexpr int kOptionalNodes = 3000;
// No optional pass is worth backing further, and audits read a longer way back as one without
// gears.
constexpr double kFarthestBacking_m = 29.0;
// So many of them are tried in turn before the vehicle is taken to be stuck, and each so often.
constexpr std::size_t kLinesTried = 6;
constexpr int kTriesEach = 6;
// Headland widths are named in steps of this.
constexpr double kWidthStep_m = 0.1;

std::string place_name(const Field& field, const Eigen::Vector2d& p_W) {
  std::string place = fmt::format("({:.1f}, {:.1f}) m", p_W.x(), p_W.y());
  if (field.frame.georeferenced) {
    const Eigen::Vector2d lon_lat = wgs84_from_local(field.frame, {p_W}).front();
    place += fmt::format(" [lon {:.6f}, lat {:.6f}]", lon_lat.x(), lon_lat.y());
  }
  return place;
}

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

std::string line_name(const std::vector<WorkLine>& lines, std::size_t index) {
  const bool swath = lines[index].kind == PathKind::kSwath;
  return fmt::format("pass {} ({})", index + 1, swath ? "swath" : "headland pass");
}

struct Joining {
  const Field& field;
  const Vehicle& vehicle;
  std::vector<WorkLine> lines;
  const PathOptions& options;
  const FreeSpace& space;
  const CancelAsked& cancelled;
  double radius_m = 0.0;
  int node_budget = 0;
  int manoeuvre = 0;
  Path path{};
};

ConnectionOptions connection_options(const Joining& joining, double clearance_m) {
  return {joining.radius_m, clearance_m, joining.cancelled};
}

Eigen::Vector2d implement_at(const Joining& joining, const PathPoint& axle) {
  return axle.p_W + joining.space.hull.bar_x_m * direction_of(axle.heading_rad);
}

void record(Joining& joining, const Overrun& worst, std::string_view what) {
  joining.path.violations.push_back({worst.p_W, joining.manoeuvre, worst.depth_m,
                                     fmt::format("{}: the hull reaches {:.2f} m {}", what,
                                                 worst.depth_m, limit_name(worst.limit))});
}

// Why nothing fits between two lines, and what would help.
[[noreturn]] void refuse_connection(const Joining& joining, std::size_t before, std::size_t next) {
  const PathPoint& from = joining.lines[before].points.back();
  const PathPoint& to = joining.lines[next].points.front();
  const Eigen::Vector2d end_W = implement_at(joining, from);
  const std::string what =
      fmt::format("no turn from {} to {} fits at {}", line_name(joining.lines, before),
                  line_name(joining.lines, next), place_name(joining.field, end_W));
  const EdgeAhead ahead = edge_ahead(joining.space, end_W, from.heading_rad);
  const double there_m = ahead.distance_m * ahead.outward.dot(direction_of(from.heading_rad));
  const double depth_m = least_depth_m(joining.space, pose_of(from), pose_of(to), joining.radius_m,
                                       end_W, ahead.outward) +
                         joining.options.clearance_m;
  if (depth_m > there_m) {
    const double would_do_m = std::ceil(depth_m / kWidthStep_m) * kWidthStep_m;
    throw PlanInfeasible(
        fmt::format("{}: it needs a headland of {:.1f} m and there are {:.1f} m; widen the "
                    "headland, turn tighter or allow overruns (--allow-overrun)",
                    what, would_do_m, there_m));
  }
  throw PlanInfeasible(fmt::format(
      "{}: the way is blocked though the headland of {:.1f} m is deep enough; move the passes, "
      "remove what is in the way or allow overruns (--allow-overrun)",
      what, there_m));
}

PathKind connection_kind(const Joining& joining, const Pose& from, const Pose& to,
                         const std::vector<Arc>& arcs) {
  const bool straight =
      std::ranges::all_of(arcs, [](const Arc& arc) { return arc.curvature_per_m == 0.0; });
  if (straight) return PathKind::kTransit;
  const double turn_like_m = 2.0 * std::numbers::pi * joining.radius_m +
                             kTransitWidths * joining.vehicle.implement.working_width_m;
  if (length_m(arcs) > turn_like_m) return PathKind::kTransit;
  const double turned_rad = std::abs(wrap_angle(to.heading_rad - from.heading_rad));
  return turned_rad >= kUTurnAngle_rad ? PathKind::kUTurn : PathKind::kTurn;
}

// The sampled end is replaced by the pose meant, which it meets to within rounding.
void append_arcs(Joining& joining, const Pose& from, const std::vector<Arc>& arcs,
                 const PathPoint& to, PathKind kind) {
  auto segments = sample(from, arcs, kPathSpacing_m);
  if (segments.empty()) return;
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

// A line that is driven, and how it is come to from the one before; without arcs the turn does not
// fit.
struct DrivenLine {
  std::size_t line = 0;
  std::optional<std::vector<Arc>> arcs{};
};

std::optional<std::vector<Arc>> arcs_between(Joining& joining, std::size_t before,
                                             std::size_t next) {
  const std::vector<Arc>& known = joining.lines[before].turn_to_next;
  if (next == before + 1 && !known.empty()) return known;
  const Pose from = pose_of(joining.lines[before].points.back());
  const Pose to = pose_of(joining.lines[next].points.front());
  const double clearance_m =
      clearance_between(joining.space, from, to, joining.options.clearance_m);
  if (clearance_m < -kFitTolerance_m) return std::nullopt;
  const bool optional = joining.lines[before].optional || joining.lines[next].optional;
  int nodes = std::min(joining.node_budget, optional ? kOptionalNodes : joining.node_budget);
  const int allowed = nodes;
  auto arcs = connect(joining.space, from, to, connection_options(joining, clearance_m), nodes);
  joining.node_budget -= allowed - nodes;
  if (optional && arcs && longest_backing_m(*arcs) > kFarthestBacking_m) arcs.reset();
  return arcs;
}

void leave_out(Joining& joining, std::size_t line) {
  const std::vector<PathPoint>& points = joining.lines[line].points;
  const Eigen::Vector2d middle_W = implement_at(joining, points[points.size() / 2]);
  joining.path.left_out.push_back(
      {line, middle_W,
       fmt::format("no turn to or from {} at {} fits", line_name(joining.lines, line),
                   place_name(joining.field, middle_W))});
}

void turn_round(WorkLine& line) {
  std::swap(line.points, line.other_way);
  std::swap(line.run_in, line.other_run_in);
}

// Appends a line if a turn leads to it, the other way round if that helps.
bool drive_next(Joining& joining, std::size_t next, std::vector<DrivenLine>& driven) {
  DrivenLine to{next};
  if (!driven.empty()) {
    to.arcs = arcs_between(joining, driven.back().line, next);
    WorkLine& line = joining.lines[next];
    if (!to.arcs && !line.other_way.empty()) {
      turn_round(line);
      to.arcs = arcs_between(joining, driven.back().line, next);
      if (!to.arcs) turn_round(line);
    }
    if (!to.arcs) return false;
  }
  driven.push_back(std::move(to));
  return true;
}

// Drives optional lines in their order as far as turns lead to them. Those that could not be come
// to wait until the vehicle has come on; one from which nothing leads on waits likewise, and is
// left out when it happens again.
void drive_optional(Joining& joining, std::vector<std::size_t> waiting,
                    std::vector<DrivenLine>& driven) {
  const std::size_t first = driven.size();
  std::vector<int> tries(joining.lines.size(), 0);
  while (!waiting.empty()) {
    stop_if(joining.cancelled);
    std::size_t failed = 0;
    const auto reached = std::ranges::find_if(waiting, [&](std::size_t line) {
      if (failed >= kLinesTried) return false;
      if (drive_next(joining, line, driven)) return true;
      ++failed;
      ++tries[line];
      return false;
    });
    if (reached != waiting.end()) {
      waiting.erase(reached);
    } else if (driven.size() > first) {
      const std::size_t stuck = driven.back().line;
      driven.pop_back();
      tries[stuck] += kTriesEach / 2;
      waiting.push_back(stuck);
    } else {
      tries[waiting.front()] = kTriesEach;
    }
    std::erase_if(waiting, [&](std::size_t line) {
      if (tries[line] < kTriesEach) return false;
      leave_out(joining, line);
      return true;
    });
  }
}

std::vector<DrivenLine> lines_to_drive(Joining& joining) {
  std::vector<DrivenLine> driven;
  for (std::size_t next = 0; next < joining.lines.size();) {
    stop_if(joining.cancelled);
    std::vector<std::size_t> optional;
    for (; next < joining.lines.size() && joining.lines[next].optional; ++next) {
      optional.push_back(next);
    }
    drive_optional(joining, std::move(optional), driven);
    if (next == joining.lines.size()) break;
    bool reached = drive_next(joining, next, driven);
    while (!reached && joining.lines[driven.back().line].optional) {
      leave_out(joining, driven.back().line);
      driven.pop_back();
      reached = drive_next(joining, next, driven);
    }
    if (!reached) {
      if (!joining.options.allow_overrun) refuse_connection(joining, driven.back().line, next);
      driven.push_back({next});
    }
    ++next;
  }
  return driven;
}

void append_connection(Joining& joining, std::size_t before, const DrivenLine& next) {
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
    }
  }
  append_arcs(joining, pose_of(from), *arcs, to,
              connection_kind(joining, pose_of(from), pose_of(to), *arcs));
}

void check_curvature(Joining& joining, std::size_t index) {
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
void append_run_in(Joining& joining, std::vector<PathPoint> points) {
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

void append_line(Joining& joining, std::size_t index) {
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
  joining.path.segments.push_back(
      {line.kind, Gear::kForward, true, joining.manoeuvre, {work_begin, line.points.end()}});
  ++joining.manoeuvre;
}

// The way from the entry to the first line, from the heading that makes it cheapest.
void append_entry(Joining& joining, const Eigen::Vector2d& entry_W) {
  const PathPoint& to = joining.lines.front().points.front();
  const double clearance_m = std::max(
      -kFitTolerance_m,
      clearance_between(joining.space, pose_of(to), pose_of(to), joining.options.clearance_m));
  const std::vector<Pose> poses = poses_near(joining.space, entry_W, joining.options.clearance_m);
  struct Choice {
    Pose from;
    Turn turn;
  };
  std::vector<Choice> choices;
  for (const Pose& from : poses) {
    for (Turn& turn : turns(from, pose_of(to), joining.radius_m, joining.space.hull.gears)) {
      choices.push_back({from, std::move(turn)});
    }
  }
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.turn.cost_m < b.turn.cost_m; });
  for (const Choice& choice : choices) {
    if (!fits_along(joining.space, choice.from, choice.turn.arcs, clearance_m)) continue;
    append_arcs(joining, choice.from, choice.turn.arcs, to, PathKind::kTransit);
    return;
  }
  // What blocks one heading blocks the others: a route is searched from the cheapest alone.
  if (!choices.empty()) {
    const Choice& choice = choices.front();
    const auto arcs = connect(joining.space, choice.from, pose_of(to),
                              connection_options(joining, clearance_m), joining.node_budget);
    if (arcs) {
      append_arcs(joining, choice.from, *arcs, to, PathKind::kTransit);
      return;
    }
  }
  if (!joining.options.allow_overrun) {
    throw PlanInfeasible(fmt::format(
        "no way from the entry at {} to {} at {} fits the hull; move the entry or allow overruns "
        "(--allow-overrun)",
        place_name(joining.field, entry_W), line_name(joining.lines, 0),
        place_name(joining.field, to.p_W)));
  }
  const Pose from = choices.empty() ? Pose{entry_W, to.heading_rad} : choices.front().from;
  const auto arcs = connect_overrunning(joining.space, from, pose_of(to), joining.radius_m);
  const Overrun worst = worst_overrun(joining.space, from, arcs);
  if (worst.depth_m > 0.0) record(joining, worst, "way from the entry");
  append_arcs(joining, from, arcs, to, PathKind::kTransit);
}

}  // namespace

Path join_lines(const Field& field, const Vehicle& vehicle, const FreeSpace& space,
                const std::vector<WorkLine>& lines, const PathOptions& options,
                const CancelAsked& cancelled, int node_budget) {
  Joining joining{field, vehicle, lines, options, space, cancelled};
  joining.node_budget = node_budget;
  joining.radius_m = planning_turning_radius_m(vehicle);
  if (field.entry_W) append_entry(joining, *field.entry_W);
  const std::vector<DrivenLine> driven = lines_to_drive(joining);
  for (std::size_t i = 0; i < driven.size(); ++i) {
    if (i > 0) append_connection(joining, driven[i - 1].line, driven[i]);
    append_line(joining, driven[i].line);
  }
  joining.path.tightest = tightest_place(space, joining.path, options.clearance_m);
  return std::move(joining.path);
}

}  // namespace headland
