#include "planner/line_driving.h"

#include <algorithm>
#include <utility>

#include "planner/entry_way.h"
#include "planner/turns.h"

namespace headland {
namespace {

// Nodes that a route to or from an optional pass may take: there are many, and the next one may do.
constexpr int kOptionalNodes = 3000;
// To another part of the field, where all its passes depend on it, and from the entry.
constexpr int kNodesToOtherPart = 12000;
// No optional pass is worth backing further, and audits read a longer way back as one without
// gears.
constexpr double kFarthestBacking_m = 29.0;

LineParts parts_of(const RoomyParts& parts, const std::vector<PathPoint>& points) {
  if (points.empty()) return {};
  return {parts.at(pose_of(points.front())), parts.at(pose_of(points.back()))};
}

std::optional<std::vector<Arc>> arcs_between(LineDriving& driving, std::size_t before,
                                             std::size_t next) {
  LineJoining& joining = driving.joining;
  const std::vector<Arc>& known = joining.lines[before].turn_to_next;
  if (next == before + 1 && !known.empty()) return known;
  const Pose from = pose_of(joining.lines[before].points.back());
  const Pose to = pose_of(joining.lines[next].points.front());
  const double clearance_m =
      clearance_between(joining.space, from, to, joining.options.clearance_m);
  if (clearance_m < -kFitTolerance_m) return std::nullopt;
  const bool optional = joining.lines[before].optional || joining.lines[next].optional;
  if (!optional) return connect_within(joining, from, to, clearance_m, joining.node_budget);
  const int from_part = driving.parts[before].end;
  const int to_part = driving.parts[next].begin;
  if (are_apart(driving.ways, from_part, to_part)) return std::nullopt;
  auto arcs = connect_within(joining, from, to, clearance_m,
                             from_part == to_part ? kOptionalNodes : kNodesToOtherPart);
  if (arcs && longest_backing_m(*arcs) > kFarthestBacking_m) arcs.reset();
  note_search(driving.ways, from_part, to_part, arcs.has_value());
  return arcs;
}

// From here on the rows of a line are worked, its end when the turn from it is known.
void work_next(LineDriving& driving, std::size_t next) {
  LineJoining& joining = driving.joining;
  if (joining.worked == nullptr) return;
  const auto whole = [&](std::size_t line) { return joining.lines[line].points.size() - 1; };
  const auto tail = [&](std::size_t line) {
    return whole(line) - tail_edges(joining.lines[line], joining.vehicle, 0.0);
  };
  if (!driving.driven.empty()) {
    const std::size_t before = driving.driven.back().line;
    work_rows(*joining.worked, joining.lines[before], tail(before), whole(before), joining.vehicle);
  }
  work_rows(*joining.worked, joining.lines[next], 0, tail(next), joining.vehicle);
}

// How a line is come to as it lies; its arcs are missing where nothing leads to it.
DrivenLine come_to(LineDriving& driving, std::size_t next) {
  if (!driving.driven.empty()) {
    return {next, arcs_between(driving, driving.driven.back().line, next)};
  }
  const bool optional = driving.joining.lines[next].optional;
  auto way = way_from_entry(driving.joining, next,
                            optional ? kNodesToOtherPart : driving.joining.node_budget);
  if (!way) return {next};
  return {next, std::move(way->arcs), way->from};
}

}  // namespace

LineDriving begin_driving(LineJoining& joining, const RoomyParts* parts) {
  LineDriving driving{joining};
  driving.turned.assign(joining.lines.size(), 0);
  if (parts == nullptr) return driving;
  for (const WorkLine& line : joining.lines) {
    driving.parts.push_back(parts_of(*parts, line.points));
    driving.other_parts.push_back(parts_of(*parts, line.other_way));
  }
  return driving;
}

void turn_round(LineDriving& driving, std::size_t index) {
  WorkLine& line = driving.joining.lines[index];
  std::swap(line.points, line.other_way);
  std::swap(line.run_in, line.other_run_in);
  std::swap(driving.parts[index], driving.other_parts[index]);
  driving.turned[index] = driving.turned[index] == 0 ? 1 : 0;
}

void drive_regardless(LineDriving& driving, std::size_t next) {
  work_next(driving, next);
  driving.driven.push_back({next});
}

bool drive_next(LineDriving& driving, std::size_t next) {
  const LineJoining& joining = driving.joining;
  if (driving.driven.empty() && !joining.field.entry_W) {
    drive_regardless(driving, next);
    return true;
  }
  DrivenLine to = come_to(driving, next);
  if (!to.arcs && !joining.lines[next].other_way.empty()) {
    turn_round(driving, next);
    to = come_to(driving, next);
    if (!to.arcs) turn_round(driving, next);
  }
  if (!to.arcs) return false;
  work_next(driving, next);
  driving.driven.push_back(std::move(to));
  return true;
}

bool is_apart(const LineDriving& driving, int from_part, std::size_t next) {
  return are_apart(driving.ways, from_part, driving.parts[next].begin) &&
         (driving.joining.lines[next].other_way.empty() ||
          are_apart(driving.ways, from_part, driving.other_parts[next].begin));
}

}  // namespace headland
