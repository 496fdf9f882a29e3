#include "evaluate/audit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "evaluate/ground_patches.h"
#include "evaluate/line_headings.h"
#include "evaluate/path_check.h"
#include "planner/free_space.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Where the vehicle stands on the path.
struct State {
  Pose pose;
  double along_m = 0.0;
  double step_m = 0.0;  // from the state before
  bool down = false;    // from the state before to here
  bool starts = false;  // not joined to the state before
};

// Points of lines that are joined, none twice.
struct Corner {
  Eigen::Vector2d p_W;
  bool down = false;  // on the edge that ends here
};
using Stretch = std::vector<Corner>;

// One state's or corner's fault; what follows each other makes a place.
struct Finding {
  AuditFault fault = AuditFault::kOutside;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double along_m = 0.0;
  double length_m = 0.0;
  double value = 0.0;
};

constexpr double kSamePlace_m = 1e-3;  // nearer points have no direction between them

std::vector<Stretch> stretches_of(const std::vector<PathLine>& lines) {
  std::vector<Stretch> stretches;
  for (const PathLine& line : lines) {
    const bool goes_on =
        !stretches.empty() &&
        (line.joined ||
         (line.points_W.front() - stretches.back().back().p_W).norm() <= kMaxSegmentGap_m);
    if (!goes_on) stretches.emplace_back();
    Stretch& stretch = stretches.back();
    for (const Eigen::Vector2d& p_W : line.points_W) {
      if (!stretch.empty() && (p_W - stretch.back().p_W).norm() <= kSamePlace_m) continue;
      stretch.push_back({p_W, line.implement_down});
    }
  }
  return stretches;
}

double direction_rad(const Eigen::Vector2d& edge) { return std::atan2(edge.y(), edge.x()); }

double turn_at(const Stretch& stretch, std::size_t corner) {
  const Eigen::Vector2d before = stretch[corner].p_W - stretch[corner - 1].p_W;
  const Eigen::Vector2d after = stretch[corner + 1].p_W - stretch[corner].p_W;
  return wrap_angle(direction_rad(after) - direction_rad(before));
}

bool turns_back_at(const Stretch& stretch, std::size_t corner) {
  return std::abs(turn_at(stretch, corner)) > kGearChange_rad;
}

// Work is done forward: where the line turns back an odd number of times before the first of it,
// the vehicle begins in reverse.
bool begins_in_reverse(const Stretch& stretch) {
  const auto work = std::find_if(stretch.begin() + 1, stretch.end(),
                                 [](const Corner& corner) { return corner.down; });
  if (work == stretch.end()) return false;
  int times = 0;
  for (std::size_t i = 1; stretch.begin() + static_cast<std::ptrdiff_t>(i) < work; ++i) {
    times += turns_back_at(stretch, i) ? 1 : 0;
  }
  return times % 2 == 1;
}

// By corner, whether the vehicle changes gear there: where the line turns back and soon again, or
// ends; at the first whether it begins in reverse. One that only turns back leaves out how the
// vehicle turned round.
std::vector<bool> gear_changes_of(const Stretch& stretch) {
  std::vector<bool> changes(stretch.size(), false);
  std::optional<std::size_t> open;  // where the vehicle went into reverse; none: it goes forward
  if (begins_in_reverse(stretch)) open = 0;
  double since_m = 0.0;
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    since_m += (stretch[i].p_W - stretch[i - 1].p_W).norm();
    if (since_m > kLongestReverse_m) open.reset();
    const bool ends = i + 1 == stretch.size();
    if (!ends && !turns_back_at(stretch, i)) continue;
    if (open) {
      changes[*open] = true;
      changes[i] = !ends;
      open.reset();
    } else if (!ends) {
      open = i;
      since_m = 0.0;
    }
  }
  return changes;
}

// Of every edge of a stretch, the vehicle's as if it drove forward.
std::vector<EdgeHeading> headings_of(const Stretch& stretch, const std::vector<bool>& changes_gear,
                                     double least_radius_m) {
  std::vector<EdgeHeading> headings;
  std::vector<Eigen::Vector2d> points_W{stretch.front().p_W};
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    points_W.push_back(stretch[i].p_W);
    if (!changes_gear[i] && i + 1 < stretch.size()) continue;
    const std::vector<EdgeHeading> piece = edge_headings(points_W, least_radius_m);
    headings.insert(headings.end(), piece.begin(), piece.end());
    points_W = {stretch[i].p_W};
  }
  return headings;
}

