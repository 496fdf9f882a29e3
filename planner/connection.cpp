#include "planner/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "planner/continuous_turns.h"
#include "planner/hybrid_a_star.h"
#include "planner/long_route.h"
#include "planner/turns.h"
#include "planner/way_to_room.h"

namespace headland {
namespace {

// Nodes that one route may take: enough to go around the holes of a field of tens of hectares.
constexpr int kMaxNodesPerRoute = 20000;
// A connection keeps this much less than an end that gives way, for its own rounding [m].
constexpr double kSame_m = 1e-4;

// Gaps wider than this [m] are not measured: it takes longer than the steps that it saves.
constexpr double kLookAhead_m = 0.5;

int steps_of(const Arc& arc) {
  return std::max(1, static_cast<int>(std::ceil(arc.length_m / kLookSpacing_m)));
}

// Calls visit(pose) at most kLookSpacing_m apart, from start to end, until it returns false;
// visit may ask to skip ahead by returning how far [m] it wants to.
template <typename Visit>  // double(const Pose&), negative to stop
bool walk(const Pose& from, const std::vector<Arc>& arcs, Visit visit) {
  Pose start = from;
  double skip_m = visit(start);
  if (skip_m < 0.0) return false;
  for (const Arc& arc : arcs) {
    const int steps = steps_of(arc);
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

// The side of a pose that is further from what is nearest, +1 for the left.
double roomier_side(const FreeSpace& space, const Pose& pose) {
  const auto room_m = [&](double side) {
    const Eigen::Vector2d p_W =
        pose.p_W + side * space.hull.half_width_m * left_of(pose.heading_rad);
    double least_m = nearest_edge(space, p_W).distance_m;
    for (const Obstacle& obstacle : space.obstacles) {
      least_m = std::min(least_m, obstacle_gap_m(obstacle, p_W));
    }
    return least_m;
  };
  return room_m(1.0) >= room_m(-1.0) ? 1.0 : -1.0;
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
  double bend_per_m = 0.0;
  for (const Arc& arc : arcs) {
    bend_per_m =
        std::max({bend_per_m, std::abs(arc.curvature_per_m), std::abs(end_curvature_per_m(arc))});
  }
  // What does not fit mostly shows at the joints and in the middles, before every place is looked
  // at.
  Pose start = from;
  for (const Arc& arc : arcs) {
    const int steps = steps_of(arc);
    for (const int i : {steps / 2, steps}) {
      if (!fits(space, pose_along(start, arc, i * (arc.length_m / steps)), clearance_m))
        return false;
    }
    start = pose_along(start, arc, arc.length_m);
  }
  // No point of the hull moves further than this for a metre along the arcs.
  const double swing = 1.0 + bend_per_m * space.reach_with_bar_m;
  return walk(from, arcs, [&](const Pose& pose) {
    if (space.worked != nullptr) return fits(space, pose, clearance_m) ? 0.0 : -1.0;
    const double safe_m = safe_distance_m(space, pose) - clearance_m;
    if (safe_m > kLookAhead_m) return safe_m;
    const double free_m = spare_m(space, pose, clearance_m, kLookAhead_m);
    return free_m < 0.0 ? -1.0 : std::max(safe_m, free_m / swing);
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

namespace {

// So many of the cheapest turns are tried with continuous curvature, each a search for its lengths.
constexpr int kMostContinuous = 60;

// The cheapest of the turns that fits with continuous curvature; words of `found` are of a radius
// `tightened` times that of the vehicle. Its arcs alone are shorter, so that what costs more than
// the best so far is not looked at.
void improve(const FreeSpace& space, const Pose& from, const Pose& to,
             const ConnectionOptions& options, const std::vector<Turn>& found, double tightened,
             std::optional<Turn>& best) {
  int tried = 0;
  for (const Turn& word : found) {
    const double enough_m = best ? best->cost_m : options.most_m;
    if (word.cost_m / tightened >= enough_m || ++tried > kMostContinuous) break;
    auto turn = continuous_turn(from, to, word.arcs, options.sharpness_per_m2, tightened);
    if (!turn || turn->cost_m >= enough_m) continue;
    if (fits_along(space, from, turn->arcs, options.clearance_m)) best = std::move(turn);
  }
}

std::optional<std::vector<Arc>> connect_continuously(const FreeSpace& space, const Pose& from,
                                                     const Pose& to,
                                                     const ConnectionOptions& options) {
  const double radius_m = options.radius_m;
  const Gears gears = space.hull.gears;
  const double wide_m = ramped_radius_m(radius_m, options.sharpness_per_m2);
  const double tightened = wide_m / radius_m;
  std::optional<Turn> best;
  improve(space, from, to, options, turns(from, to, wide_m, gears), tightened, best);
  improve(space, from, to, options, turns(from, to, radius_m, gears), 1.0, best);
  if (best) return std::move(best->arcs);
  improve(space, from, to, options, turns_with_run_outs(from, to, wide_m, gears), tightened, best);
  if (best) return std::move(best->arcs);
  if (gears == Gears::kForwardOnly) return std::nullopt;
  const Aside aside{roomier_side(space, from), roomier_side(space, to)};
  improve(space, from, to, options, backing_turns(from, to, wide_m, aside), tightened, best);
  if (best) return std::move(best->arcs);
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Arc>> connect_by_turn(const FreeSpace& space, const Pose& from,
                                                const Pose& to, const ConnectionOptions& options) {
  const double clearance_m = options.clearance_m;
  if (!fits(space, from, clearance_m) || !fits(space, to, clearance_m)) return std::nullopt;
  if (options.sharpness_per_m2 > 0.0) return connect_continuously(space, from, to, options);
  const auto cheapest_fitting = [&](std::vector<Turn> found) -> std::optional<std::vector<Arc>> {
    for (Turn& turn : found) {
      if (turn.cost_m >= options.most_m) break;
      if (fits_along(space, from, turn.arcs, clearance_m)) return std::move(turn.arcs);
    }
    return std::nullopt;
  };
  // Run-outs only lengthen a turn, so they are looked at when the cheapest without does not fit.
  auto direct = turns(from, to, options.radius_m, space.hull.gears);
  if (direct.size() > 1) direct.resize(1);
  if (auto arcs = cheapest_fitting(std::move(direct))) return arcs;
  if (auto arcs =
          cheapest_fitting(turns_with_run_outs(from, to, options.radius_m, space.hull.gears))) {
    return arcs;
  }
  if (space.hull.gears == Gears::kForwardOnly) return std::nullopt;
  const Aside aside{roomier_side(space, from), roomier_side(space, to)};
  return cheapest_fitting(backing_turns(from, to, options.radius_m, aside));
}

std::optional<std::vector<Arc>> connect(const FreeSpace& space, const Pose& from, const Pose& to,
                                        const ConnectionOptions& asked_for, int& node_budget) {
  if (auto arcs = connect_by_turn(space, from, to, asked_for)) return arcs;
  ConnectionOptions options = asked_for;
  if (options.sharpness_per_m2 > 0.0) {
    options.sharpness_per_m2 = 0.0;
    if (auto arcs = connect_by_turn(space, from, to, options)) return arcs;
  }
  if (!fits(space, from, options.clearance_m) || !fits(space, to, options.clearance_m)) {
    return std::nullopt;
  }
  // Where an end has no room to turn, the way is looked for from where there is some.
  const double clearance_m = options.clearance_m;
  const auto out = way_to_room(space, from, options.radius_m, clearance_m);
  const auto away = way_to_room(space, to, options.radius_m, clearance_m);
  std::vector<Arc> first = out.value_or(std::vector<Arc>{});
  const std::vector<Arc> last = driven_back(away.value_or(std::vector<Arc>{}));
  const Pose roomy_from = end_of(from, first);
  const Pose roomy_to = end_of(to, away.value_or(std::vector<Arc>{}));
  const bool tight = !first.empty() || !last.empty();
  auto between = tight ? connect_by_turn(space, roomy_from, roomy_to, options) : std::nullopt;
  if (between && has_odd_run(*between, false)) between.reset();
  if (!between) {
    RouteOptions route;
    route.radius_m = options.radius_m;
    route.clearance_m = clearance_m;
    route.max_nodes = std::min(node_budget, kMaxNodesPerRoute);
    route.cancelled = options.cancelled;
    int expanded = 0;
    if ((roomy_to.p_W - roomy_from.p_W).norm() > kLongRoute * options.radius_m) {
      between = find_long_route(space, roomy_from, roomy_to, route, &expanded);
      if (between && has_odd_run(*between, false)) between.reset();
      node_budget -= expanded;
      route.max_nodes = std::min(node_budget, kMaxNodesPerRoute);
    }
    if (!between) {
      between = find_route(space, roomy_from, roomy_to, route, &expanded);
      node_budget -= expanded;
    }
  }
  if (!between) return std::nullopt;
  first.insert(first.end(), between->begin(), between->end());
  first.insert(first.end(), last.begin(), last.end());
  return first;
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

std::vector<Pose> poses_near(const FreeSpace& space, const Eigen::Vector2d& p_W,
                             double clearance_m) {
  constexpr double kMostShift_m = 25.0;
  constexpr double kRing_m = 0.5;
  constexpr int kHeadings = 24;
  constexpr int kPlaces = 16;  // on each ring
  std::vector<Pose> poses;
  for (double ring_m = 0.0; ring_m <= kMostShift_m && poses.empty(); ring_m += kRing_m) {
    const int places = ring_m == 0.0 ? 1 : kPlaces;
    for (int place = 0; place < places; ++place) {
      const Eigen::Vector2d at_W =
          p_W + ring_m * direction_of(2.0 * std::numbers::pi * place / places);
      for (int i = 0; i < kHeadings; ++i) {
        const Pose pose{at_W, wrap_angle(2.0 * std::numbers::pi * i / kHeadings)};
        if (fits(space, pose, clearance_m)) poses.push_back(pose);
      }
    }
  }
  return poses;
}

TightestPlace tightest_place(const FreeSpace& space, const Path& path, double asked_m) {
  TightestPlace tightest;
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      const double kept_m = clearance_m(space, pose_of(point), asked_m);
      if (kept_m < asked_m - kFitTolerance_m && kept_m < tightest.clearance_m) {
        tightest = {kept_m, point.p_W};
      }
    }
  }
  return tightest;
}

}  // namespace headland
