// The headland: rounds of the working width along the boundary and around holes and obstacles.
#pragma once

#include <vector>

#include "planner/headland_depth.h"
#include "planner/headland_ground.h"
#include "planner/headland_round.h"
#include "planner/plan.h"
#include "planner/polygon.h"

namespace headland {

// Throws PlanInfeasible: not even the first round fits.
[[noreturn]] void refuse_headland(const PlanRequest& request, const PolygonSet& field,
                                  const FirstRound& first);

// One round along all edges of `field`, the ground.
HeadlandRound round_of_all(const PlanRequest& request, const PolygonSet& field,
                           const FirstRound& first, int round);

// `rounds` >= 1 rings from first_round inwards, one working width apart. A round that splits
// becomes several rings, where the ground is narrower than two turning radii it vanishes; rounds
// of boundary and holes that would meet are one round around both. Ground inside the first round
// that no later round reaches, in pieces of more than a working width squared, is left to the
// swaths. Edges that the request names have their own number of rounds (headland_ground.h), unless
// that comes to the same number for all. Throws PlanInfeasible when not even one ring fits,
// InputError for edges that are not there, Cancelled.
Headland make_headland(const PlanRequest& request, int rounds);

}  // namespace headland
