#include "planner/tight_pose.h"

namespace headland {
namespace {

constexpr double kStep_m = 0.1;
// Between the gates of one side.
constexpr double kGateSpacing_m = 0.8;
constexpr int kGatesAhead = 3;

void add_gates(const FreeSpace& space, const Pose& tight, double clearance_m, Gear gear,
               std::vector<Gate>& gates) {
  const Arc line{kFurthestGate_m, 0.0, gear};
  double next_m = 0.0;
  int found = 0;
  for (int i = 1; i * kStep_m <= kFurthestGate_m && found < kGatesAhead; ++i) {
    const double length_m = i * kStep_m;
    const Pose pose = pose_along(tight, line, length_m);
    if (!fits(space, pose, clearance_m)) return;
    if (length_m < next_m || !fits(space, pose, kGateRoom_m)) continue;
    gates.push_back({pose, length_m, gear == Gear::kForward});
    next_m = length_m + kGateSpacing_m;
    ++found;
  }
}

}  // namespace

std::vector<Gate> gates_of(const FreeSpace& space, const Pose& tight, double clearance_m) {
  std::vector<Gate> gates;
  if (fits(space, tight, kGateRoom_m)) return gates;
  add_gates(space, tight, clearance_m, Gear::kForward, gates);
  add_gates(space, tight, clearance_m, Gear::kReverse, gates);
  return gates;
}

}  // namespace headland
