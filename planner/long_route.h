// A long way through a field, from place to place.
#pragma once

#include <optional>
#include <vector>

#include "planner/hybrid_a_star.h"

namespace headland {

// The shortest way of a disc over square cells, of one in which the hull can turn round if
// there is such a way, else of smaller ones down to the hull's half width; on it poses a few
// turning radii apart, joined by the cheapest turns that fit, each as far ahead as one does, or by
// hybrid A* where none does; then shortened as find_route does. None when there is no such way, or
// `max_nodes` of the searches between the places were not enough; `expanded` (may be null) counts
// them. Throws Cancelled.
std::optional<std::vector<Arc>> find_long_route(const FreeSpace& space, const Pose& from,
                                                const Pose& to, const RouteOptions& options,
                                                int* expanded);

// Ways shorter than this as the crow flies [turning radii] are for find_route alone.
inline constexpr double kLongRoute = 8.0;

}  // namespace headland
