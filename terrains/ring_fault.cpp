#include "terrains/ring_fault.h"

#include "terrains/geos_scope.h"

namespace headland {
namespace {

Eigen::Vector2d first_point(const GeosScope& geos, const GEOSGeometry* point) {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  GEOSGeomGetX_r(geos.handle(), point, &p_W.x());
  GEOSGeomGetY_r(geos.handle(), point, &p_W.y());
  return p_W;
}

}  // namespace

std::optional<RingFault> ring_fault(const Ring& ring) {
  const GeosScope geos;
  const Geometry polygon = polygon_geometry(geos, ring, {});
  char* reason = nullptr;
  GEOSGeometry* place = nullptr;
  const char valid = GEOSisValidDetail_r(geos.handle(), polygon.get(), 0, &reason, &place);
  const Geometry owned_place(place, DestroyGeometry{geos.handle()});
  if (valid == 1) return std::nullopt;
  RingFault fault;
  if (reason != nullptr) fault.reason = reason;
  GEOSFree_r(geos.handle(), reason);
  if (place != nullptr) fault.p_W = first_point(geos, place);
  return fault;
}

std::optional<Eigen::Vector2d> meeting_place(const Ring& a, const Ring& b, double nearest_m) {
  const GeosScope geos;
  const Geometry ring_a = ring_geometry(geos, a);
  const Geometry ring_b = ring_geometry(geos, b);
  double distance_m = 0.0;
  GEOSDistance_r(geos.handle(), ring_a.get(), ring_b.get(), &distance_m);
  if (distance_m > nearest_m) return std::nullopt;
  GEOSCoordSequence* nearest = GEOSNearestPoints_r(geos.handle(), ring_a.get(), ring_b.get());
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  GEOSCoordSeq_getXY_r(geos.handle(), nearest, 0, &p_W.x(), &p_W.y());
  GEOSCoordSeq_destroy_r(geos.handle(), nearest);
  return p_W;
}

}  // namespace headland
