// Rounds of a headland whose edges have different numbers of them.
#pragma once

#include "planner/headland_rings.h"

namespace headland {

// Adds the rings to the ground (headland_ground), and what they leave to its `inner`. Rounds that
// all edges have are as of make_headland; the others run along the edges that have them alone.
// Where such a round comes to an edge without it, it runs on to that one's headland - or turns off
// before the edge, where there is none - and ends. At the corner of two edges the wider headland
// reaches through to the other edge. `field` is the ground (from_field), `first` of first_round.
// Throws PlanInfeasible when not even one ring fits where one is asked for, Cancelled.
void add_rounds_by_edge(const PlanRequest& request, const PolygonSet& field,
                        const FirstRound& first, Headland& headland);

// The stretches of a line at `distance_m` from edges that have more rounds than `round`: at every
// place that of the edges as far away which lies most along the line tells.
std::vector<Polyline> stretches_along(const EdgedGround& edged, const Polyline& line_W,
                                      double distance_m, double width_m, int round);

}  // namespace headland
