// Out of a tight place, to where a vehicle can turn.
#pragma once

#include <optional>
#include <vector>

#include "planner/arcs.h"
#include "planner/free_space.h"

namespace headland {

// The cheapest way found from a pose that fits to one from which the vehicle can turn to both sides
// in every gear it has; no arcs where it could turn at once, none where there is no such way
// nearby. A search (Dijkstra) over lines, gentle curves and turns of `radius_m`, all with the
// clearance; gentle curves leave an edge that the rear swings out towards. Driven back, it is the
// way into the pose. At most kMostRoomNodes nodes are looked at.
std::optional<std::vector<Arc>> way_to_room(const FreeSpace& space, const Pose& from,
                                            double radius_m, double clearance_m);

inline constexpr int kMostRoomNodes = 400;

}  // namespace headland
