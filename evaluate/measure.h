// Measures what manoeuvres cost: drives each in the physics, over seeds of micro-relief.
#pragma once

#include <functional>

#include "evaluate/cost_table.h"
#include "evaluate/energy_formula.h"
#include "terrains/soil.h"

namespace headland {

struct MeasureOptions {
  ManoeuvreRanges ranges;
  MicroRelief micro_relief{0.01, 1.0};
  int repeats = 5;
  std::uint64_t seed = 1;
  double rate_hz = 240.0;
  double formula_mu = 0.25;
  // U I in turns of the paper's formula; 0: as measured driving straight at the work speed with the
  // implement raised, which is what a display in the cab would tell.
  double formula_turn_power_w = 0.0;
  int jobs = 1;  // threads
  // Called with the share that is done, by one thread at a time; false ends the measurement.
  std::function<bool(double done)> progress;
};

// What planning needs: at the work speed alone, twice each.
MeasureOptions planning_measurements(int jobs);

// Empty costs when `progress` ended it. The same options give the same table with any number of
// jobs: every repeat has its own world and its own relief, drawn from seed and repeat. Throws
// InputError when the vehicle cannot even work on the flat of this soil.
CostTable measure_costs(const Vehicle& vehicle, const Soil& soil, const MeasureOptions& options);

}  // namespace headland
