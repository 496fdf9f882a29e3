#include "sim/driver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/chassis.h"

namespace headland {
namespace {

constexpr double kSearchAhead_m = 1.5;  // how far ahead the nearest place is looked for
constexpr double kStopWithin_m = 0.01;  // of a run's end: brakes are set
constexpr double kCreep_mps = 0.08;     // slowest approach to a stop
constexpr double kStandstill_mps = 0.01;
constexpr double kSteerReady_rad = 0.05;  // steering error at which a run may start
constexpr double kSpeedGain_per_s = 3.0;
constexpr double kSpeedIntegralGain_per_s2 = 1.5;
constexpr double kSpeedIntegralMax_mps2 = 6.0;
constexpr double kCrossTrackIntegralGain_per_s = 0.25;
constexpr double kCrossTrackIntegralMax_m = 0.3;  // offset of the look-ahead point
constexpr double kReferenceLead_mps = 0.3;  // the reference waits for a vehicle that lags by this
constexpr double kSteeringWindow_m = 1.0;   // over which a change of curvature is steered

double kind_speed_mps(const Driver& driver, const PathSegment& segment) {
  double speed_mps = driver.transit_speed_mps;
  if (segment.implement_down) {
    speed_mps = driver.work_speed_mps;
  } else if (segment.kind == PathKind::kTurn || segment.kind == PathKind::kUTurn) {
    speed_mps = driver.turn_speed_mps;
  }
  return segment.gear == Gear::kReverse ? std::min(speed_mps, driver.reverse_speed_mps) : speed_mps;
}

// Slows down where the steering has to turn faster than it can: the change of steer angle over
// kSteeringWindow_m around each point takes that window's time at least.
void limit_speeds_for_steering(Route& route, const std::vector<double>& steer_rad,
                               double rate_rad_per_s) {
  for (const RouteRun& run : route.runs) {
    std::size_t behind = run.first;
    std::size_t ahead = run.first;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const double along_m = route.points[i].along_m;
      while (route.points[behind].along_m < along_m - 0.5 * kSteeringWindow_m) ++behind;
      while (ahead < run.last && route.points[ahead].along_m < along_m + 0.5 * kSteeringWindow_m) {
        ++ahead;
      }
      const double change_rad = std::abs(steer_rad[ahead] - steer_rad[behind]);
      if (change_rad <= 0.0) continue;
      RoutePoint& point = route.points[i];
      point.speed_limit_mps =
          std::min(point.speed_limit_mps, kSteeringWindow_m * rate_rad_per_s / change_rad);
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

// Nearest place on the run ahead of where the driver was.
void advance_along(const Route& route, const RouteRun& run, const Eigen::Vector2d& p_W,
                   DriverState& state) {
  double best_m2 = std::numeric_limits<double>::infinity();
  const double horizon_m = state.along_m + kSearchAhead_m;
  double along_m = state.along_m;
  for (std::size_t i = state.index; i < run.last; ++i) {
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
      state.index = i;
      // Past the run's end the place may lie beyond its last point: that is how an overshoot shows.
      along_m = from.along_m + (i + 1 == run.last ? std::max(t, 0.0) : on_edge) * length_m;
    }
  }
  state.along_m = std::max(state.along_m, along_m);
}

Eigen::Vector2d place_ahead(const Route& route, const RouteRun& run, std::size_t index,
                            double along_m) {
  while (index + 1 < run.last && route.points[index + 1].along_m < along_m) ++index;
  const RoutePoint& from = route.points[index];
  const RoutePoint& to = route.points[index + 1];
  if (along_m <= to.along_m) {
    const double t = (along_m - from.along_m) / (to.along_m - from.along_m);
    return from.p_W + t * (to.p_W - from.p_W);
  }
  // Straight on beyond the end, so that the vehicle arrives with the right heading.
  const double sign = run.gear == Gear::kForward ? 1.0 : -1.0;
  return to.p_W + sign * (along_m - to.along_m) *
                      Eigen::Vector2d(std::cos(to.heading_rad), std::sin(to.heading_rad));
}

double steer_wanted(const Route& route, const RouteRun& run, const Vehicle& vehicle,
                    const DriverView& view, const DriverState& state) {
  const Driver& driver = vehicle.driver;
  const double look_ahead_m =
      driver.look_ahead_m + driver.look_ahead_time_s * std::abs(view.speed_mps);
  const Eigen::Vector2d target =
      place_ahead(route, run, state.index, state.along_m + look_ahead_m) - view.p_W;
  const double c = std::cos(view.yaw_rad);
  const double s = std::sin(view.yaw_rad);
  const double x_m = c * target.x() + s * target.y();
  const double y_m = -s * target.x() + c * target.y() - state.cross_track_integral_m;
  const double limit_rad = vehicle.steering.max_angle_rad;
  const bool behind = run.gear == Gear::kForward ? x_m <= 0.0 : x_m >= 0.0;
  if (behind) return y_m >= 0.0 ? limit_rad : -limit_rad;
  const double curvature_per_m = 2.0 * y_m / (x_m * x_m + y_m * y_m);
  return std::clamp(std::atan(wheelbase_m(vehicle) * curvature_per_m), -limit_rad, limit_rad);
}

double speed_limit(const Route& route, const DriverState& state) {
  const std::size_t i = state.index;
  const RoutePoint& from = route.points[i];
  const RoutePoint& to = route.points[i + 1];
  const double t =
      std::clamp((state.along_m - from.along_m) / (to.along_m - from.along_m), 0.0, 1.0);
  const double square = (1.0 - t) * from.speed_limit_mps * from.speed_limit_mps +
                        t * to.speed_limit_mps * to.speed_limit_mps;
  return std::max(std::sqrt(square), kCreep_mps);
}

// Whether a working segment begins within `distance_m` ahead in this run.
bool work_ahead(const Route& route, const RouteRun& run, const DriverState& state,
                double distance_m) {
  for (std::size_t i = state.index; i < run.last; ++i) {
    if (route.points[i].along_m > state.along_m + distance_m) return false;
    if (route.works[static_cast<std::size_t>(route.points[i].segment)]) return true;
  }
  return false;
}

}  // namespace

Route make_route(const Path& path, const Vehicle& vehicle) {
  Route route;
  std::vector<double> steer_rad;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const PathSegment& segment = path.segments[s];
    route.works.push_back(segment.implement_down);
    const bool new_run = route.runs.empty() || route.runs.back().gear != segment.gear;
    const double speed_mps = kind_speed_mps(vehicle.driver, segment);
    for (std::size_t i = 0; i < segment.points.size(); ++i) {
      const PathPoint& point = segment.points[i];
      RoutePoint stop;
      stop.p_W = point.p_W;
      stop.heading_rad = point.heading_rad;
      stop.segment = static_cast<int>(s);
      stop.speed_limit_mps =
          std::min(speed_mps, std::sqrt(vehicle.driver.max_lateral_acceleration_mps2 /
                                        std::max(std::abs(point.curvature_per_m), 1e-6)));
      const bool joint = i == 0 && !new_run;
      if (!joint && i > 0) {
        const double step_m = (point.p_W - route.points.back().p_W).norm();
        if (step_m <= 0.0) continue;
        stop.along_m = route.points.back().along_m + step_m;
      } else if (!route.points.empty()) {
        stop.along_m = route.points.back().along_m;
      }
      if (joint) {
        RoutePoint& shared = route.points.back();
        shared.segment = stop.segment;
        shared.speed_limit_mps = std::min(shared.speed_limit_mps, stop.speed_limit_mps);
        continue;
      }
      if (i == 0) route.runs.push_back({route.points.size(), route.points.size(), segment.gear});
      route.points.push_back(stop);
      steer_rad.push_back(std::atan(wheelbase_m(vehicle) * point.curvature_per_m));
      route.runs.back().last = route.points.size() - 1;
    }
  }
  std::erase_if(route.runs, [](const RouteRun& run) { return run.last <= run.first; });
  route.length_m = route.points.empty() ? 0.0 : route.points.back().along_m;
  limit_speeds_for_steering(route, steer_rad, vehicle.steering.max_rate_rad_per_s);
  limit_speeds_for_braking(route, vehicle.driver.max_acceleration_mps2);
  route.expected_time_s = expected_time(route);
  return route;
}

DriverCommand drive(const Route& route, const Vehicle& vehicle, const DriverView& view,
                    double mass_kg, double dt_s, DriverState& state) {
  const RouteRun& run = route.runs[state.run];
  state.index = std::max(state.index, run.first);
  advance_along(route, run, view.p_W, state);
  const RoutePoint& place = route.points[state.index];
  const RoutePoint& next = route.points[state.index + 1];

  DriverCommand command;
  command.segment = place.segment;
  const bool works = route.works[static_cast<std::size_t>(place.segment)];
  const double direction = run.gear == Gear::kForward ? 1.0 : -1.0;
  const Eigen::Vector2d tangent = direction * (next.p_W - place.p_W).normalized();
  const Eigen::Vector2d offset = view.p_W - place.p_W;
  state.cross_track_m = tangent.x() * offset.y() - tangent.y() * offset.x();

  // The integral learns a side slope's bias on working rows and is forgotten elsewhere.
  if (works && std::abs(view.speed_mps) > kStandstill_mps) {
    state.cross_track_integral_m = std::clamp(
        state.cross_track_integral_m + kCrossTrackIntegralGain_per_s * dt_s * state.cross_track_m,
        -kCrossTrackIntegralMax_m, kCrossTrackIntegralMax_m);
  } else if (!works) {
    state.cross_track_integral_m = 0.0;
  }

  const double steer_target = steer_wanted(route, run, vehicle, view, state);
  const double steer_step = vehicle.steering.max_rate_rad_per_s * dt_s;
  state.steer_rad += std::clamp(steer_target - state.steer_rad, -steer_step, steer_step);

  const Implement& implement = vehicle.implement;
  const double lift_step = implement.lift_time_s > 0.0 ? dt_s / implement.lift_time_s : 1.0;
  const bool lower =
      works || work_ahead(route, run, state, std::abs(view.speed_mps) * implement.lift_time_s);
  command.lifting = !lower && state.lowered > 0.0;
  state.lowered = std::clamp(state.lowered + (lower ? lift_step : -lift_step), 0.0, 1.0);
  command.working = works && state.lowered >= 1.0;

  const double remaining_m = route.points[run.last].along_m - state.along_m;
  if (remaining_m <= kStopWithin_m) {
    command.hold = true;
    if (std::abs(view.speed_mps) < kStandstill_mps) {
      state.finished = state.run + 1 == route.runs.size();
      if (!state.finished) {
        ++state.run;
        state.index = route.runs[state.run].first;
        state.along_m = route.points[state.index].along_m;
        state.starting = true;
        state.reference_mps = 0.0;
        state.speed_integral_m = 0.0;
      }
    }
    return command;
  }
  if (state.starting) {
    state.starting = std::abs(steer_target - state.steer_rad) > kSteerReady_rad;
    command.hold = state.starting;
    if (command.hold) return command;
  }

  const double speed_mps = direction * view.speed_mps;
  const double before_mps = state.reference_mps;
  state.reference_mps =
      std::min({speed_limit(route, state), before_mps + vehicle.driver.max_acceleration_mps2 * dt_s,
                std::max(speed_mps, 0.0) + kReferenceLead_mps});
  const double error_mps = state.reference_mps - speed_mps;
  const double integral_limit_m = kSpeedIntegralMax_mps2 / kSpeedIntegralGain_per_s2;
  state.speed_integral_m =
      std::clamp(state.speed_integral_m + dt_s * error_mps, -integral_limit_m, integral_limit_m);
  const double ramp_limit_mps2 = 2.0 * vehicle.driver.max_acceleration_mps2;
  const double ramp_mps2 =
      std::clamp((state.reference_mps - before_mps) / dt_s, -ramp_limit_mps2, ramp_limit_mps2);
  const double acceleration_mps2 =
      ramp_mps2 + kSpeedGain_per_s * error_mps + kSpeedIntegralGain_per_s2 * state.speed_integral_m;
  // The grade is known from the pitch sensor: without it the vehicle rolls back when it moves off.
  const double force_n =
      mass_kg * (direction * acceleration_mps2 + kGravity_mps2 * std::sin(view.pitch_rad));
  const double radius_m = vehicle.rear.driven ? vehicle.rear.radius_m : vehicle.front.radius_m;
  command.wheel_torque_nm = force_n * radius_m;
  return command;
}

}  // namespace headland
