// Turns steps into the run record: samples, footprints, totals per segment, peaks.
#pragma once

#include <vector>

#include "planner/free_space.h"
#include "sim/driver.h"
#include "sim/machine.h"
#include "sim/run_record.h"
#include "terrains/field.h"

namespace headland {

// Mean over a sliding window of kSustained_s, in constant time per step.
struct SlidingMean {
  std::vector<double> values;
  std::size_t next = 0;
  std::size_t filled = 0;
  double sum = 0.0;

  // Mean over the window once it has filled, otherwise 0.
  double add(double value);
};

struct Recorder {
  const Machine& machine;
  const Field& field;
  FreeSpace space{};  // of the field, for the vehicle's hull
  double dt_s = 0.0;
  int sample_every = 1;  // steps
  double footprint_spacing_m = 0.1;

  RunRecord record{};
  long step = 0;
  double travel_m = 0.0;
  double next_hull_check_m = 0.0;
  double last_footprint_m = 0.0;
  bool strip_open = false;
  bool belly_down = false;
  double cross_track_m = 0.0;  // of the step recorded last
  StoredEnergy stored_before{};
  SlidingMean slip{};
  SlidingMean load_transfer{};
  SlidingMean trailer_load_transfer{};
};

Recorder make_recorder(const Machine& machine, const Field& field, double rate_hz, double record_hz,
                       double footprint_spacing_m);

// Adds one step. `driver` and `command` are those that the step was driven with; `truth` is how the
// vehicle stood before it and `cross_track_m` its distance from the path, whatever the driver
// believes.
void record_step(Recorder& recorder, const StepReport& report, const MachineState& state,
                 const DriverState& driver, const DriverCommand& command, const DriverView& truth,
                 double cross_track_m);

// Closes totals and ledger with the stores as they are at the end, after the step `report`; the
// record's last sample is of that step.
void finish_record(Recorder& recorder, const StepReport& report, const StoredEnergy& stored,
                   const MachineState& state, const DriverState& driver,
                   const DriverCommand& command);

}  // namespace headland
