// GEOS with owners: a context, geometries that are freed, rings and lines handed over and back.
#pragma once

#include <geos_c.h>

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "terrains/field.h"

namespace headland {

// One GEOS context with its last error. GEOS keeps no state outside it, so calls from several
// threads do not meet.
class GeosScope {
 public:
  GeosScope();
  ~GeosScope();
  GeosScope(const GeosScope&) = delete;
  GeosScope& operator=(const GeosScope&) = delete;

  GEOSContextHandle_t handle() const { return handle_; }

  // Throws InputError with what GEOS said last.
  [[noreturn]] void fail(const char* operation) const;

 private:
  GEOSContextHandle_t handle_;
  std::string error_;
};

struct DestroyGeometry {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle, geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;

// Takes over what a GEOS function returned. Throws InputError when that is nothing.
Geometry owned(const GeosScope& geos, GEOSGeometry* geometry, const char* operation);

// Points in their order, at least two.
Geometry line_geometry(const GeosScope& geos, const std::vector<Eigen::Vector2d>& points);
// Rings do not repeat their first point and have at least three.
Geometry ring_geometry(const GeosScope& geos, const Ring& ring);
Geometry polygon_geometry(const GeosScope& geos, const Ring& outer, std::span<const Ring> holes);
// Of a collecting type of GEOS, such as GEOS_GEOMETRYCOLLECTION.
Geometry collection_geometry(const GeosScope& geos, int type, std::vector<Geometry> members);
Geometry multi_polygon_geometry(const GeosScope& geos, std::vector<Geometry> polygons);

// The points of a line or a closed ring; the ring's first one is also its last.
std::vector<Eigen::Vector2d> points_of(const GeosScope& geos, const GEOSGeometry* line);

}  // namespace headland
