// The ground of a headland: how wide it is along which edge, and what it leaves for swaths.
#pragma once

#include <vector>

#include "planner/edge_zones.h"
#include "planner/headland_round.h"
#include "planner/plan.h"
#include "planner/polygon.h"
#include "planner/swaths.h"

namespace headland {

struct Headland {
  double width_m = 0.0;             // where it is widest
  int rounds = 0;                   // there
  int least_rounds = 0;             // of any edge
  std::vector<HeadlandRing> rings;  // by round; within a round as GEOS gives them
  PolygonSet inner;                 // ground left for swaths
  PolygonSet drivable;             // where the middle of a swath may run: implement and hull inside
  PolygonSet beyond;               // where edges have no headland: what the implement may not work
  std::vector<PlannedEdge> edges;  // all, where the request names some
  // Where edges have different numbers of rounds:
  PolygonSet inside;  // ground without headland
  EdgedGround edged;
  std::vector<NarrowEdge> narrow;  // too narrow for turning
};

bool differs_by_edge(const Headland& headland);

// What swaths are laid on.
SwathGround swath_ground(const Headland& headland);

// The implement works no further than this beyond an edge without headland [m]: a receiver's noise
// of 2 cm moves outlines by as much between its extremes, and swaths are not to be cut for that.
inline constexpr double kOverEdge_m = 0.15;

// The ground, without rings, of `rounds` along all edges of `field` (from_field), the outermost
// `first_m` from them. Edges that the request names have their own number of rounds, unless that
// comes to the same for all. Throws InputError for edges that are not there.
Headland headland_ground(const PlanRequest& request, const PolygonSet& field, int rounds,
                         double first_m);

// `inside`, the ground without headland, without what swaths in direction_rad may be cut back by
// where they meet an edge that is too narrow for turning at a small angle.
PolygonSet kept_whole(const PlanRequest& request, const EdgedGround& edged,
                      const PolygonSet& inside, double direction_rad);

}  // namespace headland
