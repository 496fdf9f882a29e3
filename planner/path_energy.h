// What a path will take, told from measured costs instead of driving it.
#pragma once

#include <array>

#include "planner/drive_cost.h"
#include "planner/path.h"
#include "terrains/heightfield.h"

namespace headland {

inline constexpr std::size_t kPredictedKinds = 5;

struct PredictedEnergy {
  double energy_wh = 0.0;
  std::array<double, kPredictedKinds> by_kind_wh{};  // by PathKind
  // What it is made of, whose costs it is linear in.
  double working_m = 0.0;
  double raised_m = 0.0;
  double working_quarters = 0.0;  // of circles, in bends
  double raised_quarters = 0.0;
  double pivot_quarters = 0.0;  // on the spot
  int cycles = 0;               // of the implement
  int cusps = 0;
};

// Metre by metre by the slopes of the ground under B's origin, bend by bend, and for each lowering,
// change of gear, turn on the spot and stop what it takes. A bend with the implement down takes its
// share of the tightest one's in proportion to its curvature. `terrain` null: flat.
PredictedEnergy predicted_energy(const Path& path, const Heightfield* terrain,
                                 const DriveCost& cost);

}  // namespace headland
