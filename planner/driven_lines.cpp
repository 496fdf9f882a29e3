#include "planner/driven_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "planner/part_ways.h"
#include "planner/turns.h"

namespace headland {
namespace {

// Nodes that a route to or from an optional pass may take: there are many, and the next one may do.
constexpr int kOptionalNodes = 3000;
// To another part of the field, where all its passes depend on it.
constexpr int kNodesToOtherPart = 12000;
// No optional pass is worth backing further, and audits read a longer way back as one without
// gears.
constexpr double kFarthestBacking_m = 29.0;
// So many of them are tried in turn before the vehicle is taken to be stuck, and each so often.
constexpr std::size_t kLinesTried = 6;
constexpr int kTriesEach = 6;

struct Driving {
  LineJoining& joining;
  std::optional<PartWays> ways{};  // where there are optional lines
  std::vector<DrivenLine> driven{};
};

Pose begin_of(const Driving& driving, std::size_t line) {
  return pose_of(driving.joining.lines[line].points.front());
}

Pose end_of(const Driving& driving, std::size_t line) {
  return pose_of(driving.joining.lines[line].points.back());
}

std::optional<std::vector<Arc>> arcs_between(Driving& driving, std::size_t before,
                                             std::size_t next) {
  LineJoining& joining = driving.joining;
  const std::vector<Arc>& known = joining.lines[before].turn_to_next;
  if (next == before + 1 && !known.empty()) return known;
  const Pose from = end_of(driving, before);
  const Pose to = begin_of(driving, next);
  const double clearance_m =
      clearance_between(joining.space, from, to, joining.options.clearance_m);
  if (clearance_m < -kFitTolerance_m) return std::nullopt;
  const bool optional = joining.lines[before].optional || joining.lines[next].optional;
  if (optional && are_apart(*driving.ways, from, to)) return std::nullopt;
  int nodes = joining.node_budget;
  if (optional) {
    const RoomyParts& parts = driving.ways->parts;
    nodes = std::min(nodes, parts.at(from) == parts.at(to) ? kOptionalNodes : kNodesToOtherPart);
  }
  const int allowed = nodes;
  auto arcs = connect(joining.space, from, to, connection_options(joining, clearance_m), nodes);
  joining.node_budget -= allowed - nodes;
  if (optional && arcs && longest_backing_m(*arcs) > kFarthestBacking_m) arcs.reset();
  if (optional) note_search(*driving.ways, from, to, arcs.has_value());
  return arcs;
}

// `apart`: from all that is driven.
void leave_out(LineJoining& joining, std::size_t line, bool apart) {
  const std::vector<PathPoint>& points = joining.lines[line].points;
  const Eigen::Vector2d middle_W = implement_at(joining, points[points.size() / 2]);
  const std::string what =
      fmt::format("{} at {}", line_name(joining.lines, line), place_name(joining.field, middle_W));
  joining.path.left_out.push_back(
      {line, middle_W,
       apart ? fmt::format("no way is found through tight gaps to {}", what)
             : fmt::format("no turn to or from {} fits", what)});
}

void turn_round(WorkLine& line) {
  std::swap(line.points, line.other_way);
  std::swap(line.run_in, line.other_run_in);
}

// From here on the rows of a line are worked, its end when the turn from it is known.
void work_next(Driving& driving, std::size_t next) {
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

// Appends a line if a turn leads to it, the other way round if that helps.
bool drive_next(Driving& driving, std::size_t next) {
  DrivenLine to{next};
  if (!driving.driven.empty()) {
    const std::size_t before = driving.driven.back().line;
    to.arcs = arcs_between(driving, before, next);
    WorkLine& line = driving.joining.lines[next];
    if (!to.arcs && !line.other_way.empty()) {
      turn_round(line);
      to.arcs = arcs_between(driving, before, next);
      if (!to.arcs) turn_round(line);
    }
    if (!to.arcs) return false;
  }
  work_next(driving, next);
  driving.driven.push_back(std::move(to));
  return true;
}

// Whether what is known rules a line out as the next, either way round.
bool is_apart(Driving& driving, std::size_t before, std::size_t next) {
  const Pose from = end_of(driving, before);
  const WorkLine& line = driving.joining.lines[next];
  return are_apart(*driving.ways, from, begin_of(driving, next)) &&
         (line.other_way.empty() ||
          are_apart(*driving.ways, from, pose_of(line.other_way.front())));
}

int part_of(const Driving& driving, std::size_t line) {
  const std::vector<PathPoint>& points = driving.joining.lines[line].points;
  return driving.ways->parts.at(pose_of(points[points.size() / 2]));
}

// The part that the field is entered in, if some of the lines are in it, else the one that most is
// to be driven in.
int main_part(const Driving& driving, const std::vector<std::size_t>& lines) {
  std::map<int, double> length_m;
  for (const std::size_t line : lines) {
    length_m[part_of(driving, line)] +=
        kPathSpacing_m * static_cast<double>(driving.joining.lines[line].points.size());
  }
  if (driving.joining.field.entry_W) {
    const std::vector<Pose> entries = poses_near(
        driving.joining.space, *driving.joining.field.entry_W, driving.joining.options.clearance_m);
    if (!entries.empty()) {
      const int entered = driving.ways->parts.at(entries.front());
      if (length_m.contains(entered)) return entered;
    }
  }
  return std::ranges::max_element(length_m, {}, [](const auto& part) { return part.second; })
      ->first;
}

// Lines that a path may begin with, each of them once: those of the main part, the first of which
// comes first then, and those before it last.
std::vector<char> lines_to_begin_with(const Driving& driving, std::vector<std::size_t>& waiting) {
  std::vector<char> may_begin(driving.joining.lines.size(), 0);
  const int part = main_part(driving, waiting);
  const auto in_main_part = [&](std::size_t line) { return part_of(driving, line) == part; };
  for (const std::size_t line : waiting) may_begin[line] = in_main_part(line) ? 1 : 0;
  std::ranges::rotate(waiting, std::ranges::find_if(waiting, in_main_part));
  return may_begin;
}

// Drives optional lines in their order as far as turns lead to them. Those that could not be come
// to wait until the vehicle has come on; one from which nothing leads on waits likewise, and is
// left out when it happens again.
void drive_optional(Driving& driving, std::vector<std::size_t> waiting) {
  if (waiting.empty()) return;
  LineJoining& joining = driving.joining;
  std::vector<DrivenLine>& driven = driving.driven;
  const std::size_t first = driven.size();
  std::vector<char> may_begin;
  if (driven.empty()) may_begin = lines_to_begin_with(driving, waiting);
  const auto begins = [&](std::size_t line) { return may_begin[line] != 0; };
  std::vector<int> tries(joining.lines.size(), 0);
  while (!waiting.empty()) {
    stop_if(joining.cancelled);
    std::size_t failed = 0;
    const auto reached = std::ranges::find_if(waiting, [&](std::size_t line) {
      if (driven.empty()) return begins(line) && drive_next(driving, line);
      if (failed >= kLinesTried || is_apart(driving, driven.back().line, line)) return false;
      if (drive_next(driving, line)) return true;
      ++failed;
      ++tries[line];
      return false;
    });
    const auto apart_from_all = [&](std::size_t line) {
      return std::ranges::all_of(
          driven, [&](const DrivenLine& before) { return is_apart(driving, before.line, line); });
    };
    if (reached != waiting.end()) {
      if (driven.size() == 1 && first == 0) may_begin[*reached] = 0;
      waiting.erase(reached);
    } else if (std::ranges::all_of(waiting, apart_from_all)) {
      for (const std::size_t line : waiting) leave_out(joining, line, true);
      return;
    } else if (driven.size() == 1 && first == 0 && std::ranges::none_of(waiting, begins)) {
      for (const std::size_t line : waiting) leave_out(joining, line, apart_from_all(line));
      return;
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
      leave_out(joining, line, false);
      return true;
    });
  }
}

}  // namespace

std::vector<DrivenLine> lines_to_drive(LineJoining& joining) {
  Driving driving{joining};
  std::vector<DrivenLine>& driven = driving.driven;
  if (std::ranges::any_of(joining.lines, &WorkLine::optional)) {
    driving.ways.emplace(PartWays{roomy_parts(joining.space, joining.options.clearance_m)});
  }
  for (std::size_t next = 0; next < joining.lines.size();) {
    stop_if(joining.cancelled);
    std::vector<std::size_t> optional;
    for (; next < joining.lines.size() && joining.lines[next].optional; ++next) {
      optional.push_back(next);
    }
    drive_optional(driving, std::move(optional));
    if (next == joining.lines.size()) break;
    bool reached = drive_next(driving, next);
    while (!reached && joining.lines[driven.back().line].optional) {
      leave_out(joining, driven.back().line, false);
      driven.pop_back();
      reached = drive_next(driving, next);
    }
    if (!reached) {
      if (!joining.options.allow_overrun) refuse_connection(joining, driven.back().line, next);
      work_next(driving, next);
      driven.push_back({next});
    }
    ++next;
  }
  return std::move(driving.driven);
}

}  // namespace headland
