#include "sim/driver.h"

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"
#include "sim/chassis.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr double kStopWithin_m = 0.01;  // of a run's end: brakes are set
constexpr double kStandstill_mps = 0.01;
constexpr double kSteerReady_rad = 0.05;  // steering error at which a run may start
constexpr double kSpeedGain_per_s = 5.0;
constexpr double kSpeedIntegralGain_per_s2 = 6.25;  // critically damped
constexpr double kSpeedIntegralMax_mps2 = 6.0;
constexpr double kYawGain_per_s = 30.0;
constexpr double kYawIntegralGain_per_s2 = 300.0;
constexpr double kPivotReady_rad = 0.02;     // heading error at which a pivot is done
constexpr double kPivotGain_per_s = 2.0;     // yaw rate per heading error, up to the limit
constexpr double kPivotAuthority = 0.3;      // least share of way along x that leads to the line
constexpr double kLoweringMargin_m = 0.05;   // what the speed loop overshoots on that way, and more
constexpr double kReferenceLead_mps = 0.3;   // the reference waits for a vehicle that lags by this
constexpr double kLeastLateralShare = 0.25;  // of the lateral acceleration, kept on any side slope

bool works_at(const Route& route, std::size_t point) {
  return route.works[static_cast<std::size_t>(route.points[point].segment)];
}

// Whether a working segment begins within `distance_m` ahead in this run.
bool work_ahead(const Route& route, const RoutePlace& place, double distance_m) {
  for (std::size_t i = place.index; i < route.runs[place.run].last; ++i) {
    if (route.points[i].along_m > place.along_m + distance_m) return false;
    if (works_at(route, i)) return true;
  }
  return false;
}

// How far it comes while the implement is lowered if it speeds up as it may here.
double lowering_way_m(const Route& route, const Vehicle& vehicle, const DriverView& view,
                      const RoutePlace& place) {
  const double speed_mps = std::abs(view.speed_mps);
  const double most_mps2 = vehicle.driver.max_acceleration_mps2;
  const double lowering_s = vehicle.implement.lift_time_s;
  const double gain_mps = std::max(0.0, speed_limit_mps(route, place) - speed_mps);
  const double speeding_s = std::min(lowering_s, gain_mps / most_mps2);
  return speed_mps * lowering_s + most_mps2 * speeding_s * (lowering_s - 0.5 * speeding_s) +
         kLoweringMargin_m;
}

// Angle [rad] that a skid-steered vehicle has to turn on the spot before it starts its run; 0 when
// it points the right way.
double heading_to_turn(const Route& route, const Vehicle& vehicle, const DriverView& view,
                       const DriverState& state) {
  if (vehicle.steering.kind != SteeringKind::kSkid) return 0.0;
  const RouteRun& run = route.runs[state.place.run];
  const double to_turn_rad = wrap_angle(route.points[run.first].heading_rad - view.yaw_rad);
  return std::abs(to_turn_rad) > kPivotReady_rad ? to_turn_rad : 0.0;
}

// Speed along x while turning on the spot that ends on the line of the run to come: turning about
// an axle moves the vehicle off it, and so does a slope.
double speed_in_pivot_mps(const Route& route, const Vehicle& vehicle, const DriverView& view,
                          double to_turn_rad, double rate_rad_per_s, const DriverState& state) {
  const RoutePoint& first = route.points[route.runs[state.place.run].first];
  const Eigen::Vector2d across_W = left_of(first.heading_rad);
  const Eigen::Vector2d now_W = direction_of(view.yaw_rad);
  const Eigen::Vector2d turned_W =
      ahead_of_pivot_m(vehicle) * (direction_of(first.heading_rad) - now_W);
  const double off_m = across_W.dot(position_now(view) + turned_W - first.p_W);
  const double per_metre = across_W.dot(now_W);  // of way along x
  if (std::abs(per_metre) < kPivotAuthority) return 0.0;
  const double left_s = std::abs(to_turn_rad / rate_rad_per_s);
  const double most_mps = vehicle.driver.turn_speed_mps;
  return std::clamp(-off_m / (per_metre * left_s), -most_mps, most_mps);
}

