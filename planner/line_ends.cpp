#include "planner/line_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planner/polygon.h"
#include "planner/turns.h"

namespace headland {
namespace {

constexpr double kCutStep_m = 0.5;
constexpr double kBeginStep_m = 1.0;   // between the places where a round may begin
constexpr double kLeastSwath_m = 2.0;  // what is left of a swath that lies in the headland whole

Pose pose_of(const PathPoint& point) { return {point.p_W, point.heading_rad}; }

// How far a swath may be cut at its begin and its end [m].
struct Allowance {
  double begin_m = 0.0;
  double end_m = 0.0;
};

Allowance allowance(const Pass& pass, const PolygonSet& inside_headland) {
  if (pass.kind != PassKind::kSwath) return {};
  const double whole_m = std::max(0.0, 0.5 * (length_m(pass.points_W) - kLeastSwath_m));
  const std::vector<Polyline> inner = clip_line(pass.points_W, inside_headland);
  if (inner.empty()) return {whole_m, whole_m};
  return {std::min(whole_m, (inner.front().front() - pass.points_W.front()).norm()),
          std::min(whole_m, (inner.back().back() - pass.points_W.back()).norm())};
}

// Points of a straight line that a cut of cut_m takes off one of its ends.
std::size_t points_within(const WorkLine& line, double cut_m) {
  const double spacing_m = (line.points[1].p_W - line.points[0].p_W).norm();
  return static_cast<std::size_t>(std::floor(cut_m / spacing_m));
}

bool closed(const Pass& pass) {
  return pass.kind == PassKind::kHeadlandPass &&
         (pass.points_W.front() - pass.points_W.back()).norm() < kRingGap_m;
}

// The closed round begun at another point, driven forwards or backwards.
Pass begun_at(const Pass& round, std::size_t point, bool reversed) {
  Pass begun{round.kind, {}};
  const auto first = round.points_W.begin();
  begun.points_W.assign(first + static_cast<std::ptrdiff_t>(point), round.points_W.end() - 1);
  begun.points_W.insert(begun.points_W.end(), first, first + static_cast<std::ptrdiff_t>(point));
  begun.points_W.push_back(begun.points_W.front());
  if (reversed) std::reverse(begun.points_W.begin(), begun.points_W.end());
  return begun;
}

// The round as a line that a turn from `from` reaches, by the cheapest one; none when no turn does.
std::optional<WorkLine> begin_elsewhere(const Pass& round, const Pose& from, const FreeSpace& space,
                                        const ConnectionOptions& options, double implement_x_B_m) {
  std::optional<WorkLine> best;
  double best_m = std::numeric_limits<double>::infinity();
  const auto count = static_cast<double>(round.points_W.size() - 1);
  const auto step = static_cast<std::size_t>(
      std::max(1.0, std::floor(kBeginStep_m * count / length_m(round.points_W))));
  for (std::size_t point = 0; point + 1 < round.points_W.size(); point += step) {
    for (const bool reversed : {false, true}) {
      WorkLine line = work_line(begun_at(round, point, reversed), implement_x_B_m);
      const auto arcs = connect_by_turn(space, from, pose_of(line.points.front()), options);
      if (!arcs || cost_m(*arcs) >= best_m) continue;
      best_m = cost_m(*arcs);
      best = std::move(line);
    }
  }
  return best;
}

// Cuts both lines' facing ends as little as makes a turn fit; the lengths cut off, if any.
std::vector<double> cut_back(WorkLine& from, double end_m, WorkLine& to, double begin_m,
                             const FreeSpace& space, const ConnectionOptions& options) {
  const double most_m = std::max(end_m, begin_m);
  for (double cut_m = kCutStep_m; cut_m < most_m + kCutStep_m; cut_m += kCutStep_m) {
    const std::size_t off_end = points_within(from, std::min(cut_m, end_m));
    const std::size_t off_begin = points_within(to, std::min(cut_m, begin_m));
    const PathPoint last = from.points[from.points.size() - 1 - off_end];
    const PathPoint first = to.points[off_begin];
    if (!connect_by_turn(space, pose_of(last), pose_of(first), options)) continue;
    std::vector<double> cuts;
    if (off_end > 0) cuts.push_back((from.points.back().p_W - last.p_W).norm());
    if (off_begin > 0) cuts.push_back((to.points.front().p_W - first.p_W).norm());
    from.points.resize(from.points.size() - off_end);
    to.points.erase(to.points.begin(), to.points.begin() + static_cast<std::ptrdiff_t>(off_begin));
    return cuts;
  }
  return {};
}

}  // namespace

std::vector<double> make_room_for_turns(const Plan& plan, const Field& field,
                                        const FreeSpace& space, const ConnectionOptions& options,
                                        double implement_x_B_m, std::vector<WorkLine>& lines) {
  const PolygonSet inside_headland =
      buffered(from_field(field), -plan.headland_width_m, Join::kRound);
  std::vector<double> cuts;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    WorkLine& from = lines[i];
    WorkLine& to = lines[i + 1];
    const Pose end = pose_of(from.points.back());
    if (connect_by_turn(space, end, pose_of(to.points.front()), options)) continue;
    if (closed(plan.passes[i + 1])) {
      auto round = begin_elsewhere(plan.passes[i + 1], end, space, options, implement_x_B_m);
      if (round) to = std::move(*round);
      continue;
    }
    const double end_m = allowance(plan.passes[i], inside_headland).end_m;
    const double begin_m = allowance(plan.passes[i + 1], inside_headland).begin_m;
    const std::vector<double> cut = cut_back(from, end_m, to, begin_m, space, options);
    cuts.insert(cuts.end(), cut.begin(), cut.end());
  }
  return cuts;
}

}  // namespace headland
