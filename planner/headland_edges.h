// Edges of a field's outline, and how many headland passes each of them gets.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "planner/plan.h"
#include "planner/polygon.h"
#include "terrains/field.h"

namespace headland {

// An outline turns by more than this within kEdgeCornerWindow_m at a corner; between two corners
// lies one edge, however many points it is drawn with.
inline constexpr double kEdgeCorner_rad = 0.44;  // 25 degrees
inline constexpr double kEdgeCornerWindow_m = 5.0;
// A place names the edge that it lies on or this near to [m].
inline constexpr double kFarthestFromEdge_m = 50.0;
inline constexpr int kMostRounds = 20;  // that an edge can be given

// Edges count from 1, with the field on their left: those of the boundary counter-clockwise from
// the first corner on, those of holes likewise. `hole` counts from 1, 0 is the boundary. An outline
// without corners is one edge, its first point repeated at the end.
struct FieldEdge {
  int hole = 0;
  int edge = 0;
  Polyline line_W;
};

std::vector<FieldEdge> edges_of(const Field& field);

// "edge 3 of hole 1"; "edge 3" of the boundary.
std::string edge_name(int hole, int edge);

// What errors call an entry of PlanRequest::headland_edges: "headland_edges[0]".
std::string headland_edge_key(std::size_t entry);

// Rounds of every edge. `others` is of edges that are not named, and of obstacles.
struct EdgeRounds {
  std::vector<FieldEdge> edges;
  std::vector<int> rounds;  // of each
  int others = 0;
};

// What the request's `headland_edges` ask for, with `others` rounds elsewhere. A width [m] gets as
// many passes of the working width as cover it, when the outermost lies `first_m` from the edge;
// entries for all edges of a ring yield to those for one. Throws InputError("plan",
// "headland_edges[i]", ...) for a hole or an edge that is not there, a place more than
// kFarthestFromEdge_m from every edge, an edge named twice, and passes below 0 or above
// kMostRounds.
EdgeRounds edge_rounds(const PlanRequest& request, int others, double first_m);

// An edge with too little headland for swaths that end at it.
struct NarrowEdge {
  Polyline line_W;
  double width_m = 0.0;  // of its headland
};

// Whether swaths in direction_rad meet an edge along `run` at less than kEdgeCorner_rad: they end
// at others.
bool is_grazed(const Eigen::Vector2d& run, double direction_rad);

// The fewest and the most rounds of all edges, obstacles' where the field has some.
struct RoundsOfAll {
  int least = 0;
  int most = 0;
};
RoundsOfAll rounds_of_all(const EdgeRounds& edges, bool obstacles);

// Whether the headland is as one number of rounds for all edges gives it.
bool is_one_number(const RoundsOfAll& rounds);

}  // namespace headland