void move_implement(const Route& route, const Vehicle& vehicle, const DriverView& view, double dt_s,
                    DriverState& state, DriverCommand& command) {
  const Implement& implement = vehicle.implement;
  const bool works = works_at(route, state.place.index);
  const double lift_step = implement.lift_time_s > 0.0 ? dt_s / implement.lift_time_s : 1.0;
  const bool pivoting = state.starting && heading_to_turn(route, vehicle, view, state) != 0.0;
  const bool lower =
      !pivoting &&
      (works || work_ahead(route, state.place, lowering_way_m(route, vehicle, view, state.place)));
  command.lifting = !lower && state.lowered > 0.0;
  state.lowered = std::clamp(state.lowered + (lower ? lift_step : -lift_step), 0.0, 1.0);
  command.working = works && state.lowered >= 1.0;
}

void enter_next_run(const Route& route, DriverState& state) {
  state.finished = state.place.run + 1 == route.runs.size();
  if (state.finished) return;
  state.place = start_of_run(route, state.place.run + 1);
  state.starting = true;
  state.reference_mps = 0.0;
  state.speed_integral_m = 0.0;
  state.yaw_integral_rad = 0.0;
}

// Speed at which the bend being steered, with the side slope's pull where it adds to it, stays
// within the driver's lateral acceleration.
double bend_speed_mps(const Vehicle& vehicle, const DriverView& view, double steer_rad) {
  const double bend_per_m = curvature_of(vehicle, steer_rad);
  if (bend_per_m == 0.0) return vehicle.driver.transit_speed_mps;
  const double most_mps2 = vehicle.driver.max_lateral_acceleration_mps2;
  const double pull_mps2 = kGravity_mps2 * std::sin(std::copysign(1.0, bend_per_m) * view.roll_rad);
  return std::sqrt(std::clamp(most_mps2 - pull_mps2, kLeastLateralShare * most_mps2, most_mps2) /
                   std::abs(bend_per_m));
}

double wheel_torque(const Route& route, const Vehicle& vehicle, const DriverView& view,
                    double mass_kg, double dt_s, DriverState& state) {
  const Driver& driver = vehicle.driver;
  const double direction = route.runs[state.place.run].gear == Gear::kForward ? 1.0 : -1.0;
  const double speed_mps = direction * view.speed_mps;
  const double before_mps = state.reference_mps;
  state.reference_mps =
      std::min({speed_limit_mps(route, state.place), bend_speed_mps(vehicle, view, state.steer_rad),
                before_mps + driver.max_acceleration_mps2 * dt_s,
                std::max(speed_mps, 0.0) + kReferenceLead_mps});
  const double error_mps = state.reference_mps - speed_mps;
  const double integral_limit_m = kSpeedIntegralMax_mps2 / kSpeedIntegralGain_per_s2;
  state.speed_integral_m =
      std::clamp(state.speed_integral_m + dt_s * error_mps, -integral_limit_m, integral_limit_m);
  const double ramp_limit_mps2 = 2.0 * driver.max_acceleration_mps2;
  const double ramp_mps2 =
      std::clamp((state.reference_mps - before_mps) / dt_s, -ramp_limit_mps2, ramp_limit_mps2);
  const double acceleration_mps2 =
      ramp_mps2 + kSpeedGain_per_s * error_mps + kSpeedIntegralGain_per_s2 * state.speed_integral_m;
  // The grade is known from the pitch sensor: without it the vehicle rolls back when it moves off.
  const double force_n =
      mass_kg * (direction * acceleration_mps2 + kGravity_mps2 * std::sin(view.pitch_rad));
  return force_n * (vehicle.rear.driven ? vehicle.rear.radius_m : vehicle.front.radius_m);
}

