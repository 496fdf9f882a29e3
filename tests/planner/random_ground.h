// Ground with holes for property tests.
#pragma once

#include "planner/polygon.h"
#include "tests/terrains/random_ring.h"

namespace headland {

// A ring of any_ring() with up to `most_holes` holes, each concave as a rule, in places of its own.
inline PolygonPart any_ground(int most_holes) {
  PolygonPart ground{any_ring(), {}};
  const int holes = *rc::gen::inRange(0, most_holes + 1);
  Field sofar;
  sofar.boundary = ground.outer;
  for (int tries = 0; tries < 8 * holes && static_cast<int>(sofar.holes.size()) < holes; ++tries) {
    const Eigen::Vector2d middle(any_number(-60.0, 60.0), any_number(-60.0, 60.0));
    // any_ring() reaches 100 m at most.
    const double room_m = field_clearance_m(sofar, middle);
    if (room_m < 3.0) continue;
    Ring hole = any_ring();
    for (Eigen::Vector2d& p_W : hole) p_W = middle + 0.9 * room_m / 100.0 * p_W;
    sofar.holes.emplace_back(hole.rbegin(), hole.rend());
  }
  ground.holes = sofar.holes;
  return ground;
}

}  // namespace headland
