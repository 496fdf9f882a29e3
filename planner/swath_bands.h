// Ground in the frame of parallel swaths: cut along their lines, and in the bands around them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/polygon.h"

namespace headland {

struct Interval {
  double from_m = 0.0;
  double to_m = 0.0;
};
using Intervals = std::vector<Interval>;

// Edge in the frame of the swaths: x along, y across, going up.
struct BandEdge {
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  double along_at(double across_m) const;
};

// All edges of a set, and how far it reaches across the swaths.
struct BandEdges {
  std::vector<BandEdge> edges;
  double lowest_m = 0.0;
  double highest_m = 0.0;
};

// An empty set reaches from lowest_m = +infinity to highest_m = -infinity.
BandEdges edges_along(const PolygonSet& set, double direction_rad);

// Bands height_m high, of which the first begins at lowest_m and each spacing_m further on.
struct Bands {
  double lowest_m = 0.0;
  double spacing_m = 0.0;
  double height_m = 0.0;
  int count = 0;
};

// Ground that reaches less than this into a band does not count [m].
inline constexpr double kBandEdge_m = 1e-3;

// What of the set lies on each of `count` lines, the first first_m across, in their order along.
std::vector<Intervals> cross_sections(const BandEdges& edges, double first_m, double spacing_m,
                                      int count);

// Extent along the swaths of each piece of the set's ground inside each band, those that meet as
// one.
std::vector<Intervals> extents_in_bands(const BandEdges& edges, const Bands& bands);

}  // namespace headland