// Couple [N m] that brings a skid-steered vehicle to a yaw rate against the scrub of its wheels,
// which the integral finds.
double yaw_torque(const Vehicle& vehicle, const DriverView& view, double wanted_rad_per_s,
                  double dt_s, DriverState& state) {
  const double error_rad_per_s = wanted_rad_per_s - view.yaw_rate_rad_per_s;
  const double inertia_kg_m2 = vehicle.body.inertia_kg_m2.z();
  // No couple beyond what wheels of full grip could give.
  const double most_nm = 0.5 * kGravity_mps2 * total_mass_kg(vehicle) * vehicle.rear.track_m;
  const double limit_rad = most_nm / (inertia_kg_m2 * kYawIntegralGain_per_s2);
  state.yaw_integral_rad =
      std::clamp(state.yaw_integral_rad + dt_s * error_rad_per_s, -limit_rad, limit_rad);
  return std::clamp(inertia_kg_m2 * (kYawGain_per_s * error_rad_per_s +
                                     kYawIntegralGain_per_s2 * state.yaw_integral_rad),
                    -most_nm, most_nm);
}

}  // namespace

DriverState at_start(const Route& route, double steering_latency_s, double rate_hz) {
  DriverState state;
  state.steering_latency_s = steering_latency_s;
  state.steer_asked_rad = make_delay_line(steering_latency_s, rate_hz, 0.0);
  state.place = start_of_run(route, 0);
  return state;
}

DriverCommand drive(const Route& route, const Vehicle& vehicle, const DriverView& view,
                    double mass_kg, double dt_s, DriverState& state) {
  follow(route, position_now(view), state.place);
  learn_bias(vehicle, view, state.steer_rad, dt_s, state.bias);
  const double preview_m = state.steering_latency_s * std::abs(view.speed_mps);
  const double wanted_rad = steer_along(route, state.place, vehicle, view, state.bias, preview_m);
  const double arriving_rad = state.steer_asked_rad.pass(wanted_rad);
  const double steer_step = vehicle.steering.max_rate_rad_per_s * dt_s;
  state.steer_rad += std::clamp(arriving_rad - state.steer_rad, -steer_step, steer_step);

  DriverCommand command;
  command.segment = route.points[state.place.index].segment;
  move_implement(route, vehicle, view, dt_s, state, command);

  const RouteRun& run = route.runs[state.place.run];
  if (route.points[run.last].along_m - state.place.along_m <= kStopWithin_m) {
    command.hold = true;
    if (std::abs(view.speed_mps) < kStandstill_mps) enter_next_run(route, state);
    return command;
  }
  if (state.starting) {
    const double to_turn_rad = heading_to_turn(route, vehicle, view, state);
    if (to_turn_rad != 0.0) {
      const double most_rad_per_s = vehicle.steering.max_yaw_rate_rad_per_s;
      const double rate_rad_per_s =
          std::clamp(kPivotGain_per_s * to_turn_rad, -most_rad_per_s, most_rad_per_s);
      command.yaw_torque_nm = yaw_torque(vehicle, view, rate_rad_per_s, dt_s, state);
      const double speed_mps =
          speed_in_pivot_mps(route, vehicle, view, to_turn_rad, rate_rad_per_s, state);
      command.wheel_torque_nm = mass_kg * vehicle.rear.radius_m *
                                (kGravity_mps2 * std::sin(view.pitch_rad) +
                                 kSpeedGain_per_s * (speed_mps - view.speed_mps));
      return command;
    }
    const bool lowering = works_at(route, state.place.index) && state.lowered < 1.0;
    state.yaw_integral_rad = 0.0;
    state.starting = lowering || std::abs(wanted_rad - state.steer_rad) > kSteerReady_rad;
    command.hold = state.starting;
    if (command.hold) return command;
  }
  command.direction = run.gear == Gear::kForward ? 1.0 : -1.0;
  command.wheel_torque_nm = wheel_torque(route, vehicle, view, mass_kg, dt_s, state);
  if (vehicle.steering.kind == SteeringKind::kSkid) {
    const double rate_rad_per_s = view.speed_mps * curvature_of(vehicle, state.steer_rad);
    command.yaw_torque_nm = yaw_torque(vehicle, view, rate_rad_per_s, dt_s, state);
  }
  return command;
}

}  // namespace headland
