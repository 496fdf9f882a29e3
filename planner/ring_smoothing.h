// Closed curves that a vehicle can follow.
#pragma once

#include "planner/polygon.h"

namespace headland {

// Spacing of the points of a smoothed ring [m].
inline constexpr double kRingSpacing_m = 0.25;

// `ground` with every corner rounded both ways: morphological closing by a disc of radius_m and
// opening by one of corner_radius_m >= radius_m, so that boundaries can be followed with radius_m,
// and with corner_radius_m in corners of the ground. Where closing would bring the
// boundary nearer than `clearance_m` to the outside of `limit` (at corners that stick into the
// ground, at obstacles smaller than the disc), the boundary swings out around the place instead.
// What is narrower than two radii is lost. Error of position: up to 1 % of the radius.
PolygonSet rounded(const PolygonSet& ground, double radius_m, double corner_radius_m,
                   const PolygonSet& limit, double clearance_m);

// `ring` as a closed polyline of equally spaced points (first == last), low-pass filtered with a
// Gaussian of standard deviation sigma_m along its length: kinks of the rounding vanish and
// curvature comes and goes gradually.
Polyline smoothed_ring(const Ring& ring, double sigma_m);

// Radius [m] of the tightest circle through three points of the closed polyline that are window_m
// apart along it; the window must be well over the points' noise and under the radius looked for.
double tightest_radius_m(const Polyline& closed, double window_m);

}  // namespace headland
