#include "terrains/ring_fault.h"

#include <geos_c.h>

#include <memory>
#include <vector>

namespace headland {
namespace {

struct Context {
  GEOSContextHandle_t handle = GEOS_init_r();
  Context() = default;
  ~Context() { GEOS_finish_r(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

struct DestroyGeometry {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle, geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;

Geometry linear_ring(const Context& geos, const Ring& ring) {
  std::vector<double> xy;
  xy.reserve(2 * (ring.size() + 1));
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    xy.push_back(ring[i % ring.size()].x());
    xy.push_back(ring[i % ring.size()].y());
  }
  GEOSCoordSequence* sequence = GEOSCoordSeq_copyFromBuffer_r(
      geos.handle, xy.data(), static_cast<unsigned>(ring.size() + 1), 0, 0);
  return {GEOSGeom_createLinearRing_r(geos.handle, sequence), DestroyGeometry{geos.handle}};
}

Eigen::Vector2d first_point(const Context& geos, const GEOSGeometry* point) {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  GEOSGeomGetX_r(geos.handle, point, &p_W.x());
  GEOSGeomGetY_r(geos.handle, point, &p_W.y());
  return p_W;
}

}  // namespace

std::optional<RingFault> ring_fault(const Ring& ring) {
  const Context geos;
  const Geometry polygon(
      GEOSGeom_createPolygon_r(geos.handle, linear_ring(geos, ring).release(), nullptr, 0),
      DestroyGeometry{geos.handle});
  char* reason = nullptr;
  GEOSGeometry* place = nullptr;
  const char valid = GEOSisValidDetail_r(geos.handle, polygon.get(), 0, &reason, &place);
  const Geometry owned_place(place, DestroyGeometry{geos.handle});
  if (valid == 1) return std::nullopt;
  RingFault fault;
  if (reason != nullptr) fault.reason = reason;
  GEOSFree_r(geos.handle, reason);
  if (place != nullptr) fault.p_W = first_point(geos, place);
  return fault;
}

std::optional<Eigen::Vector2d> meeting_place(const Ring& a, const Ring& b, double nearest_m) {
  const Context geos;
  const Geometry ring_a = linear_ring(geos, a);
  const Geometry ring_b = linear_ring(geos, b);
  double distance_m = 0.0;
  GEOSDistance_r(geos.handle, ring_a.get(), ring_b.get(), &distance_m);
  if (distance_m > nearest_m) return std::nullopt;
  GEOSCoordSequence* nearest = GEOSNearestPoints_r(geos.handle, ring_a.get(), ring_b.get());
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  GEOSCoordSeq_getXY_r(geos.handle, nearest, 0, &p_W.x(), &p_W.y());
  GEOSCoordSeq_destroy_r(geos.handle, nearest);
  return p_W;
}

}  // namespace headland
