#include "planner/polygon.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

#include "terrains/geos_scope.h"

namespace headland {
namespace {

// Set operations work on a grid of a micrometre. On plain doubles GEOS 3.11 loses whole polygons
// without a word where edges coincide but for rounding, as those of neighbouring strips do.
constexpr double kGrid_m = 1e-6;

Geometry geometry_of_parts(const GeosScope& geos, std::span<const PolygonSet> sets) {
  std::vector<Geometry> parts;
  for (const PolygonSet& set : sets) {
    for (const PolygonPart& part : set.parts) {
      parts.push_back(polygon_geometry(geos, part.outer, part.holes));
    }
  }
  return multi_polygon_geometry(geos, std::move(parts));
}

Geometry geometry_of(const GeosScope& geos, const PolygonSet& set) {
  return geometry_of_parts(geos, std::span(&set, 1));
}

Ring ring_of(const GeosScope& geos, const GEOSGeometry* geometry, bool counter_clockwise) {
  Ring ring = points_of(geos, geometry);
  ring.pop_back();
  if ((signed_area_m2(ring) > 0.0) != counter_clockwise) {
    std::reverse(ring.begin() + 1, ring.end());
  }
  return ring;
}

// Polygons of a geometry of any type; the points and lines in which polygons merely touch are left
// out.
void append_parts(const GeosScope& geos, const GEOSGeometry* geometry,
                  std::vector<PolygonPart>& parts) {
  const int type = GEOSGeomTypeId_r(geos.handle(), geometry);
  if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    const int count = GEOSGetNumGeometries_r(geos.handle(), geometry);
    for (int i = 0; i < count; ++i) {
      append_parts(geos, GEOSGetGeometryN_r(geos.handle(), geometry, i), parts);
    }
  } else if (type == GEOS_POLYGON && GEOSisEmpty_r(geos.handle(), geometry) == 0) {
    PolygonPart part;
    part.outer = ring_of(geos, GEOSGetExteriorRing_r(geos.handle(), geometry), true);
    const int holes = GEOSGetNumInteriorRings_r(geos.handle(), geometry);
    for (int i = 0; i < holes; ++i) {
      part.holes.push_back(
          ring_of(geos, GEOSGetInteriorRingN_r(geos.handle(), geometry, i), false));
    }
    parts.push_back(std::move(part));
  }
}

PolygonSet set_of(const GeosScope& geos, const Geometry& geometry) {
  PolygonSet set;
  append_parts(geos, geometry.get(), set.parts);
  return set;
}

Ring circumscribed_circle(const Eigen::Vector2d& centre_W, double radius_m) {
  // As many corners as keep them within kDiscTolerance_m of the circle.
  const double half_rad = std::acos(radius_m / (radius_m + kDiscTolerance_m));
  const int corners = std::max(8, static_cast<int>(std::ceil(std::numbers::pi / half_rad)));
  const double corner_radius_m = radius_m / std::cos(std::numbers::pi / corners);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / corners;
    ring.emplace_back(centre_W +
                      corner_radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return ring;
}

std::vector<std::size_t> ring_counts(const PolygonSet& set) {
  std::vector<std::size_t> counts;
  for (const PolygonPart& part : set.parts) counts.push_back(part.holes.size());
  return counts;
}

}  // namespace

PolygonSet from_field(const Field& field, double obstacle_margin_m) {
  PolygonSet ground{{PolygonPart{field.boundary, field.holes}}};
  if (field.obstacles.empty()) return ground;
  std::vector<PolygonSet> discs;
  for (const Obstacle& obstacle : field.obstacles) {
    const double radius_m = obstacle.radius_m + obstacle_margin_m;
    if (radius_m <= 0.0) continue;
    discs.push_back({{PolygonPart{circumscribed_circle(obstacle.p_W, radius_m), {}}}});
    if (obstacle.run_W.isZero(0.0)) continue;
    const Eigen::Vector2d end_W = obstacle.p_W + obstacle.run_W;
    discs.push_back({{PolygonPart{circumscribed_circle(end_W, radius_m), {}}}});
    discs.push_back(strip({obstacle.p_W, end_W}, 2.0 * radius_m));
  }
  return difference(ground, united(discs));
}

PolygonSet buffered(const PolygonSet& set, double distance_m, Join join, int quadrant_segments) {
  const GeosScope geos;
  const int style = join == Join::kMitre ? GEOSBUF_JOIN_MITRE : GEOSBUF_JOIN_ROUND;
  return set_of(
      geos, owned(geos,
                  GEOSBufferWithStyle_r(geos.handle(), geometry_of(geos, set).get(), distance_m,
                                        quadrant_segments, GEOSBUF_CAP_ROUND, style, kMitreLimit),
                  "buffer"));
}

PolygonSet simplified(const PolygonSet& set, double tolerance_m) {
  const GeosScope geos;
  const Geometry whole = geometry_of(geos, set);
  // Looking at every crossing takes minutes for rings of many thousand points; hardly ever is there
  // one within a small tolerance.
  const Geometry plain =
      owned(geos, GEOSSimplify_r(geos.handle(), whole.get(), tolerance_m), "simplify");
  if (GEOSisValid_r(geos.handle(), plain.get()) == 1) {
    PolygonSet result = set_of(geos, plain);
    if (ring_counts(result) == ring_counts(set)) return result;
  }
  return set_of(geos,
                owned(geos, GEOSTopologyPreserveSimplify_r(geos.handle(), whole.get(), tolerance_m),
                      "simplify"));
}

PolygonSet difference(const PolygonSet& a, const PolygonSet& b) {
  const GeosScope geos;
  return set_of(geos, owned(geos,
                            GEOSDifferencePrec_r(geos.handle(), geometry_of(geos, a).get(),
                                                 geometry_of(geos, b).get(), kGrid_m),
                            "difference"));
}

PolygonSet intersection(const PolygonSet& a, const PolygonSet& b) {
  const GeosScope geos;
  return set_of(geos, owned(geos,
                            GEOSIntersectionPrec_r(geos.handle(), geometry_of(geos, a).get(),
                                                   geometry_of(geos, b).get(), kGrid_m),
                            "intersection"));
}

PolygonSet united(std::span<const PolygonSet> sets) {
  const GeosScope geos;
  return set_of(
      geos,
      owned(geos, GEOSUnaryUnionPrec_r(geos.handle(), geometry_of_parts(geos, sets).get(), kGrid_m),
            "union"));
}

bool covers(const PolygonSet& whole, const PolygonSet& part) {
  if (part.parts.empty()) return true;
  const GeosScope geos;
  const Geometry whole_geometry = geometry_of(geos, whole);
  const auto destroy = [&](const GEOSPreparedGeometry* prepared) {
    GEOSPreparedGeom_destroy_r(geos.handle(), prepared);
  };
  const std::unique_ptr<const GEOSPreparedGeometry, decltype(destroy)> prepared(
      GEOSPrepare_r(geos.handle(), whole_geometry.get()), destroy);
  if (!prepared) geos.fail("covers");
  const char answer =
      GEOSPreparedCovers_r(geos.handle(), prepared.get(), geometry_of(geos, part).get());
  if (answer > 1) geos.fail("covers");
  return answer == 1;
}

Disc widest_disc(const PolygonSet& set) {
  if (set.parts.empty()) return {};
  const GeosScope geos;
  const Geometry radius = owned(
      geos,
      GEOSMaximumInscribedCircle_r(geos.handle(), geometry_of(geos, set).get(), kDiscTolerance_m),
      "widest disc");
  const Polyline ends = points_of(geos, radius.get());
  return {ends.front(), (ends.back() - ends.front()).norm()};
}

PolygonSet strip(const Polyline& line, double width_m) {
  if (!(length_m(line) > 0.0)) return {};
  const GeosScope geos;
  return set_of(geos,
                owned(geos,
                      GEOSBufferWithStyle_r(geos.handle(), line_geometry(geos, line).get(),
                                            width_m / 2.0, kQuadrantSegments, GEOSBUF_CAP_FLAT,
                                            GEOSBUF_JOIN_ROUND, kMitreLimit),
                      "strip"));
}

std::vector<Polyline> clip_line(const Polyline& line, const PolygonSet& set) {
  if (!(length_m(line) > 0.0)) return {};
  const GeosScope geos;
  const Geometry geometry = line_geometry(geos, line);
  const Geometry inside = owned(
      geos,
      GEOSIntersectionPrec_r(geos.handle(), geometry.get(), geometry_of(geos, set).get(), kGrid_m),
      "clip");
  std::vector<Polyline> pieces;
  const int count = GEOSGetNumGeometries_r(geos.handle(), inside.get());
  for (int i = 0; i < count; ++i) {
    const GEOSGeometry* piece = GEOSGetGeometryN_r(geos.handle(), inside.get(), i);
    if (GEOSGeomTypeId_r(geos.handle(), piece) == GEOS_LINESTRING &&
        GEOSisEmpty_r(geos.handle(), piece) == 0) {
      pieces.push_back(points_of(geos, piece));
    }
  }
  return pieces;
}

std::vector<PolygonPart> cut_apart(const PolygonPart& ground, std::span<const Polyline> lines) {
  const GeosScope geos;
  std::vector<Geometry> edges;
  edges.push_back(ring_geometry(geos, ground.outer));
  for (const Ring& hole : ground.holes) edges.push_back(ring_geometry(geos, hole));
  for (const Polyline& line : lines) edges.push_back(line_geometry(geos, line));
  const Geometry all = collection_geometry(geos, GEOS_GEOMETRYCOLLECTION, std::move(edges));
  const Geometry noded =
      owned(geos, GEOSUnaryUnionPrec_r(geos.handle(), all.get(), kGrid_m), "cut apart");
  const GEOSGeometry* const network = noded.get();
  const Geometry faces = owned(geos, GEOSPolygonize_r(geos.handle(), &network, 1), "cut apart");
  PolygonSet pieces = set_of(geos, faces);
  std::erase_if(pieces.parts, [&](const PolygonPart& piece) {
    // Holes are faces too.
    const Geometry inner_point = owned(
        geos, GEOSPointOnSurface_r(geos.handle(), geometry_of(geos, {{piece}}).get()), "cut apart");
    const Eigen::Vector2d p_W = points_of(geos, inner_point.get()).front();
    return !inside_ring(ground.outer, p_W) ||
           std::ranges::any_of(ground.holes,
                               [&](const Ring& hole) { return inside_ring(hole, p_W); });
  });
  return std::move(pieces.parts);
}

bool holds(const PolygonPart& part, const Eigen::Vector2d& p_W) {
  return inside_ring(part.outer, p_W) &&
         std::ranges::none_of(part.holes, [&](const Ring& hole) { return inside_ring(hole, p_W); });
}

bool holds(const PolygonSet& set, const Eigen::Vector2d& p_W) {
  return std::ranges::any_of(set.parts, [&](const PolygonPart& part) { return holds(part, p_W); });
}

double area_m2(const PolygonSet& set) {
  double sum_m2 = 0.0;
  for (const PolygonPart& part : set.parts) {
    sum_m2 += signed_area_m2(part.outer);
    for (const Ring& hole : part.holes) sum_m2 += signed_area_m2(hole);
  }
  return sum_m2;
}

double length_m(const Polyline& line) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum_m += (line[i] - line[i - 1]).norm();
  return sum_m;
}

}  // namespace headland
