// Ground with bays and holes cut into pieces that can be worked up and down.
#pragma once

#include <vector>

#include "planner/polygon.h"

namespace headland {

// Rays from corners of the ground into it, each as far as the first edge or earlier cut, part it
// into faces without holes. Cuts end in a corner where they come within kCutSnap_m of one.
// Outlines are counter-clockwise, add up to the ground to within its grid (polygon.h) and share
// whole edges to the bit, so they have points with straight angles where another piece's corner
// touches. Throw InputError as polygon.h.
inline constexpr double kCutSnap_m = 1e-5;

// At every concave corner, in the order of the rings, the edge that leads to it is extended: the
// decomposition of IGA-CPP, 'Region decomposition and selection', steps 1 to 3. Every piece is
// convex to within kConvex_m. One pass suffices: each cut leaves its corner without a concave angle
// and makes none, so dealing with the corners of the pieces again and again comes to the same.
// In general position c concave corners and h holes give 1 + c - h pieces.
// Deviations: concave corners are told by the sign of the cross product instead of two points
// probed on the bisector, and holes are ground's rings like any other.
std::vector<Ring> convex_pieces(const PolygonPart& ground);
inline constexpr double kConvex_m = 1e-4;

// Slices along `slice_rad` through every corner: triangles and trapezoids (Latombe, 'Robot motion
// planning', 1991, 5.1).
std::vector<Ring> trapezoids(const PolygonPart& ground, double slice_rad);

// Slices along `slice_rad` through the corners where the sweeping slice splits or joins: cells that
// every slice meets in one piece, not convex as a rule (Choset, 'Coverage of known spaces', 2000).
std::vector<Ring> boustrophedon_cells(const PolygonPart& ground, double slice_rad);

// The direction, 0 to pi, of the edge along which slices make the least sum of cells' widths across
// it, and so about the fewest swaths: half the sum of all edges' extents across (Huang, 'Optimal
// line-sweep-based decompositions', 2001, of whose sum this is the one for a single direction).
double least_width_direction_rad(const PolygonPart& ground);

}  // namespace headland
