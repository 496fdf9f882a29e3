// A route around what is in the way, for a vehicle with a turning radius and two gears.
#pragma once

#include <optional>
#include <vector>

#include "planner/arcs.h"
#include "planner/cancel.h"
#include "planner/free_space.h"

namespace headland {

struct RouteOptions {
  double radius_m = 0.0;
  double clearance_m = 0.0;
  int max_nodes = 20000;  // nodes expanded before giving up
  CancelAsked cancelled{};
};

// Hybrid A* (Dolgov, Thrun, Montemerlo and Diebel 2010): a search over position, heading and gear
// whose steps are arcs, guided by the longer of the Reeds-Shepp length and a grid's shortest way
// around the limits, closed by a Reeds-Shepp curve that fits, then shortened where a closed-form
// turn saves something. Deviations: the grid guides with a disc of the hull's half width, and the
// way to go is weighed so that far fewer nodes are needed (not the best route, a good one). A hull
// that drives forward only is guided and closed by Dubins curves instead. None
// when there is no way or `max_nodes` were not enough. `expanded` (may be null) counts the nodes.
// Throws Cancelled.
std::optional<std::vector<Arc>> find_route(const FreeSpace& space, const Pose& from, const Pose& to,
                                           const RouteOptions& options, int* expanded);

// The route with stretches replaced by closed-form turns that fit and cost less, until none saves
// an arc.
std::vector<Arc> shortened_route(const FreeSpace& space, const Pose& from, std::vector<Arc> arcs,
                                 const RouteOptions& options);

}  // namespace headland
