// Polygon sets in the plane and the set operations on them, computed by GEOS.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "terrains/field.h"

namespace headland {

// Open line p_W [m]. A closed one repeats its first point at the end.
using Polyline = std::vector<Eigen::Vector2d>;

// One connected piece of ground: `outer` runs counter-clockwise, `holes` run clockwise, and no
// ring repeats its first point.
struct PolygonPart {
  Ring outer;
  std::vector<Ring> holes;
};

// Pieces that share no inner point, in the order GEOS gives them, which depends on the input alone.
struct PolygonSet {
  std::vector<PolygonPart> parts;
};

enum class Join { kMitre, kRound };

// Chords in a quarter of a circle: a chord's middle is 1 - cos(90/24/2 deg) = 0.05 % of the radius
// inside the circle.
inline constexpr int kQuadrantSegments = 24;
// A mitre reaches at most this many distances beyond its corner; sharper corners are bevelled.
inline constexpr double kMitreLimit = 5.0;

// Results of set operations have their points on a grid of 1e-6 m.
// All functions below throw InputError when GEOS cannot work with the rings (they cross
// themselves).

// Discs, of obstacles or looked for, are exact to within this [m].
inline constexpr double kDiscTolerance_m = 0.005;

// The field's ground: boundary minus holes minus what is within obstacle_margin_m of an obstacle.
// Its round ends are circumscribed polygons, never smaller than the circle.
PolygonSet from_field(const Field& field, double obstacle_margin_m = 0.0);

// Grown by distance_m (shrunk when negative). kRound joins are exact offsets but for the chords,
// kMitre joins keep corners sharp.
PolygonSet buffered(const PolygonSet& set, double distance_m, Join join,
                    int quadrant_segments = kQuadrantSegments);

// With fewer points: everywhere within tolerance_m of the set's edges, the same parts and holes.
PolygonSet simplified(const PolygonSet& set, double tolerance_m);

PolygonSet difference(const PolygonSet& a, const PolygonSet& b);
PolygonSet intersection(const PolygonSet& a, const PolygonSet& b);
PolygonSet united(std::span<const PolygonSet> sets);

// Whether all of `part` lies in `whole`, edges included; much cheaper than a difference.
bool covers(const PolygonSet& whole, const PolygonSet& part);

// The largest disc inside the set, to within kDiscTolerance_m; radius 0 for an empty set.
struct Disc {
  Eigen::Vector2d centre_W = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};
Disc widest_disc(const PolygonSet& set);

// What a bar of width_m leaves worked when its middle is pulled along `line`: flat ends, round
// joins. Empty for a line without length.
PolygonSet strip(const Polyline& line, double width_m);

// The pieces of `line` inside `set`, in the line's order and direction.
std::vector<Polyline> clip_line(const Polyline& line, const PolygonSet& set);

// The pieces into which `lines` cut the ground, by where GEOS finds them. Neighbours share whole
// edges to the bit: where a line or another piece's corner meets an edge, both have a point.
std::vector<PolygonPart> cut_apart(const PolygonPart& ground, std::span<const Polyline> lines);

// Whether p_W lies inside.
bool holds(const PolygonPart& part, const Eigen::Vector2d& p_W);
bool holds(const PolygonSet& set, const Eigen::Vector2d& p_W);

double area_m2(const PolygonSet& set);
double length_m(const Polyline& line);

}  // namespace headland
