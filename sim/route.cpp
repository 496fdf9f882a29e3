#include "sim/route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/arcs.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kPivot_rad = 0.05;     // between headings of a path: turned on the spot
constexpr double kSearchAhead_m = 0.5;  // how far ahead the nearest place is looked for in a step

double kind_speed_mps(const Driver& driver, const PathSegment& segment) {
  double speed_mps = driver.transit_speed_mps;
  if (segment.implement_down) {
    speed_mps = driver.work_speed_mps;
  } else if (segment.kind == PathKind::kTurn || segment.kind == PathKind::kUTurn) {
    speed_mps = driver.turn_speed_mps;
  }
  return segment.gear == Gear::kReverse ? std::min(speed_mps, driver.reverse_speed_mps) : speed_mps;
}

double gear_sign(const RouteRun& run) { return run.gear == Gear::kForward ? 1.0 : -1.0; }

// Appends a segment's points; those at the place of the point before them are left out.
// A vehicle that `pivots` turns on the spot where a segment begins with another heading.
void append(Route& route, const PathSegment& segment, int number, double speed_mps, bool pivots) {
  const bool new_run =
      route.runs.empty() || route.runs.back().gear != segment.gear ||
      (pivots && std::abs(wrap_angle(segment.points.front().heading_rad -
                                     route.points.back().heading_rad)) > kPivot_rad);
  for (std::size_t i = 0; i < segment.points.size(); ++i) {
    const PathPoint& point = segment.points[i];
    RoutePoint stop;
    stop.p_W = point.p_W;
    stop.heading_rad = point.heading_rad;
    stop.segment = number;
    stop.speed_limit_mps = speed_mps;
    if (!route.points.empty()) stop.along_m = route.points.back().along_m;
    if (i == 0 && new_run) {
      route.runs.push_back({route.points.size(), route.points.size(), segment.gear});
      route.points.push_back(stop);
      continue;
    }
    RoutePoint& before = route.points.back();
    if (i == 0) {
      before.segment = number;
      before.speed_limit_mps = std::min(before.speed_limit_mps, speed_mps);
      continue;
    }
    const double step_m = (point.p_W - before.p_W).norm();
    if (step_m <= 0.0) continue;
    stop.along_m += step_m;
    stop.heading_rad = before.heading_rad + wrap_angle(point.heading_rad - before.heading_rad);
    route.points.push_back(stop);
    route.runs.back().last = route.points.size() - 1;
  }
}

// Mean curvature over a window is the change of heading across it: whatever the path's own
// curvature does, following this one ends with the path's heading.
void smooth_curvature(Route& route) {
  for (const RouteRun& run : route.runs) {
    const double start_m = route.points[run.first].along_m;
    const double end_m = route.points[run.last].along_m;
    std::size_t behind = run.first;
    std::size_t ahead = run.first;
    const auto heading_at = [&](double along_m, std::size_t& i) {
      while (i + 1 < run.last && route.points[i + 1].along_m < along_m) ++i;
      const RoutePoint& from = route.points[i];
      const RoutePoint& to = route.points[i + 1];
      const double t = (along_m - from.along_m) / (to.along_m - from.along_m);
      return from.heading_rad + t * (to.heading_rad - from.heading_rad);
    };
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const double along_m = route.points[i].along_m;
      const double from_m = std::max(start_m, along_m - 0.5 * kSteeringWindow_m);
      const double to_m = std::min(end_m, along_m + 0.5 * kSteeringWindow_m);
      const double turned_rad = heading_at(to_m, ahead) - heading_at(from_m, behind);
      route.points[i].curvature_per_m = gear_sign(run) * turned_rad / (to_m - from_m);
    }
  }
}

void limit_speeds_in_curves(Route& route, const Vehicle& vehicle) {
  const double rate_rad_per_s = kSteeringRateShare * vehicle.steering.max_rate_rad_per_s;
  const auto steer_rad = [&](const RoutePoint& point) {
    return steer_for(vehicle, point.curvature_per_m);
  };
  constexpr double kStraight_per_m = 1e-6;
  for (const RouteRun& run : route.runs) {
    for (std::size_t i = run.first; i <= run.last; ++i) {
      RoutePoint& point = route.points[i];
      const double bend_per_m = std::max(std::abs(point.curvature_per_m), kStraight_per_m);
      point.speed_limit_mps =
          std::min(point.speed_limit_mps,
                   std::sqrt(vehicle.driver.max_lateral_acceleration_mps2 / bend_per_m));
      if (vehicle.steering.kind == SteeringKind::kSkid) {
        point.speed_limit_mps =
            std::min(point.speed_limit_mps,
                     kSteeringRateShare * vehicle.steering.max_yaw_rate_rad_per_s / bend_per_m);
      }
      if (i == run.last) continue;
      RoutePoint& next = route.points[i + 1];
      const double change_rad = std::abs(steer_rad(next) - steer_rad(point));
      if (change_rad <= 0.0) continue;
      const double limit_mps = rate_rad_per_s * (next.along_m - point.along_m) / change_rad;
      point.speed_limit_mps = std::min(point.speed_limit_mps, limit_mps);
      next.speed_limit_mps = std::min(next.speed_limit_mps, limit_mps);
    }
  }
}

