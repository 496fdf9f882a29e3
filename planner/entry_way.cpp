#include "planner/entry_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "planner/turns.h"

namespace headland {
namespace {

struct Choice {
  Pose from;
  Turn turn;
};

// Turns from every heading, the cheapest first.
std::vector<Choice> choices_to(const LineJoining& joining, const std::vector<Pose>& poses,
                               const Pose& to) {
  std::vector<Choice> choices;
  for (const Pose& from : poses) {
    for (Turn& turn : turns(from, to, joining.radius_m, joining.space.hull.gears)) {
      choices.push_back({from, std::move(turn)});
    }
  }
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.turn.cost_m < b.turn.cost_m; });
  return choices;
}

std::vector<Pose> entries(const LineJoining& joining) {
  return poses_near(joining.space, *joining.field.entry_W, joining.options.clearance_m);
}

std::optional<EntryWay> continuous_way(const LineJoining& joining, const std::vector<Pose>& poses,
                                       const Pose& to, double clearance_m) {
  std::optional<EntryWay> best;
  for (const Pose& from : poses) {
    auto arcs = connect_by_turn(joining.space, from, to, connection_options(joining, clearance_m));
    if (!arcs || (best && length_m(*arcs) >= length_m(best->arcs))) continue;
    best = EntryWay{from, std::move(*arcs)};
  }
  return best;
}

}  // namespace

std::optional<EntryWay> way_from_entry(LineJoining& joining, std::size_t line, int most_nodes) {
  const Pose to = pose_of(joining.lines[line].points.front());
  const double clearance_m = std::max(
      -kFitTolerance_m, clearance_between(joining.space, to, to, joining.options.clearance_m));
  const std::vector<Pose> poses = entries(joining);
  if (joining.options.continuous_turns) {
    if (auto way = continuous_way(joining, poses, to, clearance_m)) return way;
  }
  std::vector<Choice> choices = choices_to(joining, poses, to);
  for (Choice& choice : choices) {
    if (!fits_along(joining.space, choice.from, choice.turn.arcs, clearance_m)) continue;
    return EntryWay{choice.from, std::move(choice.turn.arcs)};
  }
  if (choices.empty()) return std::nullopt;
  // What blocks one heading blocks the others: a route is searched from the cheapest alone.
  const Pose& from = choices.front().from;
  auto arcs = connect_within(joining, from, to, clearance_m, most_nodes);
  if (!arcs) return std::nullopt;
  return EntryWay{from, std::move(*arcs)};
}

EntryWay overrunning_way_from_entry(const LineJoining& joining, std::size_t line) {
  const Pose to = pose_of(joining.lines[line].points.front());
  const std::vector<Choice> choices = choices_to(joining, entries(joining), to);
  const Pose from =
      choices.empty() ? Pose{*joining.field.entry_W, to.heading_rad} : choices.front().from;
  return {from, connect_overrunning(joining.space, from, to, joining.radius_m)};
}

void refuse_entry(const LineJoining& joining, std::size_t line) {
  throw PlanInfeasible(fmt::format(
      "no way from the entry at {} to {} at {} fits the hull; move the entry or allow overruns "
      "(--allow-overrun)",
      place_name(joining.field, *joining.field.entry_W), line_name(joining.lines, line),
      place_name(joining.field, joining.lines[line].points.front().p_W)));
}

}  // namespace headland
