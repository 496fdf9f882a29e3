#include "planner/optional_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace headland {
namespace {

// So many lines are tried in turn before the vehicle is taken to be stuck, and each so often.
constexpr std::size_t kLinesTried = 6;
constexpr int kTriesEach = 6;

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

// Of the parts that some of the lines are in the one that the field is entered in, else that the
// first line which must be driven begins in, else the one that most is to be driven in.
int main_part(const LineDriving& driving, const RoomyParts& parts,
              const std::vector<std::size_t>& lines) {
  std::map<int, std::size_t> points_in;
  for (const std::size_t line : lines) {
    points_in[driving.parts[line].begin] += driving.joining.lines[line].points.size();
  }
  const LineJoining& joining = driving.joining;
  if (joining.field.entry_W) {
    const std::vector<Pose> entries =
        poses_near(joining.space, *joining.field.entry_W, joining.options.clearance_m);
    const int entered = entries.empty() ? kNoPart : parts.at(entries.front());
    if (entered != kNoPart && points_in.contains(entered)) return entered;
  }
  const auto must = std::ranges::find(joining.lines, false, &WorkLine::optional);
  if (must != joining.lines.end()) {
    const int part = driving.parts[static_cast<std::size_t>(must - joining.lines.begin())].begin;
    if (part != kNoPart && points_in.contains(part)) return part;
  }
  if (points_in.size() > 1) points_in.erase(kNoPart);
  return std::ranges::max_element(points_in, {}, [](const auto& part) { return part.second; })
      ->first;
}

// Lines on their way into `driven`.
struct Waiting {
  std::vector<std::size_t> lines;
  std::vector<char> may_begin;  // of all lines: a path may begin with it, and has not yet
  std::vector<int> tries;       // of all lines
  // A part is left for another when all its lines are driven or given up.
  bool finishes_parts = false;
};

Waiting waiting_for(const LineDriving& driving, const RoomyParts& parts,
                    const std::vector<std::size_t>& lines) {
  const std::size_t count = driving.joining.lines.size();
  Waiting waiting{lines, std::vector<char>(count, 0), std::vector<int>(count, 0), false};
  if (!driving.driven.empty()) return waiting;
  const int part = main_part(driving, parts, lines);
  const auto in_main_part = [&](std::size_t line) { return driving.parts[line].begin == part; };
  for (const std::size_t line : lines) waiting.may_begin[line] = in_main_part(line) ? 1 : 0;
  std::rotate(waiting.lines.begin(), std::ranges::find_if(waiting.lines, in_main_part),
              waiting.lines.end());
  return waiting;
}

bool begin_with(LineDriving& driving, Waiting& waiting, std::size_t line) {
  if (waiting.may_begin[line] == 0) return false;
  waiting.may_begin[line] = 0;
  if (drive_next(driving, line)) return true;
  const auto begins = [&](std::size_t other) { return waiting.may_begin[other] != 0; };
  if (!driving.joining.options.allow_overrun || std::ranges::any_of(waiting.lines, begins)) {
    return false;
  }
  drive_regardless(driving, line);
  return true;
}

// Drives one of the lines that wait; false when none of them can be come to.
bool drive_one(LineDriving& driving, Waiting& waiting) {
  const int from_part =
      driving.driven.empty() ? kNoPart : driving.parts[driving.driven.back().line].end;
  const auto is_here = [&](std::size_t line) {
    return from_part != kNoPart &&
           (driving.parts[line].begin == from_part || driving.other_parts[line].begin == from_part);
  };
  const bool stays = waiting.finishes_parts && std::ranges::any_of(waiting.lines, is_here);
  std::size_t failed = 0;
  const auto reached = std::ranges::find_if(waiting.lines, [&](std::size_t line) {
    if (driving.driven.empty()) return begin_with(driving, waiting, line);
    if (stays && !is_here(line)) return false;
    if (failed >= kLinesTried || is_apart(driving, from_part, line)) return false;
    if (drive_next(driving, line)) return true;
    ++failed;
    ++waiting.tries[line];
    return false;
  });
  if (reached == waiting.lines.end()) return false;
  waiting.lines.erase(reached);
  return true;
}

// What was driven when most was.
struct Longest {
  std::size_t points = 0;
  std::vector<DrivenLine> driven;
  std::vector<char> turned;
};

void keep_longest(const LineDriving& driving, Longest& longest) {
  std::size_t points = 0;
  for (const DrivenLine& line : driving.driven)
    points += driving.joining.lines[line.line].points.size();
  if (points > longest.points) longest = {points, driving.driven, driving.turned};
}

void lie_as(const std::vector<char>& turned, LineDriving& driving) {
  for (std::size_t line = 0; line < turned.size(); ++line) {
    if (driving.turned[line] != turned[line]) turn_round(driving, line);
  }
}

void go_back_to(Longest longest, LineDriving& driving) {
  if (!longest.driven.empty()) lie_as(longest.turned, driving);
  driving.driven = std::move(longest.driven);
}

std::set<int> parts_driven(const LineDriving& driving) {
  std::set<int> parts;
  for (const DrivenLine& line : driving.driven) parts.insert(driving.parts[line.line].end);
  return parts;
}

bool is_apart_from_all(const LineDriving& driving, const std::set<int>& parts, std::size_t line) {
  return !parts.empty() &&
         std::ranges::all_of(parts, [&](int part) { return is_apart(driving, part, line); });
}

// Appends lines that wait until none of them can be come to any more.
void drive_as_far_as_possible(LineDriving& driving, Waiting waiting, Longest& longest) {
  std::vector<DrivenLine>& driven = driving.driven;
  const std::size_t first = driven.size();
  const auto begins = [&](std::size_t line) { return waiting.may_begin[line] != 0; };
  while (!waiting.lines.empty()) {
    stop_if(driving.joining.cancelled);
    if (drive_one(driving, waiting)) continue;
    keep_longest(driving, longest);
    const std::set<int> from_parts = parts_driven(driving);
    const bool all_apart = std::ranges::all_of(waiting.lines, [&](std::size_t line) {
      return is_apart_from_all(driving, from_parts, line);
    });
    if (all_apart ||
        (driven.size() <= 1 && first == 0 && std::ranges::none_of(waiting.lines, begins))) {
      break;
    }
    if (driven.size() > first) {
      const std::size_t stuck = driven.back().line;
      driven.pop_back();
      waiting.tries[stuck] += kTriesEach / 2;
      waiting.lines.push_back(stuck);
    } else {
      waiting.tries[waiting.lines.front()] = kTriesEach;
    }
    std::erase_if(waiting.lines,
                  [&](std::size_t line) { return waiting.tries[line] >= kTriesEach; });
  }
  keep_longest(driving, longest);
}

}  // namespace

