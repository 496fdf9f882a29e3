#include "terrains/field_outline.h"

#include <algorithm>
#include <utility>

#include "terrains/geos_scope.h"

namespace headland {
namespace {

// GEOS flattens what it buffers by 1 % of the distance, and arcs are made of chords.
constexpr double kRoundingRatio = 0.9;

Ring open_ring(const GeosScope& geos, const GEOSGeometry* line) {
  Ring ring = points_of(geos, line);
  ring.pop_back();
  return ring;
}

void take_outline(const GeosScope& geos, const Geometry& polygon, Field& field) {
  field.boundary = open_ring(geos, GEOSGetExteriorRing_r(geos.handle(), polygon.get()));
  if (signed_area_m2(field.boundary) < 0.0) std::ranges::reverse(field.boundary);
  std::vector<Ring> holes;
  const int count = GEOSGetNumInteriorRings_r(geos.handle(), polygon.get());
  for (int i = 0; i < count; ++i) {
    holes.push_back(open_ring(geos, GEOSGetInteriorRingN_r(geos.handle(), polygon.get(), i)));
    if (signed_area_m2(holes.back()) > 0.0) std::ranges::reverse(holes.back());
  }
  field.holes = std::move(holes);
}

Geometry simplified(const GeosScope& geos, const Geometry& polygon, double tolerance_m) {
  return owned(geos, GEOSTopologyPreserveSimplify_r(geos.handle(), polygon.get(), tolerance_m),
               "simplify");
}

}  // namespace

void simplify_outline(Field& field, double tolerance_m) {
  const GeosScope geos;
  const Geometry polygon = polygon_geometry(geos, field.boundary, field.holes);
  take_outline(geos, simplified(geos, polygon, tolerance_m), field);
}

bool simplify_outline_inside(Field& field, double tolerance_m) {
  constexpr int kQuadrantSegments = 2;
  const GeosScope geos;
  const Geometry polygon = polygon_geometry(geos, field.boundary, field.holes);
  const Geometry shrunk = owned(
      geos, GEOSBuffer_r(geos.handle(), polygon.get(), -tolerance_m, kQuadrantSegments), "shrink");
  if (GEOSGeomTypeId_r(geos.handle(), shrunk.get()) != GEOS_POLYGON ||
      GEOSisEmpty_r(geos.handle(), shrunk.get()) != 0 ||
      GEOSGetNumInteriorRings_r(geos.handle(), shrunk.get()) !=
          static_cast<int>(field.holes.size())) {
    return false;
  }
  take_outline(geos, simplified(geos, shrunk, kRoundingRatio * tolerance_m), field);
  return true;
}

std::vector<Eigen::Vector2d> simplified_line(const std::vector<Eigen::Vector2d>& points_W,
                                             double tolerance_m) {
  const GeosScope geos;
  const Geometry line = line_geometry(geos, points_W);
  return points_of(
      geos, owned(geos, GEOSSimplify_r(geos.handle(), line.get(), tolerance_m), "simplify").get());
}

}  // namespace headland
