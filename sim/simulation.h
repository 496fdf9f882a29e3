// Drives a path in physics.
#pragma once

#include <cstdint>
#include <functional>

#include "planner/path.h"
#include "sim/positioning.h"
#include "sim/run_record.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "terrains/soil_map.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct SimulationOptions {
  double rate_hz = 240.0;
  double record_hz = 10.0;
  double soc_start = 1.0;
  double max_time_s = 0.0;     // 0: four times the time the path should take
  double max_overrun_m = 5.0;  // the run ends as kLeftField or kEnteredHole beyond
  double footprint_spacing_m = 0.1;
  PositioningOptions positioning;
  double steering_latency_s = 0.0;  // from the driver's decision to the steering's first move
};

struct SimulationProgress {
  double time_s = 0.0;
  double path_fraction = 0.0;  // 0..1
};

// Everything that decides a run. Nothing is owned.
struct SimulationSetup {
  const Field& field;
  const Heightfield& terrain;
  const SoilMap& soil;
  const Vehicle& vehicle;
  const Path& path;
  SimulationOptions options;
  // Called about once per simulated second; returning false ends the run as kInterrupted.
  std::function<bool(const SimulationProgress&)> progress;
};

// Builds a fresh Bullet world, settles the vehicle at the path's first point and drives the path.
// Same setup, same record, bit by bit, whatever else runs in other threads. Throws InputError for a
// path without any motion and for a vehicle that is unstable at the rate (stability.h).
RunRecord simulate(const SimulationSetup& setup);

}  // namespace headland
