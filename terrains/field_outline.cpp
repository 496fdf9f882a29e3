#include "terrains/field_outline.h"

#include <algorithm>
#include <utility>

#include "terrains/geos_scope.h"

namespace headland {
namespace {

Ring open_ring(const GeosScope& geos, const GEOSGeometry* line) {
  Ring ring = points_of(geos, line);
  ring.pop_back();
  return ring;
}

}  // namespace

void simplify_outline(Field& field, double tolerance_m) {
  const GeosScope geos;
  const Geometry polygon = polygon_geometry(geos, field.boundary, field.holes);
  const Geometry simple = owned(
      geos, GEOSTopologyPreserveSimplify_r(geos.handle(), polygon.get(), tolerance_m), "simplify");
  field.boundary = open_ring(geos, GEOSGetExteriorRing_r(geos.handle(), simple.get()));
  if (signed_area_m2(field.boundary) < 0.0) std::ranges::reverse(field.boundary);
  std::vector<Ring> holes;
  const int count = GEOSGetNumInteriorRings_r(geos.handle(), simple.get());
  for (int i = 0; i < count; ++i) {
    holes.push_back(open_ring(geos, GEOSGetInteriorRingN_r(geos.handle(), simple.get(), i)));
    if (signed_area_m2(holes.back()) > 0.0) std::ranges::reverse(holes.back());
  }
  field.holes = std::move(holes);
}

std::vector<Eigen::Vector2d> simplified_line(const std::vector<Eigen::Vector2d>& points_W,
                                             double tolerance_m) {
  const GeosScope geos;
  const Geometry line = line_geometry(geos, points_W);
  return points_of(
      geos, owned(geos, GEOSSimplify_r(geos.handle(), line.get(), tolerance_m), "simplify").get());
}

}  // namespace headland