void limit_speeds_for_braking(Route& route, double deceleration_mps2) {
  for (const RouteRun& run : route.runs) {
    route.points[run.last].speed_limit_mps = 0.0;
    for (std::size_t i = run.last; i > run.first; --i) {
      const RoutePoint& next = route.points[i];
      RoutePoint& point = route.points[i - 1];
      const double reachable = std::sqrt(next.speed_limit_mps * next.speed_limit_mps +
                                         2.0 * deceleration_mps2 * (next.along_m - point.along_m));
      point.speed_limit_mps = std::min(point.speed_limit_mps, reachable);
    }
  }
}

double expected_time(const Route& route) {
  double time_s = 0.0;
  for (const RouteRun& run : route.runs) {
    for (std::size_t i = run.first; i < run.last; ++i) {
      const double speed_mps =
          0.5 * (route.points[i].speed_limit_mps + route.points[i + 1].speed_limit_mps);
      time_s +=
          (route.points[i + 1].along_m - route.points[i].along_m) / std::max(speed_mps, kCreep_mps);
    }
  }
  return time_s;
}

}  // namespace

Route make_route(const Path& path, const Vehicle& vehicle) {
  Route route;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const PathSegment& segment = path.segments[s];
    if (vehicle.implement.trailing && segment.gear == Gear::kReverse) {
      throw InputError("path", fmt::format("segment {}", s), "reverse",
                       "a trailed implement folds up in reverse; plan the path with this vehicle");
    }
    route.works.push_back(segment.implement_down);
    append(route, segment, static_cast<int>(s), kind_speed_mps(vehicle.driver, segment),
           vehicle.steering.kind == SteeringKind::kSkid);
  }
  std::erase_if(route.runs, [](const RouteRun& run) { return run.last <= run.first; });
  if (route.runs.empty()) {
    throw InputError("path", "", "", "nothing to drive: no two points of it are apart");
  }
  route.length_m = route.points.back().along_m;
  smooth_curvature(route);
  limit_speeds_in_curves(route, vehicle);
  limit_speeds_for_braking(route, vehicle.driver.max_acceleration_mps2);
  route.expected_time_s = expected_time(route);
  return route;
}

RoutePlace start_of_run(const Route& route, std::size_t run) {
  const std::size_t first = route.runs[run].first;
  return {run, first, route.points[first].along_m};
}

void follow(const Route& route, const Eigen::Vector2d& p_W, RoutePlace& place) {
  const RouteRun& run = route.runs[place.run];
  const double horizon_m = place.along_m + kSearchAhead_m;
  double best_m2 = std::numeric_limits<double>::infinity();
  double along_m = place.along_m;
  for (std::size_t i = place.index; i < run.last; ++i) {
    const RoutePoint& from = route.points[i];
    const RoutePoint& to = route.points[i + 1];
    if (from.along_m > horizon_m) break;
    const Eigen::Vector2d edge = to.p_W - from.p_W;
    const double length_m = to.along_m - from.along_m;
    const double t = edge.dot(p_W - from.p_W) / (length_m * length_m);
    const double on_edge = std::clamp(t, 0.0, 1.0);
    const double distance_m2 = (p_W - from.p_W - on_edge * edge).squaredNorm();
    if (distance_m2 < best_m2) {
      best_m2 = distance_m2;
      place.index = i;
      along_m = from.along_m + (i + 1 == run.last ? std::max(t, 0.0) : on_edge) * length_m;
    }
  }
  place.along_m = std::max(place.along_m, along_m);
}

RoutePose pose_at(const Route& route, RoutePlace place) {
  const RouteRun& run = route.runs[place.run];
  while (place.index + 1 < run.last && route.points[place.index + 1].along_m < place.along_m) {
    ++place.index;
  }
  const RoutePoint& from = route.points[place.index];
  const RoutePoint& to = route.points[place.index + 1];
  if (place.along_m > to.along_m) {
    return {to.p_W + (place.along_m - to.along_m) * gear_sign(run) * direction_of(to.heading_rad),
            to.heading_rad, to.curvature_per_m};
  }
  const double t = (place.along_m - from.along_m) / (to.along_m - from.along_m);
  return {from.p_W + t * (to.p_W - from.p_W),
          from.heading_rad + t * (to.heading_rad - from.heading_rad),
          from.curvature_per_m + t * (to.curvature_per_m - from.curvature_per_m)};
}

double speed_limit_mps(const Route& route, const RoutePlace& place) {
  const RoutePoint& from = route.points[place.index];
  const RoutePoint& to = route.points[place.index + 1];
  const double t =
      std::clamp((place.along_m - from.along_m) / (to.along_m - from.along_m), 0.0, 1.0);
  const double square = (1.0 - t) * from.speed_limit_mps * from.speed_limit_mps +
                        t * to.speed_limit_mps * to.speed_limit_mps;
  return std::max(std::sqrt(square), kCreep_mps);
}

double cross_track_m(const Route& route, const RoutePlace& place, const Eigen::Vector2d& p_W) {
  const RoutePoint& from = route.points[place.index];
  const RoutePoint& to = route.points[place.index + 1];
  const Eigen::Vector2d tangent =
      gear_sign(route.runs[place.run]) * (to.p_W - from.p_W).normalized();
  const Eigen::Vector2d offset = p_W - from.p_W;
  return tangent.x() * offset.y() - tangent.y() * offset.x();
}

}  // namespace headland
