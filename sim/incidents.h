// What ends a run before its path does.
#pragma once

#include <optional>
#include <string>

#include "sim/bullet_world.h"
#include "sim/driver.h"
#include "sim/machine.h"
#include "sim/run_record.h"
#include "sim/simulation.h"

namespace headland {

inline constexpr double kRolledOver_rad = 1.0471975511965976;  // 60 deg between body z and up
inline constexpr double kStuckAfter_s = 20.0;                  // without kStuckProgress_m
inline constexpr double kStuckProgress_m = 0.2;
inline constexpr double kAbsurdSpeed_mps = 50.0;
inline constexpr double kTimeFactor = 4.0;  // times the time the path should take, if not given
inline constexpr double kTimeGrace_s = 120.0;

struct Incident {
  Outcome outcome = Outcome::kFinished;
  std::string detail;  // cause and place in words
};

// When progress along the path was last seen, and what has been seen since.
struct ProgressWatch {
  std::size_t run = 0;
  double along_m = -1.0;
  double time_s = 0.0;
  double worst_slip = 0.0;
  bool clipped = false;
};

// The incident of this step, if any, in order of gravity.
std::optional<Incident> find_incident(const SimulationSetup& setup, const Machine& machine,
                                      const StepReport& report, const BulletWorld& world,
                                      const MachineState& state, const DriverState& driver,
                                      const RunRecord& record, double time_s, double max_time_s,
                                      ProgressWatch& watch);

}  // namespace headland
