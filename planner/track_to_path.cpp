#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/drivable_path.h"
#include "planner/join_lines.h"
#include "planner/outline.h"
#include "planner/track_pieces.h"

namespace headland {
namespace {

// A piece whose headings all lie within this of its first one is a swath.
constexpr double kStraight_rad = 0.26;  // 15 degrees

bool is_straight(const TrackPiece& piece) {
  double heading_rad = 0.0;
  double least_rad = 0.0;
  double most_rad = 0.0;
  for (const Arc& arc : piece.arcs) {
    heading_rad += arc.length_m * arc.curvature_per_m;
    least_rad = std::min(least_rad, heading_rad);
    most_rad = std::max(most_rad, heading_rad);
  }
  return most_rad - least_rad <= kStraight_rad;
}

// The line of B's origin: `ahead_m` further along than the track, beginning on it and running on
// straight at its end (the other way round for an implement ahead of the axle).
WorkLine line_of(const TrackPiece& piece, double ahead_m) {
  std::vector<Arc> arcs = piece.arcs;
  Pose start = piece.start;
  if (ahead_m < 0.0) {
    start = pose_along(start, {-ahead_m, 0.0, Gear::kReverse}, -ahead_m);
    arcs.insert(arcs.begin(), {-ahead_m, 0.0, Gear::kForward});
  } else {
    arcs.push_back({ahead_m, 0.0, Gear::kForward});
  }
  const auto shorten = [](Arc& arc, double& left_m) {
    const double by_m = std::min(left_m, arc.length_m);
    arc.length_m -= by_m;
    left_m -= by_m;
    return by_m;
  };
  double left_m = std::abs(ahead_m);
  if (ahead_m < 0.0) {
    for (auto arc = arcs.rbegin(); arc != arcs.rend() && left_m > 0.0; ++arc) {
      shorten(*arc, left_m);
    }
  } else {
    for (auto arc = arcs.begin(); arc != arcs.end() && left_m > 0.0; ++arc) {
      const Arc whole = *arc;
      start = pose_along(start, whole, shorten(*arc, left_m));
    }
  }
  WorkLine line;
  line.kind = is_straight(piece) ? PathKind::kSwath : PathKind::kHeadlandPass;
  line.points = sample(start, arcs, kPathSpacing_m).front().points;
  return line;
}

std::string place_name(const Eigen::Vector2d& p_W) {
  return fmt::format("({:.1f}, {:.1f}) m", p_W.x(), p_W.y());
}

std::string pauses_note(const TrackPauses& pauses) {
  return fmt::format(
      "{} of {} pauses longer than {:.0f} s taken as breaks: the place jumps by more than {:.1f} m "
      "or the heading turns by more than {:.0f} deg; work goes on through the others",
      pauses.breaks, pauses.count, pauses.longest_interval_s, pauses.longest_step_m,
      kPauseTurn_rad * 180.0 / std::numbers::pi);
}

}  // namespace

Path make_drivable(const Field& field, const Vehicle& vehicle, const Track& track,
                   double tolerance_m, const PathOptions& options, TrackReport* report,
                   const CancelAsked& cancelled) {
  check_path_options(vehicle, options);
  const double ahead_m = track.of_vehicle ? 0.0 : -vehicle.implement.x_B_m;
  const TrackPieces found =
      track_pieces(track, tolerance_m, planning_turning_radius_m(vehicle), ahead_m);
  if (found.pieces.empty()) {
    throw PlanInfeasible(
        fmt::format("the track has no piece of {} m that the vehicle can follow", kMinPiece_m));
  }
  std::vector<WorkLine> lines;
  lines.reserve(found.pieces.size());
  for (const TrackPiece& piece : found.pieces) lines.push_back(line_of(piece, ahead_m));
  if (report != nullptr) {
    *report = {};
    report->pieces = static_cast<int>(found.pieces.size());
    report->cut_corners = found.cut_corners;
    for (const TrackPiece& piece : found.pieces) {
      report->max_deviation_m = std::max(report->max_deviation_m, piece.max_deviation_m);
    }
    if (track.pauses.count > 0) report->notes.push_back(pauses_note(track.pauses));
    for (const Eigen::Vector2d& corner : found.corners_W) {
      report->notes.push_back(fmt::format("corner tighter than {:.2f} m at {} replaced by a turn",
                                          planning_turning_radius_m(vehicle), place_name(corner)));
    }
    for (const Eigen::Vector2d& dropped : found.dropped_W) {
      report->notes.push_back(
          fmt::format("piece shorter than {} m at {} left out", kMinPiece_m, place_name(dropped)));
    }
  }
  return join_lines(field, vehicle, free_space(simplified(field), hull_of(vehicle)), lines, options,
                    cancelled);
}

}  // namespace headland
