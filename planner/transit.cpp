#include "planner/transit.h"

#include <fmt/format.h>

#include <utility>

#include "planner/arcs.h"
#include "planner/connection.h"
#include "planner/continuous_turns.h"
#include "planner/free_space.h"
#include "planner/outline.h"
#include "planner/track_pieces.h"

namespace headland {
namespace {

// A piece of the transit: arcs from a pose, and the ground they are to stay in.
struct Piece {
  Pose start;
  std::vector<Arc> arcs;
  const FreeSpace* space = nullptr;
};

struct Joining {
  const Vehicle& vehicle;
  const PathOptions& options;
  const CancelAsked& cancelled;
  const GeoFrame& frame;
  int nodes = 0;           // of routes
  int nodes_off_rows = 0;  // of routes that keep off rows
  Path path{};
};

void record(Joining& joining, const Overrun& worst, const std::string& what) {
  if (worst.depth_m <= kFitTolerance_m) return;
  const std::string text = fmt::format("{}: the hull reaches {:.2f} m too far at {}", what,
                                       worst.depth_m, place_text(joining.frame, worst.p_W));
  if (!joining.options.allow_overrun) {
    throw PlanInfeasible(text + "; a wider road (road_width_m) or wider bends would do");
  }
  joining.path.violations.push_back({worst.p_W, 0, worst.depth_m, text});
}

void append(Joining& joining, const Piece& piece, const std::string& what) {
  record(joining, worst_overrun(*piece.space, piece.start, piece.arcs), what);
  for (PathSegment& segment : sample(piece.start, piece.arcs, kPathSpacing_m)) {
    segment.kind = PathKind::kTransit;
    joining.path.segments.push_back(std::move(segment));
  }
  if (joining.options.continuous_turns && !is_continuous(piece.arcs)) ++joining.path.abrupt_turns;
}

PathPoint straight_at(const Pose& pose) { return {pose.p_W, pose.heading_rad, 0.0}; }

// The arcs that lead from one to the other, which must be where they are to the last digit.
void append_connection(Joining& joining, const FreeSpace& space, const PathPoint& first,
                       const PathPoint& last, const std::string& what) {
  const Pose from = pose_of(first);
  const Pose to = pose_of(last);
  const double clearance_m = clearance_between(space, from, to, joining.options.clearance_m);
  std::optional<std::vector<Arc>> arcs;
  if (clearance_m >= -kFitTolerance_m) {
    ConnectionOptions options{planning_turning_radius_m(joining.vehicle), clearance_m,
                              joining.cancelled};
    if (joining.options.continuous_turns) {
      options.sharpness_per_m2 = turning_sharpness_per_m2(joining.vehicle);
    }
    const bool rows = space.worked != nullptr;
    arcs = connect(space, from, to, options, rows ? joining.nodes_off_rows : joining.nodes);
    if (!arcs && rows) {
      FreeSpace over_rows = space;
      over_rows.worked = nullptr;
      arcs = connect(over_rows, from, to, options, joining.nodes);
      if (arcs && joining.options.allow_overrun) {
        joining.path.violations.push_back(
            {from.p_W, 0, 0.0, what + ": no way keeps the wheels off the rows worked"});
      }
    }
  }
  if (!arcs) {
    if (!joining.options.allow_overrun) {
      throw PlanInfeasible(fmt::format(
          "{}: no turn fits from {} to {}; a wider road (road_width_m), another gate or allowing "
          "overruns (--allow-overrun) would do",
          what, place_text(joining.frame, from.p_W), place_text(joining.frame, to.p_W)));
    }
    arcs = connect_overrunning(space, from, to, planning_turning_radius_m(joining.vehicle));
  }
  const std::size_t before = joining.path.segments.size();
  append(joining, {from, *arcs, &space}, what);
  if (joining.path.segments.size() == before) return;
  if (joining.options.continuous_turns && is_continuous(*arcs)) {
    joining.path.abrupt_joints += abrupt_joints(*arcs, first.curvature_per_m, last.curvature_per_m);
  }
  PathPoint& end = joining.path.segments.back().points.back();
  end.p_W = to.p_W;
  end.heading_rad = to.heading_rad;
}

}  // namespace

Path transit_path(const TransitRequest& request, const Vehicle& vehicle, const PathOptions& options,
                  const CancelAsked& cancelled) {
  Joining joining{vehicle, options, cancelled, request.road.frame, request.nodes, request.nodes};
  const Hull hull = hull_of(vehicle);
  FreeSpace leaving = free_space(simplified(request.leaving), hull);
  leaving.worked = request.rows;
  const FreeSpace arriving = free_space(simplified(request.arriving), hull);
  std::vector<TrackPiece> pieces;
  if (length_m(request.way_W) >= kLeastRoad_m) {
    Track track;
    track.points_W = request.way_W;
    pieces =
        track_pieces(track, 2.0 * kRoadTolerance_m, planning_turning_radius_m(vehicle), 0.0).pieces;
    if (options.continuous_turns) {
      const double sharpness_per_m2 = turning_sharpness_per_m2(vehicle);
      for (TrackPiece& piece : pieces) piece.arcs = with_ramps(piece.arcs, sharpness_per_m2);
    }
  }
  if (pieces.empty()) {
    if (request.from && request.to) {
      append_connection(joining, leaving, *request.from, *request.to, "between the fields");
    }
    return std::move(joining.path);
  }
  const FreeSpace road = free_space(simplified(request.road), hull);
  if (request.from) {
    append_connection(joining, leaving, *request.from, straight_at(pieces.front().start),
                      "onto the road");
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    stop_if(cancelled);
    if (i > 0) {
      append_connection(joining, road, straight_at(end_of(pieces[i - 1].start, pieces[i - 1].arcs)),
                        straight_at(pieces[i].start), "round a bend of the road");
    }
    append(joining, {pieces[i].start, pieces[i].arcs, &road}, "along the road");
  }
  if (request.to) {
    append_connection(joining, arriving,
                      straight_at(end_of(pieces.back().start, pieces.back().arcs)), *request.to,
                      "off the road");
  }
  return std::move(joining.path);
}

}  // namespace headland
