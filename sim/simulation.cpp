#include "sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/incidents.h"
#include "sim/recorder.h"
#include "sim/stability.h"

namespace headland {
namespace {

constexpr double kSettle_s = 2.0;  // standing braked before the clock starts: tyres find their load

DriverView view_of(const ChassisState& chassis, const ChassisMass& mass) {
  const Eigen::Vector3d angles = yaw_pitch_roll(chassis.R_WB);
  const Eigen::Vector3d x_axis = chassis.R_WB.col(0);
  const Eigen::Vector2d ahead = x_axis.head<2>().normalized();
  const Eigen::Vector3d turning = chassis.omega_W.cross(x_axis);
  const Eigen::Vector3d v_WB =
      point_velocity(chassis.v_W, chassis.omega_W, -(chassis.R_WB * mass.com_B));
  DriverView view;
  view.p_W = origin_of(chassis, mass).head<2>();
  view.yaw_rad = angles.x();
  view.pitch_rad = angles.y();
  view.roll_rad = angles.z();
  view.yaw_rate_rad_per_s =
      (x_axis.x() * turning.y() - x_axis.y() * turning.x()) / x_axis.head<2>().squaredNorm();
  view.speed_mps = chassis.v_W.dot(x_axis);
  view.course_mps = {ahead.x() * v_WB.x() + ahead.y() * v_WB.y(),
                     ahead.x() * v_WB.y() - ahead.y() * v_WB.x()};
  return view;
}

void settle(const Machine& machine, double dt_s, BulletWorld& world, MachineState& state) {
  DriverCommand standing;
  standing.hold = true;
  MachineState resting = state;
  const auto steps = std::lround(kSettle_s / dt_s);
  for (long i = 0; i < steps; ++i) {
    step_machine(machine, standing, {}, 0.0, dt_s, world, resting);
  }
  state.wheels = resting.wheels;
  state.trailer_wheels = resting.trailer_wheels;
}

// Room for what the drive will leave: lists that grow piece by piece keep the room of their older,
// smaller selves.
void make_room(const SimulationOptions& options, const Route& route, double time_s,
               RunRecord& record) {
  constexpr double kSlower = 1.1;  // than at the speed limits
  const double longest_s = std::min(time_s, kSlower * route.expected_time_s);
  record.samples.reserve(static_cast<std::size_t>(longest_s * options.record_hz) + 2);
  record.footprints.reserve(
      static_cast<std::size_t>(kSlower * route.length_m / options.footprint_spacing_m) + 2);
  record.segments.reserve(route.works.size());
}

}  // namespace

RunRecord simulate(const SimulationSetup& setup) {
  const SimulationOptions& options = setup.options;
  require_stable(setup.vehicle, options.rate_hz);
  const double dt_s = 1.0 / options.rate_hz;
  const Machine machine = make_machine(setup.vehicle, setup.terrain, setup.soil);
  const Route route = make_route(setup.path, setup.vehicle);
  Recorder recorder = make_recorder(machine, setup.field, options.rate_hz, options.record_hz,
                                    options.footprint_spacing_m);
  recorder.record.soc_start = options.soc_start;

  BulletWorld world(setup.field, setup.terrain, setup.vehicle);
  const RoutePoint& start = route.points.front();
  stand(machine, start.p_W, start.heading_rad, world);
  MachineState state;
  state.battery.soc = options.soc_start;
  settle(machine, dt_s, world, state);

  const double max_time_s = options.max_time_s > 0.0
                                ? options.max_time_s
                                : kTimeFactor * route.expected_time_s + kTimeGrace_s;
  make_room(options, route, max_time_s, recorder.record);
  const auto steps_per_second = std::lround(options.rate_hz);
  DriverState driver = at_start(route, options.steering_latency_s, options.rate_hz);
  Receiver receiver = make_receiver(options.positioning, options.rate_hz, start.p_W);
  RoutePlace place = driver.place;  // the true one
  DriverCommand command;
  StepReport report;
  ProgressWatch watch;
  while (!driver.finished) {
    const double time_s = static_cast<double>(recorder.step) * dt_s;
    const DriverView truth = view_of(world.state(), machine.mass);
    follow(route, truth.p_W, place);
    DriverView view = truth;
    view.p_W = receive(receiver, truth.p_W);
    view.age_s = options.positioning.latency_s;
    const double steer_before_rad = driver.steer_rad;
    command = drive(route, setup.vehicle, view, total_mass_kg(setup.vehicle), dt_s, driver);
    const Steer steer{driver.steer_rad, (driver.steer_rad - steer_before_rad) / dt_s};
    report = step_machine(machine, command, steer, driver.lowered, dt_s, world, state);
    record_step(recorder, report, state, driver, command, truth,
                cross_track_m(route, place, truth.p_W));
    if (driver.place.run != place.run) place = driver.place;
    const auto incident = find_incident(setup, machine, report, world, state, driver,
                                        recorder.record, time_s, max_time_s, watch);
    if (incident) {
      recorder.record.outcome = incident->outcome;
      recorder.record.outcome_detail = incident->detail;
      break;
    }
    if (setup.progress && recorder.step % steps_per_second == 0 &&
        !setup.progress({time_s, driver.place.along_m / route.length_m})) {
      recorder.record.outcome = Outcome::kInterrupted;
      break;
    }
  }

  finish_record(recorder, report, energy_now(machine, world, state, driver.steer_rad, dt_s), state,
                driver, command);
  return std::move(recorder.record);
}

}  // namespace headland
