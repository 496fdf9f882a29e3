#include "planner/driven_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

std::optional<std::vector<Arc>> arcs_between(LineJoining& joining, std::size_t before,
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

void leave_out(LineJoining& joining, std::size_t line) {
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

// From here on the rows of a line are worked, its end when the turn from it is known.
void work_next(LineJoining& joining, std::size_t next, const std::vector<DrivenLine>& driven) {
  if (joining.worked == nullptr) return;
  const auto whole = [&](std::size_t line) { return joining.lines[line].points.size() - 1; };
  const auto tail = [&](std::size_t line) {
    return whole(line) - tail_edges(joining.lines[line], joining.vehicle, 0.0);
  };
  if (!driven.empty()) {
    const std::size_t before = driven.back().line;
    work_rows(*joining.worked, joining.lines[before], tail(before), whole(before), joining.vehicle);
  }
  work_rows(*joining.worked, joining.lines[next], 0, tail(next), joining.vehicle);
}

// Appends a line if a turn leads to it, the other way round if that helps.
bool drive_next(LineJoining& joining, std::size_t next, std::vector<DrivenLine>& driven) {
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
  work_next(joining, next, driven);
  driven.push_back(std::move(to));
  return true;
}

// Drives optional lines in their order as far as turns lead to them. Those that could not be come
// to wait until the vehicle has come on; one from which nothing leads on waits likewise, and is
// left out when it happens again.
void drive_optional(LineJoining& joining, std::vector<std::size_t> waiting,
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

}  // namespace

std::vector<DrivenLine> lines_to_drive(LineJoining& joining) {
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
      work_next(joining, next, driven);
      driven.push_back({next});
    }
    ++next;
  }
  return driven;
}

}  // namespace headland