// Adds the states of a stretch, its corners' findings and what it adds to the totals.
void drive_along(const Stretch& stretch, double least_radius_m, Audit& audit,
                 std::vector<State>& states, std::vector<Finding>& findings) {
  if (stretch.size() < 2) return;
  const std::vector<bool> changes_gear = gear_changes_of(stretch);
  const double tightest_m = kTooTightShare * least_radius_m;
  const std::vector<EdgeHeading> headings = headings_of(stretch, changes_gear, tightest_m);
  bool reverse = changes_gear.front();
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    const Eigen::Vector2d edge = stretch[i].p_W - stretch[i - 1].p_W;
    const double edge_m = edge.norm();
    if (i > 1 && changes_gear[i - 1]) {
      reverse = !reverse;
      ++audit.gear_changes;
    } else if (i > 1) {
      const double before_m = headings[i - 2].length_m;
      const double turn_rad = turn_at(stretch, i - 1);
      const double radius_m = corner_radius_m(turn_rad, before_m, edge_m);
      if (radius_m < tightest_m) {
        findings.push_back({AuditFault::kTooTight, stretch[i - 1].p_W, audit.length_m,
                            radius_m * std::abs(turn_rad), radius_m});
      }
    }
    const auto steps = static_cast<std::size_t>(std::ceil(edge_m / kPathSpacing_m));
    const double step_m = edge_m / static_cast<double>(steps);
    // Of a sharp corner both headings are states: the hull of the edge before and that of this one.
    for (std::size_t step = 0; step <= steps; ++step) {
      const double share = static_cast<double>(step) / static_cast<double>(steps);
      const double heading_rad = heading_on(headings[i - 1], share * edge_m);
      State state{{stretch[i - 1].p_W + share * edge,
                   wrap_angle(heading_rad + (reverse ? std::numbers::pi : 0.0))}};
      state.along_m = audit.length_m + share * edge_m;
      state.step_m = step > 0 ? step_m : 0.0;
      state.down = stretch[i].down;
      state.starts = i == 1 && step == 0;
      states.push_back(state);
    }
    audit.length_m += edge_m;
    if (stretch[i].down) audit.working_length_m += edge_m;
    if (reverse) audit.reverse_length_m += edge_m;
  }
}

AuditFault fault_of(Limit limit) {
  if (limit == Limit::kHole) return AuditFault::kInHole;
  return limit == Limit::kObstacle ? AuditFault::kInObstacle : AuditFault::kOutside;
}

void find_overruns(const Field& field, const Vehicle& vehicle, const std::vector<State>& states,
                   std::vector<Finding>& findings) {
  const FreeSpace space = free_space(field, hull_of(vehicle));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Overrun over = overrun(space, states[i].pose);
    if (over.limit == Limit::kNone || over.depth_m <= kFitTolerance_m) continue;
    findings.push_back(
        {fault_of(over.limit), over.p_W, states[i].along_m, states[i].step_m, over.depth_m});
  }
}

bool is_worse(AuditFault fault, double one, double other) {
  return fault == AuditFault::kTooTight ? one < other : one > other;
}

// Findings of one fault that follow each other are one place.
void gather(std::vector<Finding> findings, Audit& audit) {
  std::ranges::stable_sort(findings, {}, [](const Finding& finding) {
    return std::pair(finding.fault, finding.along_m);
  });
  // Between one finding's length, after which the next one follows, and two, after a state without.
  constexpr double kFollowing = 1.5;
  const Finding* before = nullptr;
  for (const Finding& finding : findings) {
    AuditTotals& totals = audit.totals[static_cast<std::size_t>(finding.fault)];
    const bool same = before != nullptr && before->fault == finding.fault &&
                      finding.along_m - before->along_m <=
                          kFollowing * std::max(before->length_m, finding.length_m);
    if (!same) {
      audit.places.push_back({finding.fault, finding.p_W, finding.along_m, 0.0, 0, finding.value});
      ++totals.places;
    }
    AuditPlace& place = audit.places.back();
    if (is_worse(finding.fault, finding.value, place.worst)) {
      place.worst = finding.value;
      place.p_W = finding.p_W;
    }
    if (totals.states == 0 || is_worse(finding.fault, finding.value, totals.worst)) {
      totals.worst = finding.value;
    }
    ++place.states;
    ++totals.states;
    place.length_m += finding.length_m;
    totals.length_m += finding.length_m;
    before = &finding;
  }
  std::ranges::stable_sort(audit.places, {}, &AuditPlace::from_m);
}

