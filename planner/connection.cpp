#include "planner/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/hybrid_a_star.h"
#include "planner/turns.h"

namespace headland {
namespace {

// Nodes that one route may take: enough to go around the holes of a field of tens of hectares.
constexpr int kMaxNodesPerRoute = 20000;
// A connection keeps this much less than an end that gives way, for its own rounding [m].
constexpr double kSame_m = 1e-4;

// Calls visit(pose) at most kLookSpacing_m apart, from start to end, until it returns false;
// visit may ask to skip ahead by returning how far [m] it wants to.
template <typename Visit>  // double(const Pose&), negative to stop
bool walk(const Pose& from, const std::vector<Arc>& arcs, Visit visit) {
  Pose start = from;
  double skip_m = visit(start);
  if (skip_m < 0.0) return false;
  for (const Arc& arc : arcs) {
    const int steps = std::max(1, static_cast<int>(std::ceil(arc.length_m / kLookSpacing_m)));
    const double step_m = arc.length_m / steps;
    for (int i = 1; i <= steps; ++i) {
      skip_m -= step_m;
      if (skip_m > 0.0) continue;
      skip_m = visit(pose_along(start, arc, i * step_m));
      if (skip_m < 0.0) return false;
    }
    start = pose_along(start, arc, arc.length_m);
  }
  return visit(start) >= 0.0;
}

void deepen(Overrun& worst, const Overrun& other) {
  if (other.depth_m > worst.depth_m) worst = other;
}

}  // namespace

double clearance_between(const FreeSpace& space, const Pose& from, const Pose& to,
                         double clearance_m) {
  double kept_m = clearance_m;
  for (const Pose& end : {from, to}) {
    if (!fits(space, end, kept_m)) kept_m = headland::clearance_m(space, end, kept_m) - kSame_m;
  }
  return kept_m;
}

bool fits_along(const FreeSpace& space, const Pose& from, const std::vector<Arc>& arcs,
                double clearance_m) {
  return walk(from, arcs, [&](const Pose& pose) {
    const double safe_m = safe_distance_m(space, pose) - clearance_m;
    if (safe_m > 0.0) return safe_m;
    return fits(space, pose, clearance_m) ? 0.0 : -1.0;
  });
}

Overrun worst_overrun(const FreeSpace& space, const Pose& from, const std::vector<Arc>& arcs) {
  Overrun worst;
  walk(from, arcs, [&](const Pose& pose) {
    deepen(worst, overrun(space, pose));
    return 0.0;
  });
  return worst;
}

Overrun worst_overrun(const FreeSpace& space, const std::vector<PathPoint>& points) {
  Overrun worst;
  for (const PathPoint& point : points) {
    deepen(worst, overrun(space, {point.p_W, point.heading_rad}));
  }
  return worst;
}

std::optional<std::vector<Arc>> connect_by_turn(const FreeSpace& space, const Pose& from,
                                                const Pose& to, const ConnectionOptions& options) {
  const double clearance_m = options.clearance_m;
  if (!fits(space, from, clearance_m) || !fits(space, to, clearance_m)) return std::nullopt;
  // Run-outs only lengthen a turn, so they are looked at when the cheapest without does not fit.
  auto direct = turns(from, to, options.radius_m, space.hull.gears);
  if (!direct.empty() && fits_along(space, from, direct.front().arcs, clearance_m)) {
    return std::move(direct.front().arcs);
  }
  for (Turn& turn : turns_with_run_outs(from, to, options.radius_m, space.hull.gears)) {
    if (fits_along(space, from, turn.arcs, clearance_m)) return std::move(turn.arcs);
  }
  return std::nullopt;
}

std::optional<std::vector<Arc>> connect(const FreeSpace& space, const Pose& from, const Pose& to,
                                        const ConnectionOptions& options, int& node_budget) {
  if (auto arcs = connect_by_turn(space, from, to, options)) return arcs;
  if (!fits(space, from, options.clearance_m) || !fits(space, to, options.clearance_m)) {
    return std::nullopt;
  }
  RouteOptions route;
  route.radius_m = options.radius_m;
  route.clearance_m = options.clearance_m;
  route.max_nodes = std::min(node_budget, kMaxNodesPerRoute);
  route.cancelled = options.cancelled;
  int expanded = 0;
  auto arcs = find_route(space, from, to, route, &expanded);
  node_budget -= expanded;
  return arcs;
}

std::vector<Arc> connect_overrunning(const FreeSpace& space, const Pose& from, const Pose& to,
                                     double radius_m) {
  std::vector<Arc> best;
  double best_m = std::numeric_limits<double>::max();
  for (Turn& turn : turns(from, to, radius_m, space.hull.gears)) {
    if (turn.cost_m >= best_m) break;  // cheapest first, and an overrun only adds
    const double depth_m = worst_overrun(space, from, turn.arcs).depth_m;
    const double total_m = turn.cost_m + kOverrunMetreCost * depth_m;
    if (total_m < best_m) {
      best_m = total_m;
      best = std::move(turn.arcs);
    }
  }
  return best;
}

double least_depth_m(const FreeSpace& space, const Pose& from, const Pose& to, double radius_m,
                     const Eigen::Vector2d& p_W, const Eigen::Vector2d& outward) {
  double least_m = std::numeric_limits<double>::max();
  for (const Turn& turn : turns(from, to, radius_m, space.hull.gears)) {
    double depth_m = 0.0;
    walk(from, turn.arcs, [&](const Pose& pose) {
      depth_m = std::max(depth_m, outward.dot(pose.p_W - p_W) +
                                      reach_along_m(space.hull, pose.heading_rad, outward));
      return 0.0;
    });
    least_m = std::min(least_m, depth_m);
  }
  return least_m;
}

}  // namespace headland
