#include "planner/line_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planner/polygon.h"
#include "planner/round_begin.h"
#include "planner/turns.h"

namespace headland {
namespace {

constexpr double kCutStep_m = 0.5;
constexpr double kLeastSwath_m = 2.0;  // what is left of a swath that lies in the headland whole

// As far as turning takes a headland pass along some edges alone is cut back [turning radii].
constexpr double kMostCutRadii = 3.0;

// How far a swath may be cut at its begin and its end [m].
struct Allowance {
  double begin_m = 0.0;
  double end_m = 0.0;
};

bool closed(const Pass& pass) {
  return pass.kind == PassKind::kHeadlandPass && pass.points_W.size() > 3 &&
         pass.points_W.front() == pass.points_W.back();
}

Allowance allowance(const Pass& pass, const PolygonSet& inside_headland, double radius_m) {
  if (closed(pass)) return {};
  const double whole_m = std::max(0.0, 0.5 * (length_m(pass.points_W) - kLeastSwath_m));
  if (pass.kind == PassKind::kHeadlandPass) {
    const double most_m = std::min(whole_m, kMostCutRadii * radius_m);
    return {most_m, most_m};
  }
  const std::vector<Polyline> inner = clip_line(pass.points_W, inside_headland);
  if (inner.empty()) return {whole_m, whole_m};
  return {std::min(whole_m, (inner.front().front() - pass.points_W.front()).norm()),
          std::min(whole_m, (inner.back().back() - pass.points_W.back()).norm())};
}

// Points of an evenly spaced line that a cut of cut_m takes off one of its ends.
std::size_t points_within(const WorkLine& line, double cut_m) {
  const double spacing_m = (line.points[1].p_W - line.points[0].p_W).norm();
  return static_cast<std::size_t>(std::floor(cut_m / spacing_m));
}

// Begins the round where the cheapest turn from the end of `from` leads to; false when none does.
bool begin_elsewhere(const Pass& round, WorkLine& from, WorkLine& to, const FreeSpace& space,
                     ConnectionOptions options, double implement_x_B_m) {
  const Pose end = pose_of(from.points.back());
  std::optional<Pass> best;
  options.most_m = std::numeric_limits<double>::infinity();
  for (const RoundBegin& begin : round_begins(round.points_W, end.p_W)) {
    stop_if(options.cancelled);
    // No turn is shorter than the way as the crow flies, and the rest begins further away.
    const double away_m = (round.points_W[begin.point] - end.p_W).norm();
    if (away_m - std::abs(implement_x_B_m) >= options.most_m) break;
    Pass begun{round.kind, begun_at(round.points_W, begin)};
    const Pose pose = pose_of(work_line_begin(begun, implement_x_B_m));
    auto arcs = connect_by_turn(space, end, pose, options);
    if (!arcs) continue;
    options.most_m = cost_m(*arcs);
    from.turn_to_next = std::move(*arcs);
    best = std::move(begun);
  }
  if (best) to = work_line(*best, implement_x_B_m);
  return best.has_value();
}

// How many points are cut off the end of one line and the begin of the next.
struct Cut {
  std::size_t off_end = 0;
  std::size_t off_begin = 0;
};

Cut cut_by(const WorkLine& from, double end_m, const WorkLine& to, double begin_m, int steps) {
  return {points_within(from, std::min(steps * kCutStep_m, end_m)),
          points_within(to, std::min(steps * kCutStep_m, begin_m))};
}

// Cuts both lines' facing ends as little as makes a turn fit; the lengths cut off, if any. Taken to
// be so that no smaller cut will do where a larger one does not.
std::vector<double> cut_back(WorkLine& from, double end_m, WorkLine& to, double begin_m,
                             const FreeSpace& space, const ConnectionOptions& options) {
  const auto turn_fits = [&](int steps) {
    stop_if(options.cancelled);
    const Cut cut = cut_by(from, end_m, to, begin_m, steps);
    const PathPoint& last = from.points[from.points.size() - 1 - cut.off_end];
    auto arcs = connect_by_turn(space, pose_of(last), pose_of(to.points[cut.off_begin]), options);
    if (arcs) from.turn_to_next = std::move(*arcs);
    return arcs.has_value();
  };
  int enough = static_cast<int>(std::ceil(std::max(end_m, begin_m) / kCutStep_m));
  if (enough == 0 || !turn_fits(enough)) return {};
  for (int too_little = 0; enough - too_little > 1;) {
    const int middle = (too_little + enough) / 2;
    (turn_fits(middle) ? enough : too_little) = middle;
  }
  const Cut cut = cut_by(from, end_m, to, begin_m, enough);
  const PathPoint last = from.points[from.points.size() - 1 - cut.off_end];
  const PathPoint first = to.points[cut.off_begin];
  std::vector<double> cuts_m;
  if (cut.off_end > 0) cuts_m.push_back((from.points.back().p_W - last.p_W).norm());
  if (cut.off_begin > 0) cuts_m.push_back((to.points.front().p_W - first.p_W).norm());
  from.points.resize(from.points.size() - cut.off_end);
  to.points.erase(to.points.begin(),
                  to.points.begin() + static_cast<std::ptrdiff_t>(cut.off_begin));
  return cuts_m;
}

// Cuts an end that no turn is sought at as little as makes the hull fit there, at most `most_m`;
// the length cut off.
double cut_to_fit(WorkLine& line, bool at_end, double most_m, const FreeSpace& space,
                  double clearance_m) {
  const auto place = [&](std::size_t cut) -> const PathPoint& {
    return at_end ? line.points[line.points.size() - 1 - cut] : line.points[cut];
  };
  const std::size_t most = points_within(line, most_m);
  std::size_t cut = 0;
  while (cut < most && !fits(space, pose_of(place(cut)), clearance_m)) ++cut;
  if (cut == 0 || !fits(space, pose_of(place(cut)), clearance_m)) return 0.0;
  const double cut_m = (place(cut).p_W - place(0).p_W).norm();
  const auto off = static_cast<std::ptrdiff_t>(cut);
  if (at_end) {
    line.points.erase(line.points.end() - off, line.points.end());
  } else {
    line.points.erase(line.points.begin(), line.points.begin() + off);
  }
  return cut_m;
}

// The same for all swaths before and after optional passes, and at the ends of the plan.
std::vector<double> cut_loose_ends(const Plan& plan, const PolygonSet& inside_headland,
                                   const FreeSpace& space, const ConnectionOptions& options,
                                   std::vector<WorkLine>& lines) {
  std::vector<double> cuts;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].optional || lines[i].kind != PathKind::kSwath) continue;
    const Allowance most = allowance(plan.passes[i], inside_headland, options.radius_m);
    const auto cut = [&](bool at_end, double most_m) {
      const double cut_m = cut_to_fit(lines[i], at_end, most_m, space, options.clearance_m);
      if (cut_m > 0.0) cuts.push_back(cut_m);
    };
    if (i + 1 == lines.size() || lines[i + 1].optional) cut(true, most.end_m);
    if (i == 0 || lines[i - 1].optional) cut(false, most.begin_m);
  }
  return cuts;
}

}  // namespace

