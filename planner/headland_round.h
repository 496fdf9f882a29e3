// One round of a headland.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "planner/plan.h"
#include "planner/polygon.h"
#include "planner/ring_smoothing.h"

namespace headland {

// A closed round (first point == last), kRingSpacing_m between points, never tighter than the
// turning radius; or what of one runs along edges that have it. `round` counts from the boundary
// inwards.
struct HeadlandRing {
  int round = 0;
  bool around_hole = false;
  Polyline line_W;
  Eigen::AlignedBox2d box_W;  // around line_W
};

bool is_closed(const HeadlandRing& ring);

// Width [m] of a headland of so many rounds, the outermost `first_m` from its edge; 0 for none.
double headland_width_m(int rounds, double first_m, double working_width_m);

// Rounding is done with a larger radius, because filtering tightens a circle of radius R by
// sigma^2 / (2 R^2) = 0.5 % and leaves about 1 % of ripple.
inline constexpr double kRadiusMargin = 1.03;

struct HeadlandRound {
  PolygonSet ground;  // the rings run along its edges
  std::vector<HeadlandRing> rings;
};

// Rings along the edges of `ground`, rounded. Those whose kinks cannot be rounded away are left
// out. Throws Cancelled.
HeadlandRound round_along(const PolygonSet& ground, int round, const Rounding& rounding,
                          const PlanRequest& request);

// Pieces of ground that rounds of width_m leave, without slivers and crumbs.
PolygonSet worth_working(const PolygonSet& ground, double width_m);

}  // namespace headland
