// The path flattened for driving: places along it, feed-forward curvature, speed limits.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "planner/path.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Points of consecutive segments of one gear make a run, which is driven from standstill to
// standstill. For a skid-steered vehicle a jump of the heading between segments, where it turns on
// the spot, also begins one.
struct RoutePoint {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;      // of the body's x axis, without jumps within a run
  double along_m = 0.0;          // from the route's start
  double curvature_per_m = 0.0;  // to steer there: mean of the path's over kSteeringWindow_m
  double speed_limit_mps = 0.0;  // see make_route; 0 at run ends
  int segment = 0;               // that leaves this point
};

struct RouteRun {
  std::size_t first = 0;  // indices into Route::points
  std::size_t last = 0;
  Gear gear = Gear::kForward;
};

struct Route {
  std::vector<RoutePoint> points;
  std::vector<RouteRun> runs;
  std::vector<bool> works;  // implement down, per segment
  double length_m = 0.0;
  double expected_time_s = 0.0;  // at the speed limits
};

// Steps of curvature between lines and arcs cannot be steered at any speed. The curvature to steer
// is therefore the path's mean over this length around a place: ramps, centred on the steps, that
// leave the path by kSteeringWindow_m^2 / 24 times the step (2 cm for a step to 2 m radius) and
// come back to it with its heading.
inline constexpr double kSteeringWindow_m = 1.0;

// Share of the steering rate that following the path may take; the rest is for corrections.
inline constexpr double kSteeringRateShare = 0.8;

// Slowest approach to a stop [m/s].
inline constexpr double kCreep_mps = 0.08;

// Speed limits: the driver's speed for the kind and gear, lateral acceleration in curves, the
// steering rate where curvature changes, and the braking distance to what comes. Throws InputError
// for a path without any motion, and for reverse gear with a trailed implement.
Route make_route(const Path& path, const Vehicle& vehicle);

// A place on a route: past the point `index`, on the edge that leaves it.
struct RoutePlace {
  std::size_t run = 0;
  std::size_t index = 0;
  double along_m = 0.0;
};

RoutePlace start_of_run(const Route& route, std::size_t run);

// Moves a place on to the nearest one to `p_W` within the next metres of its run, never back. Past
// the run's end it lies beyond the last point: that is how an overshoot shows.
void follow(const Route& route, const Eigen::Vector2d& p_W, RoutePlace& place);

// The route at a place, interpolated between its points; beyond a run's end straight on, so that
// the vehicle arrives with the right heading.
struct RoutePose {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double curvature_per_m = 0.0;
};
RoutePose pose_at(const Route& route, RoutePlace place);

double speed_limit_mps(const Route& route, const RoutePlace& place);

// Distance of `p_W` from the route at a place, left of it positive as seen along the body's x axis.
double cross_track_m(const Route& route, const RoutePlace& place, const Eigen::Vector2d& p_W);

}  // namespace headland
