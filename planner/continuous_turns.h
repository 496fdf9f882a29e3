// Turns whose curvature has no jumps, because steering takes its time.
#pragma once

#include <optional>
#include <vector>

#include "planner/turns.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// By how much [1/m2] the curvature changes a metre when the vehicle steers as fast as it can at its
// turning speed, near straight ahead, where steering changes the curvature least. 0 for skid
// steering, which needs no time.
double turning_sharpness_per_m2(const Vehicle& vehicle);

// The turn with clothoids in place of jumps of curvature: every arc begins and ends straight, in
// ramps of that sharpness, and where it turns too little for its full curvature it has none. At
// changes of gear, and where the vehicle stops for one before or after the turn, the wheels are
// turned at standstill. (Arcs of this kind: Scheuer and Fraichard 1997.) The lengths of its pieces
// are found by Newton's method from those of `arcs`, to within kContinuousEnd; none when that
// does not lead to a turn, or to one with odd runs. Curvatures are multiplied by `tightened`, for
// words found with a larger radius.
std::optional<Turn> continuous_turn(const Pose& from, const Pose& to, const std::vector<Arc>& arcs,
                                    double sharpness_per_m2, double tightened = 1.0);
inline constexpr double kContinuousEnd = 1e-7;  // m and rad

// Radius of the circle, in place of one of radius_m, on which an arc with its ramps ends.
double ramped_radius_m(double radius_m, double sharpness_per_m2);

// Lines and arcs driven forward, as of roads, with every arc between two lines begun and ended in
// clothoids, where the lines are long enough to begin it earlier: the lines, and where all of it
// ends, stay, and the bend is cut further. An arc that turns too little for its full curvature gets
// less; one that turns by nothing, or by half a turn or more, stays. sharpness_per_m2 > 0.
std::vector<Arc> with_ramps(const std::vector<Arc>& arcs, double sharpness_per_m2);

// Whether curvature does not jump along the arcs, between passes that are driven straight forward,
// but where the vehicle stops.
bool is_continuous(const std::vector<Arc>& arcs);

// Ends of arcs that begin or end on passes with these curvatures, driven forward, at which the
// curvature jumps by more than kJointJump_per_m and the vehicle does not stop.
int abrupt_joints(const std::vector<Arc>& arcs, double before_per_m, double after_per_m);
// As from a line to a circle of 100 m: what passes' curvature, a difference quotient, is uncertain
// by is less.
inline constexpr double kJointJump_per_m = 0.01;

}  // namespace headland
