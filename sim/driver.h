// The driver: regulated pure pursuit on the rear axle, speed control, implement, gear changes.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "planner/path.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// The path flattened for driving: points of consecutive segments of one gear make a run, which is
// driven from standstill to standstill.
struct RoutePoint {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double along_m = 0.0;          // from the route's start
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

// Speed limits: the driver's speed for the kind and gear, lateral acceleration in curves, the
// steering rate where curvature changes, and the braking distance to what comes.
Route make_route(const Path& path, const Vehicle& vehicle);

struct DriverState {
  std::size_t run = 0;
  std::size_t index = 0;       // route point before the nearest place, never goes back
  double along_m = 0.0;        // of the nearest place
  double cross_track_m = 0.0;  // left of the path positive, seen along the body's x axis
  double steer_rad = 0.0;      // actual, rate-limited
  double reference_mps = 0.0;  // speed asked for, along the gear: ramps up, follows the limit down
  double speed_integral_m = 0.0;
  double cross_track_integral_m = 0.0;
  double lowered = 0.0;  // implement: 0 up, 1 down
  bool starting = true;  // waits at a run's start until the wheels point the right way
  bool finished = false;
};

// Position of the rear-axle centre and motion as the driver's sensors give them.
struct DriverView {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;
  double speed_mps = 0.0;  // along the body's x axis
};

struct DriverCommand {
  double wheel_torque_nm = 0.0;  // all driven wheels together
  bool hold = false;             // brakes set
  int segment = 0;               // of the path, where the vehicle is
  bool working = false;          // implement fully down on a working segment
  bool lifting = false;
};

// Look-ahead and steering by pure pursuit (Coulter 1992) on the rear axle, in either gear: speed
// regulated by curvature and braking distance; the cross-track integral removes the bias of a side
// slope. Steering turns at its rate limit.
DriverCommand drive(const Route& route, const Vehicle& vehicle, const DriverView& view,
                    double mass_kg, double dt_s, DriverState& state);

}  // namespace headland
