#include "terrains/geos_scope.h"

#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

void remember(const char* message, void* error) { *static_cast<std::string*>(error) = message; }

GEOSCoordSequence* sequence_of(const GeosScope& geos, const std::vector<Eigen::Vector2d>& points) {
  static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double));
  GEOSCoordSequence* sequence = GEOSCoordSeq_copyFromBuffer_r(
      geos.handle(), points.front().data(), static_cast<unsigned>(points.size()), 0, 0);
  if (sequence == nullptr) geos.fail("coordinates");
  return sequence;
}

// GEOS takes over members only once all of them exist.
std::vector<GEOSGeometry*> released(std::vector<Geometry>& members) {
  std::vector<GEOSGeometry*> pointers;
  pointers.reserve(members.size());
  for (Geometry& member : members) pointers.push_back(member.release());
  return pointers;
}

}  // namespace

GeosScope::GeosScope() : handle_(GEOS_init_r()) {
  GEOSContext_setErrorMessageHandler_r(handle_, remember, &error_);
}

GeosScope::~GeosScope() { GEOS_finish_r(handle_); }

void GeosScope::fail(const char* operation) const {
  throw InputError("polygon", operation, "", error_.empty() ? "GEOS gave no result" : error_);
}

Geometry owned(const GeosScope& geos, GEOSGeometry* geometry, const char* operation) {
  if (geometry == nullptr) geos.fail(operation);
  return {geometry, DestroyGeometry{geos.handle()}};
}

Geometry line_geometry(const GeosScope& geos, const std::vector<Eigen::Vector2d>& points) {
  return owned(geos, GEOSGeom_createLineString_r(geos.handle(), sequence_of(geos, points)), "line");
}

Geometry ring_geometry(const GeosScope& geos, const Ring& ring) {
  Ring closed = ring;
  closed.push_back(ring.front());
  return owned(geos, GEOSGeom_createLinearRing_r(geos.handle(), sequence_of(geos, closed)), "ring");
}

Geometry polygon_geometry(const GeosScope& geos, const Ring& outer, std::span<const Ring> holes) {
  Geometry outer_ring = ring_geometry(geos, outer);
  std::vector<Geometry> hole_rings;
  hole_rings.reserve(holes.size());
  for (const Ring& hole : holes) hole_rings.push_back(ring_geometry(geos, hole));
  std::vector<GEOSGeometry*> pointers = released(hole_rings);
  return owned(geos,
               GEOSGeom_createPolygon_r(geos.handle(), outer_ring.release(), pointers.data(),
                                        static_cast<unsigned>(pointers.size())),
               "polygon");
}

Geometry collection_geometry(const GeosScope& geos, int type, std::vector<Geometry> members) {
  std::vector<GEOSGeometry*> pointers = released(members);
  return owned(geos,
               GEOSGeom_createCollection_r(geos.handle(), type, pointers.data(),
                                           static_cast<unsigned>(pointers.size())),
               "collection");
}

Geometry multi_polygon_geometry(const GeosScope& geos, std::vector<Geometry> polygons) {
  return collection_geometry(geos, GEOS_MULTIPOLYGON, std::move(polygons));
}

std::vector<Eigen::Vector2d> points_of(const GeosScope& geos, const GEOSGeometry* line) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos.handle(), line);
  unsigned size = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(geos.handle(), sequence, &size) == 0) {
    geos.fail("coordinates");
  }
  std::vector<Eigen::Vector2d> points(size, Eigen::Vector2d::Zero());
  if (size > 0) {
    GEOSCoordSeq_copyToBuffer_r(geos.handle(), sequence, points.front().data(), 0, 0);
  }
  return points;
}

}  // namespace headland
