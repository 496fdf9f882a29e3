#include "sim/simulation.h"

#include <cmath>
#include <utility>

#include "sim/incidents.h"
#include "sim/recorder.h"

namespace headland {
namespace {

constexpr double kSettle_s = 2.0;  // standing braked before the clock starts: tyres find their load

DriverView view_of(const ChassisState& chassis, const ChassisMass& mass) {
  const Eigen::Vector3d angles = yaw_pitch_roll(chassis.R_WB);
  return {origin_of(chassis, mass).head<2>(), angles.x(), angles.y(),
          chassis.v_W.dot(chassis.R_WB.col(0))};
}

void settle(const Machine& machine, double dt_s, BulletWorld& world, MachineState& state) {
  DriverCommand standing;
  standing.hold = true;
  MachineState resting = state;
  const auto steps = std::lround(kSettle_s / dt_s);
  for (long i = 0; i < steps; ++i) {
    step_machine(machine, standing, 0.0, 0.0, dt_s, world, resting);
  }
  state.wheels = resting.wheels;
}

}  // namespace

RunRecord simulate(const SimulationSetup& setup) {
  const SimulationOptions& options = setup.options;
  const double dt_s = 1.0 / options.rate_hz;
  const Machine machine = make_machine(setup.vehicle, setup.terrain, setup.soil);
  const Route route = make_route(setup.path, setup.vehicle);
  Recorder recorder = make_recorder(machine, setup.field, options.rate_hz, options.record_hz,
                                    options.footprint_spacing_m);
  recorder.record.soc_start = options.soc_start;
  if (route.runs.empty()) return std::move(recorder.record);

  BulletWorld world(setup.field, setup.terrain, setup.vehicle);
  const RoutePoint& start = route.points.front();
  world.set_state(place_on_ground(machine, start.p_W, start.heading_rad));
  MachineState state;
  state.battery.soc = options.soc_start;
  settle(machine, dt_s, world, state);

  const double max_time_s = options.max_time_s > 0.0
                                ? options.max_time_s
                                : kTimeFactor * route.expected_time_s + kTimeGrace_s;
  const auto steps_per_second = std::lround(options.rate_hz);
  DriverState driver;
  DriverCommand command;
  StepReport report;
  ProgressWatch watch;
  while (!driver.finished) {
    const double time_s = static_cast<double>(recorder.step) * dt_s;
    const DriverView view = view_of(world.state(), machine.mass);
    command = drive(route, setup.vehicle, view, machine.mass.mass_kg, dt_s, driver);
    report = step_machine(machine, command, driver.steer_rad, driver.lowered, dt_s, world, state);
    record_step(recorder, report, state, driver, command);
    const auto incident = find_incident(setup, machine, report, world, state, driver,
                                        recorder.record, time_s, max_time_s, watch);
    if (incident) {
      recorder.record.outcome = incident->outcome;
      recorder.record.outcome_detail = incident->detail;
      break;
    }
    if (setup.progress && recorder.step % steps_per_second == 0 &&
        !setup.progress({time_s, driver.along_m / route.length_m})) {
      recorder.record.outcome = Outcome::kInterrupted;
      break;
    }
  }

  const ChassisState chassis = world.state();
  const auto contacts = touch_ground(setup.terrain, chassis, machine.wheels, driver.steer_rad,
                                     wheelbase_m(setup.vehicle));
  finish_record(recorder, report,
                stored_energy(machine.mass, chassis, machine.wheels, state.wheels, contacts), state,
                driver, command);
  return std::move(recorder.record);
}

}  // namespace headland
