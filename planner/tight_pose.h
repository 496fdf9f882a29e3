// Straight ways between a pose where the hull has hardly room and places where it has some.
#pragma once

#include <vector>

#include "planner/arcs.h"
#include "planner/free_space.h"

namespace headland {

struct Gate {
  Pose pose;              // on the tight pose's line, with room
  double length_m = 0.0;  // between the two
  bool ahead = false;     // of the tight pose
};

// Poses straight ahead of and behind `tight` where the hull keeps kGateRoom_m, each way the nearest
// and some further on, as far as the hull keeps `clearance_m` all the way; none when `tight` itself
// keeps that room. A search whose steps and curves come to the line at a small angle finds a gate,
// where it would not find a place between walls.
std::vector<Gate> gates_of(const FreeSpace& space, const Pose& tight, double clearance_m);

inline constexpr double kGateRoom_m = 0.1;
inline constexpr double kFurthestGate_m = 8.0;

}  // namespace headland
