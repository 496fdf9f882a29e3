#include "planner/grid_joining.h"

#include <algorithm>
#include <cmath>

#include "planner/grid_drivable.h"

namespace headland {
namespace {

constexpr double kRoomStep_m = 0.05;
constexpr double kDrawStep_m = 0.5;
// A run is entered straight for this long before its begin: tracking errors of the turn fade, which
// would leave slivers unworked beside it.
constexpr double kSettling_m = 1.0;
// Walls beside a run's begin are passed on its line for up to this long.
constexpr double kAlongWalls_m = 12.0;
constexpr int kNodesPerWay = 6000;

// B's pose when the implement is `at_m` along the run.
Pose pose_at(const GridJoining& joining, const GridRun& run, double at_m) {
  const Pass pass = pass_of(joining.map, run);
  const Eigen::Vector2d along_W = (pass.points_W[1] - pass.points_W[0]).normalized();
  const double ahead_m = at_m - run.begin_m - joining.vehicle.implement.x_B_m;
  return {pass.points_W[0] + ahead_m * along_W, std::atan2(along_W.y(), along_W.x())};
}

bool has_room(const GridJoining& joining, const Pose& pose) {
  const Eigen::Vector2d clearance_W =
      joining.connection.clearance_m * direction_of(pose.heading_rad);
  return fits(joining.space, {pose.p_W + clearance_W, pose.heading_rad}, -kFitTolerance_m) &&
         fits(joining.space, {pose.p_W - clearance_W, pose.heading_rad}, -kFitTolerance_m);
}

// How far before its begin a run is entered: from where the hull keeps the clearance for
// kSettling_m on end, as far as there is room. Where the walls beside it go on for long it is
// entered between them.
double settling_run_in_m(const GridJoining& joining, const GridRun& run) {
  const double hull_m = joining.space.hull.front_m + joining.space.hull.rear_m;
  double between_m = 0.0;
  double free_m = -kPathSpacing_m;  // of it with the clearance
  for (double run_in = 0.0; run_in < kAlongWalls_m + kSettling_m; run_in += kPathSpacing_m) {
    const Pose pose = pose_at(joining, run, run.begin_m - run_in);
    const bool free = fits(joining.space, pose, joining.connection.clearance_m);
    free_m = free ? free_m + kPathSpacing_m : -kPathSpacing_m;
    if (free_m >= kSettling_m) return run_in;
    if (run_in < hull_m + kSettling_m) between_m = run_in;
    if (!has_room(joining, pose_at(joining, run, run.begin_m - run_in - kPathSpacing_m))) break;
  }
  return between_m;
}

bool turn_joins(const GridJoining& joining, const GridRun& from, const GridRun& to) {
  const Pose end = end_of(joining, from);
  const Pose begin = begin_of(joining, to);
  ConnectionOptions options = joining.connection;
  options.clearance_m = clearance_between(joining.space, end, begin, options.clearance_m);
  return options.clearance_m >= -kFitTolerance_m &&
         connect_by_turn(joining.space, end, begin, options).has_value();
}

}  // namespace

std::optional<GridRun> with_room(const GridJoining& joining, const GridRun& run) {
  const double run_in = run_in_m(joining.vehicle);
  const double length_m = run.end_m - run.begin_m + run_in;
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / kRoomStep_m)));
  GridRun best = run;
  best.end_m = best.begin_m;
  int first = -1;
  for (int i = 0; i <= steps; ++i) {
    const double on_m = length_m * i / steps;
    if (!has_room(joining, pose_at(joining, run, run.begin_m - run_in + on_m))) {
      first = -1;
      continue;
    }
    if (first < 0) first = i;
    const double begin_m = run.begin_m + length_m * first / steps;
    const double end_m = i == steps ? run.end_m : run.begin_m - run_in + on_m;
    if (end_m - begin_m > best.end_m - best.begin_m) {
      best.begin_m = begin_m;
      best.end_m = end_m;
    }
  }
  if (best.end_m - best.begin_m < kPathSpacing_m) return std::nullopt;
  best.run_in_m = run_in > 0.0 ? run_in : settling_run_in_m(joining, best);
  return best;
}

WorkLine line_of(const GridJoining& joining, const GridRun& run) {
  WorkLine line = work_line(pass_of(joining.map, run), joining.vehicle.implement.x_B_m);
  add_run_in(line, run.run_in_m);
  return line;
}

Pose begin_of(const GridJoining& joining, const GridRun& run) {
  return pose_of(line_of(joining, run).points.front());
}

Pose end_of(const GridJoining& joining, const GridRun& run) {
  return pose_of(line_of(joining, run).points.back());
}

bool joined(GridJoining& joining, const GridRun& from, const GridRun& to) {
  const Pose end = end_of(joining, from);
  const Pose begin = begin_of(joining, to);
  ConnectionOptions options = joining.connection;
  options.clearance_m = clearance_between(joining.space, end, begin, options.clearance_m);
  if (options.clearance_m < -kFitTolerance_m) return false;
  const int most = std::min({kNodesPerWay, joining.found_nodes, joining.lost_nodes});
  int left = most;
  const bool found = connect(joining.space, end, begin, options, left).has_value();
  (found ? joining.found_nodes : joining.lost_nodes) -= most - left;
  return found;
}

bool draw_back(const GridJoining& joining, GridRun& from, GridRun& to) {
  for (double back_m = kDrawStep_m; back_m <= kDrawnBack_m; back_m += kDrawStep_m) {
    for (const auto& [off_end, off_begin] :
         {std::pair{back_m, 0.0}, std::pair{0.0, back_m}, std::pair{back_m, back_m}}) {
      GridRun shorter = from;
      GridRun later = to;
      shorter.end_m -= off_end;
      later.begin_m += off_begin;
      if (shorter.end_m - shorter.begin_m < kPathSpacing_m) continue;
      if (later.end_m - later.begin_m < kPathSpacing_m) continue;
      if (!turn_joins(joining, shorter, later)) continue;
      from = shorter;
      to = later;
      return true;
    }
  }
  return false;
}

}  // namespace headland
