// Headland passes along the edges of a field and its holes, right into the corners.
#pragma once

#include <cstddef>
#include <vector>

#include "planner/free_space.h"
#include "planner/plan.h"
#include "planner/polygon.h"
#include "planner/worked_ground.h"

namespace headland {

struct EdgePass {
  int round = 0;         // from the boundary inwards
  std::size_t ring = 0;  // of its round: passes of one ring follow each other around it
  bool around_hole = false;
  bool closed = false;  // a ring without corners: first point == last
  Polyline line_W;      // of the implement's middle, kRingSpacing_m between points
  // From the end of the pass before it around its ring, where edges without the round may lie
  // between.
  double gap_m = 0.0;
};

struct EdgeOptions {
  double overhang_m = 0.0;  // by which the implement may work beyond boundary and holes
  double least_m2 = 1.0;    // passes that work less are left out
};

// Distance [m] of the outermost pass from the boundary: half the working width, or what the hull,
// its clearance and kRoomBesideEdge_m need where that is more.
double edge_distance_m(const PlanRequest& request);

// With less, the rear swings out beyond the clearance in whatever turn leads away from the pass: on
// a square of 40 m the transplanter with 1.9 m instead of 2 m then left out 17 % of the ground.
inline constexpr double kRoomBesideEdge_m = 0.05;

// One round at `distance_m` from boundary and holes. Its rings are cut at corners into the field
// that turn by more than kSharpCorner_rad within a turning radius; there the vehicle stops with its
// front before the next edge, and begins the next pass backed into the corner. Gentler corners are
// rounded, with the line moved inwards as far as the hull needs to swing past the edge; around
// corners of holes, and others that stick into the field, it runs in an arc (see `rounded` in
// ring_smoothing.h). Passes keep the clearance, and the implement on the field; they leave out ends
// that find all ground worked in `ground`, which is worked by them. Throws Cancelled.
std::vector<EdgePass> edge_round(const PlanRequest& request, const FreeSpace& space,
                                 const PolygonSet& field, double distance_m, int round,
                                 const EdgeOptions& options, WorkedGround& ground);

inline constexpr double kSharpCorner_rad = 0.44;  // 25 degrees

}  // namespace headland
