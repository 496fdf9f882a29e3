// The driver: steering, speed control, implement and gear changes along a route.
#pragma once

#include "sim/delay_line.h"
#include "sim/pursuit.h"
#include "sim/route.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct DriverState {
  RoutePlace place;
  SteeringBias bias;
  double steer_rad = 0.0;             // actual, rate-limited
  DelayLine<double> steer_asked_rad;  // on its way to the steering
  double steering_latency_s = 0.0;
  double reference_mps = 0.0;  // speed asked for, along the gear: ramps up, follows the limit down
  double speed_integral_m = 0.0;
  double yaw_integral_rad = 0.0;  // of a skid-steered vehicle
  double lowered = 0.0;           // implement: 0 up, 1 down
  bool starting = true;  // stands at a run's start until wheels, heading and implement are ready
  bool finished = false;
};

struct DriverCommand {
  double wheel_torque_nm = 0.0;  // all driven wheels together
  double yaw_torque_nm = 0.0;    // couple about z, of a vehicle that steers by its wheels' speeds
  bool hold = false;             // brakes set
  double direction = 0.0;        // of travel that is meant: 1, -1 (reverse), 0 on the spot
  int segment = 0;               // of the path, where the vehicle is
  bool working = false;          // implement fully down on a working segment
  bool lifting = false;
};

// At the route's start, with a steering that answers `steering_latency_s` late. The driver knows
// its latencies and looks ahead for them.
DriverState at_start(const Route& route, double steering_latency_s, double rate_hz);

// One step of the driver. Speed is regulated by the route's limits and, where the vehicle is, by
// the lateral acceleration of its actual steering angle together with the side slope's pull.
// Steering turns at its rate limit towards `steer_along`; a skid-steered vehicle is turned by a
// couple that holds the yaw rate of the same angle. Where a run starts it waits for its wheels to
// point the right way and for the implement to be down if it works there; where the path turns on
// the spot, a skid-steered vehicle pivots first, implement raised.
DriverCommand drive(const Route& route, const Vehicle& vehicle, const DriverView& view,
                    double mass_kg, double dt_s, DriverState& state);

}  // namespace headland