std::vector<FootprintSample> footprints_of(const Vehicle& vehicle,
                                           const std::vector<State>& states) {
  const double half_m = 0.5 * vehicle.implement.working_width_m;
  std::vector<FootprintSample> footprints;
  bool strip_open = false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State& state = states[i];
    // A strip begins where the edge before it ended.
    const bool working = state.down;
    strip_open = strip_open && working && !state.starts;
    if (working) {
      const Eigen::Vector2d ahead = direction_of(state.pose.heading_rad);
      const Eigen::Vector2d middle_W = state.pose.p_W + vehicle.implement.x_B_m * ahead;
      const Eigen::Vector2d left = left_of(state.pose.heading_rad);
      footprints.push_back(
          {middle_W + half_m * left, middle_W - half_m * left, 0.0, state.along_m, !strip_open});
    }
    strip_open = working;
  }
  return footprints;
}

std::vector<WorkState> work_states(const std::vector<State>& states) {
  std::vector<WorkState> work;
  work.reserve(states.size());
  for (const State& state : states) {
    work.push_back(
        {state.pose, state.step_m, state.down ? WorkState::Does::kWork : WorkState::Does::kDrive});
  }
  return work;
}

}  // namespace

std::string_view audit_fault_name(AuditFault fault) {
  switch (fault) {
    case AuditFault::kOutside:
      return "outside";
    case AuditFault::kInHole:
      return "in_hole";
    case AuditFault::kInObstacle:
      return "in_obstacle";
    case AuditFault::kTooTight:
      return "too_tight";
    case AuditFault::kJump:
      return "jump";
  }
  return "";
}

Audit audit_path(const Field& field, const Vehicle& vehicle, const std::vector<PathLine>& lines,
                 double coverage_cell_m, const std::string& source) {
  const bool pivots = vehicle.steering.kind == SteeringKind::kSkid;
  const double least_radius_m = pivots ? 0.0 : min_turning_radius_m(vehicle);
  Audit audit;
  std::vector<State> states;
  std::vector<Finding> findings;
  const Corner* end = nullptr;
  const std::vector<Stretch> stretches = stretches_of(lines);
  for (const Stretch& stretch : stretches) {
    if (end != nullptr) {
      findings.push_back({AuditFault::kJump, end->p_W, audit.length_m, 0.0,
                          (stretch.front().p_W - end->p_W).norm()});
    }
    drive_along(stretch, least_radius_m, audit, states, findings);
    end = &stretch.back();
  }
  if (states.empty()) {
    throw InputError(source, "", "", "has no two points that are apart: there is nothing to audit");
  }
  audit.states = states.size();
  find_overruns(field, vehicle, states, findings);
  gather(std::move(findings), audit);
  audit.over_worked = driven_over_worked(field, vehicle, work_states(states));
  audit.raster = measure_coverage(field, footprints_of(vehicle, states),
                                  vehicle.implement.working_width_m, coverage_cell_m);
  audit.coverage = coverage_figures(audit.raster);
  audit.missed = missed_patches(audit.raster, kLeastPatch_m2);
  audit.overlapped = overlapped_patches(audit.raster, kLeastPatch_m2);
  return audit;
}

bool passes(const Audit& audit) { return audit.places.empty(); }

std::vector<PathLine> lines_of(const Path& path) {
  std::vector<PathLine> lines;
  for (const PathSegment& segment : path.segments) {
    PathLine line{{}, segment.implement_down, !lines.empty()};
    for (const PathPoint& point : segment.points) line.points_W.push_back(point.p_W);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace headland
