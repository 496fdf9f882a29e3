// A headland whose edges have different numbers of rounds.
#pragma once

#include "planner/headland_edges.h"
#include "planner/headland_rings.h"

namespace headland {

// Rounds as of make_headland; those that not all edges have run along the edges that have them
// alone. Where such a round comes to an edge without it, it runs on to that one's headland - or
// turns off before the edge, where there is none - and ends. At the corner of two edges the wider
// headland reaches through to the other edge. `field` is the ground (from_field), `first` of
// first_round. Throws PlanInfeasible when not even one ring fits where one is asked for, Cancelled.
Headland headland_by_edge(const PlanRequest& request, const PolygonSet& field,
                          const FirstRound& first, const EdgeRounds& edges);

// The same without rings, the outermost round lying `first_m` from its edges: width, ground and
// edges.
Headland ground_by_edge(const PlanRequest& request, const PolygonSet& field, double first_m,
                        const EdgeRounds& edges);

// Every edge with its headland, `first_m` being the distance of the outermost round from it.
std::vector<PlannedEdge> planned_edges(const EdgeRounds& edges, double width_m, double first_m);

// The stretches of a line at `distance_m` from edges that have more rounds than `round`: at every
// place that of the edges as far away which lies most along the line tells.
std::vector<Polyline> stretches_along(const EdgedGround& edged, const Polyline& line_W,
                                      double distance_m, double width_m, int round);

// `inside`, the ground without headland, without what swaths in direction_rad may be cut back by
// where they meet an edge that is too narrow for turning at a small angle.
PolygonSet kept_whole(const PlanRequest& request, const EdgedGround& edged,
                      const PolygonSet& inside, double direction_rad);

}  // namespace headland