std::vector<double> make_room_for_turns(const Plan& plan, const Field& field,
                                        const FreeSpace& space, const ConnectionOptions& options,
                                        const Vehicle& vehicle, WorkedGround* worked,
                                        std::vector<WorkLine>& lines) {
  const double implement_x_B_m = vehicle.implement.x_B_m;
  const PolygonSet inside_headland =
      plan.kept_whole ? *plan.kept_whole
                      : buffered(from_field(field), -plan.headland_width_m, Join::kRound);
  std::vector<double> cuts;
  // Elsewhere the headland is deep enough for that.
  if (plan.kept_whole) cuts = cut_loose_ends(plan, inside_headland, space, options, lines);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    stop_if(options.cancelled);
    WorkLine& from = lines[i];
    WorkLine& to = lines[i + 1];
    if (from.optional || to.optional) continue;
    const double end_m = allowance(plan.passes[i], inside_headland, options.radius_m).end_m;
    const auto work = [&](std::size_t first, std::size_t last) {
      return worked != nullptr ? work_rows(*worked, from, first, last, vehicle)
                               : std::vector<std::size_t>{};
    };
    const std::size_t tail = from.points.size() - 1 - tail_edges(from, vehicle, 0.0);
    const std::size_t kept = from.points.size() - 1 - tail_edges(from, vehicle, end_m);
    work(0, kept);
    const std::vector<std::size_t> may_be_cut = work(kept, tail);
    const auto work_tail = [&] { work(tail, from.points.size() - 1); };
    if (auto arcs = connect_by_turn(space, pose_of(from.points.back()), pose_of(to.points.front()),
                                    options)) {
      from.turn_to_next = std::move(*arcs);
      work_tail();
      continue;
    }
    if (closed(plan.passes[i + 1]) &&
        begin_elsewhere(plan.passes[i + 1], from, to, space, options, implement_x_B_m)) {
      work_tail();
      continue;
    }
    // Where the line is cut back no row has been worked.
    if (worked != nullptr) unwork(*worked, may_be_cut);
    const double begin_m = allowance(plan.passes[i + 1], inside_headland, options.radius_m).begin_m;
    const std::vector<double> cut = cut_back(from, end_m, to, begin_m, space, options);
    cuts.insert(cuts.end(), cut.begin(), cut.end());
    if (worked == nullptr) continue;
    // What is left of the row is kept off, too.
    const std::size_t last = from.points.size() - 1;
    const std::size_t rest = last - tail_edges(from, vehicle, 0.0);
    work(std::min(kept, rest), rest);
    const Pose end = pose_of(from.points.back());
    if (!from.turn_to_next.empty() &&
        !fits_along(space, end, from.turn_to_next, options.clearance_m)) {
      from.turn_to_next = connect_by_turn(space, end, pose_of(to.points.front()), options)
                              .value_or(std::vector<Arc>{});
    }
    work(rest, last);
  }
  return cuts;
}

}  // namespace headland