void drive_optional(LineDriving& driving, const RoomyParts& parts,
                    const std::vector<std::size_t>& lines) {
  if (lines.empty()) return;
  const std::size_t first = driving.driven.size();
  const int node_budget = driving.joining.node_budget;
  const PartWays ways = driving.ways;
  const std::vector<char> turned = driving.turned;
  Longest longest;
  drive_as_far_as_possible(driving, waiting_for(driving, parts, lines), longest);
  std::set<int> begun_in;
  for (const std::size_t line : lines) begun_in.insert(driving.parts[line].begin);
  if (longest.driven.size() < first + lines.size() && begun_in.size() > 1) {
    // A tight gap may lead one way only. What was searched for in vain from elsewhere is forgotten.
    driving.driven.resize(first);
    driving.joining.node_budget = node_budget;
    driving.ways = ways;
    lie_as(turned, driving);
    Waiting waiting = waiting_for(driving, parts, lines);
    waiting.finishes_parts = true;
    drive_as_far_as_possible(driving, std::move(waiting), longest);
  }
  go_back_to(std::move(longest), driving);
  std::set<std::size_t> reached;
  for (const DrivenLine& line : driving.driven) reached.insert(line.line);
  const std::set<int> from_parts = parts_driven(driving);
  for (const std::size_t line : lines) {
    if (reached.contains(line)) continue;
    leave_out(driving.joining, line, is_apart_from_all(driving, from_parts, line));
  }
}

bool drive_leaving_out(LineDriving& driving, std::size_t next) {
  std::vector<DrivenLine>& driven = driving.driven;
  std::vector<DrivenLine> taken_back;
  while (taken_back.size() < kMostTakenBack && driven.size() > 1 &&
         driving.joining.lines[driven.back().line].optional) {
    stop_if(driving.joining.cancelled);
    taken_back.push_back(std::move(driven.back()));
    driven.pop_back();
    if (!drive_next(driving, next)) continue;
    for (const DrivenLine& line : taken_back) leave_out(driving.joining, line.line, false);
    return true;
  }
  for (; !taken_back.empty(); taken_back.pop_back()) driven.push_back(std::move(taken_back.back()));
  return false;
}

}  // namespace headland
