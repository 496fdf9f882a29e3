// How deep a headland is to be: where its first round lies, and how many rounds turning needs.
#pragma once

#include "planner/plan.h"

namespace headland {

// What the outermost ring keeps beyond the clearance asked for [m], for the errors of its rounding.
inline constexpr double kRingMargin_m = 0.05;

// The outermost ring: its distance from the boundary and the radius of its corners [m].
struct FirstRound {
  double distance_m = 0.0;
  double radius_m = 0.0;
};

// In a corner of radius r the hull's front corner swings out to hypot(r + hull width / 2, front)
// from the arc's centre. The ring keeps far enough from the boundary for that and the clearance
// (of which only what exceeds half the working width moves the ring), and takes the
// corner radius, from the turning radius to kWidestCorner times it, that leaves the least ground
// unworked: wide corners swing out less but cut more off. A wide implement needs neither: its
// ring is at half the working width with the turning radius.
FirstRound first_round(const PlanRequest& request);
inline constexpr double kWidestCorner = 2.5;

// Depth [m] that turning round takes from the end of a swath to the boundary. U-turn and
// three-point turn both begin with a quarter circle of the turning radius R, so
//   depth = rear + max(R + w/2, hypot(R + hull width/2, front)) + clearance
// with the implement lifted but its width w swung along, the front corner of the hull, and the
// rear overhang by which the axle is ahead of the working line. Who drives forward only swings
// sqrt(4 R^2 - (R + w/2)^2) further out where w < 2 R (omega turn).
double turning_depth_m(const PlanRequest& request);

// Smallest number of rounds whose ground is turning_depth_m deep.
int rounds_for_turning(const PlanRequest& request);

}  // namespace headland
