// Closed curves that a vehicle can follow.
#pragma once

#include "planner/cancel.h"
#include "planner/polygon.h"

namespace headland {

// Spacing of the points of a smoothed ring [m].
inline constexpr double kRingSpacing_m = 0.25;

struct Rounding {
  double radius_m = 0.0;         // of the disc that boundaries can be followed with
  double corner_radius_m = 0.0;  // the same in corners of the ground; at least radius_m
  const PolygonSet& limit;       // whose outside is to be kept away from,
  double clearance_m = 0.0;      // by this
};

// `ground` with every corner rounded both ways: morphological closing and opening by the two discs.
// Where closing would bring the boundary nearer than the clearance (at corners that stick into the
// ground, at obstacles smaller than the disc), the boundary swings out around the place instead.
// What is narrower than two radii is lost. Error of position: up to 1 % of the radius. Throws
// Cancelled.
PolygonSet rounded(const PolygonSet& ground, const Rounding& rounding,
                   const CancelAsked& cancelled = {});

// The first half of it: corners that stick into the ground can be passed, those of the ground stay
// sharp.
PolygonSet passable(const PolygonSet& ground, const Rounding& rounding,
                    const CancelAsked& cancelled = {});

// Rounding leaves kinks into the ground where opening split it, and kinks out of it where closing
// joined it. Closed once more, though not where that comes nearer than the clearance:
PolygonSet closed_where_clear(const PolygonSet& ground, const Rounding& rounding);
// and opened once more.
PolygonSet opened(const PolygonSet& ground, const Rounding& rounding);

// `ring` as a closed polyline of equally spaced points (first == last), low-pass filtered with a
// Gaussian of standard deviation sigma_m along its length: kinks of the rounding vanish and
// curvature comes and goes gradually.
Polyline smoothed_ring(const Ring& ring, double sigma_m);

// Radius [m] of the tightest circle through three points of the closed polyline that are window_m
// apart along it; the window must be well over the points' noise and under the radius looked for.
double tightest_radius_m(const Polyline& closed, double window_m);

}  // namespace headland
