#include "planner/polygon.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

// Set operations work on a grid of a micrometre. On plain doubles GEOS 3.11 loses whole polygons
// without a word where edges coincide but for rounding, as those of neighbouring strips do.
constexpr double kGrid_m = 1e-6;

// One GEOS context with its last error. GEOS keeps no state outside it, so calls from several
// threads do not meet.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(handle_, &Geos::remember, &error_);
  }
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  Geos(Geos&&) = delete;
  Geos& operator=(Geos&&) = delete;

  GEOSContextHandle_t handle() const { return handle_; }

  [[noreturn]] void fail(const std::string& operation) const {
    throw InputError("polygon", operation, "", error_.empty() ? "GEOS gave no result" : error_);
  }

 private:
  static void remember(const char* message, void* error) {
    *static_cast<std::string*>(error) = message;
  }

  GEOSContextHandle_t handle_;
  std::string error_;
};

struct DestroyGeometry {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle, geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;

Geometry owned(const Geos& geos, GEOSGeometry* geometry, const char* operation) {
  if (geometry == nullptr) geos.fail(operation);
  return Geometry(geometry, DestroyGeometry{geos.handle()});
}

GEOSCoordSequence* sequence_of(const Geos& geos, const Polyline& points) {
  static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double));
  GEOSCoordSequence* sequence = GEOSCoordSeq_copyFromBuffer_r(
      geos.handle(), points.front().data(), static_cast<unsigned>(points.size()), 0, 0);
  if (sequence == nullptr) geos.fail("coordinates");
  return sequence;
}

Geometry geometry_of_line(const Geos& geos, const Polyline& line) {
  return owned(geos, GEOSGeom_createLineString_r(geos.handle(), sequence_of(geos, line)), "line");
}

Geometry geometry_of_ring(const Geos& geos, Ring ring) {
  ring.push_back(ring.front());
  return owned(geos, GEOSGeom_createLinearRing_r(geos.handle(), sequence_of(geos, ring)), "ring");
}

// GEOS takes over members only once all of them exist.
std::vector<GEOSGeometry*> released(std::vector<Geometry>& members) {
  std::vector<GEOSGeometry*> pointers;
  pointers.reserve(members.size());
  for (Geometry& member : members) pointers.push_back(member.release());
  return pointers;
}

Geometry geometry_of_part(const Geos& geos, const PolygonPart& part) {
  Geometry outer = geometry_of_ring(geos, part.outer);
  std::vector<Geometry> holes;
  holes.reserve(part.holes.size());
  for (const Ring& hole : part.holes) holes.push_back(geometry_of_ring(geos, hole));
  std::vector<GEOSGeometry*> pointers = released(holes);
  return owned(geos,
               GEOSGeom_createPolygon_r(geos.handle(), outer.release(), pointers.data(),
                                        static_cast<unsigned>(pointers.size())),
               "polygon");
}

Geometry geometry_of_parts(const Geos& geos, std::span<const PolygonSet> sets) {
  std::vector<Geometry> parts;
  for (const PolygonSet& set : sets) {
    for (const PolygonPart& part : set.parts) parts.push_back(geometry_of_part(geos, part));
  }
  std::vector<GEOSGeometry*> pointers = released(parts);
  return owned(geos,
               GEOSGeom_createCollection_r(geos.handle(), GEOS_MULTIPOLYGON, pointers.data(),
                                           static_cast<unsigned>(pointers.size())),
               "polygons");
}

Geometry geometry_of(const Geos& geos, const PolygonSet& set) {
  return geometry_of_parts(geos, std::span(&set, 1));
}

Polyline points_of(const Geos& geos, const GEOSGeometry* line) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos.handle(), line);
  unsigned size = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(geos.handle(), sequence, &size) == 0) {
    geos.fail("coordinates");
  }
  Polyline points(size, Eigen::Vector2d::Zero());
  if (size > 0) {
    GEOSCoordSeq_copyToBuffer_r(geos.handle(), sequence, points.front().data(), 0, 0);
  }
  return points;
}

Ring ring_of(const Geos& geos, const GEOSGeometry* geometry, bool counter_clockwise) {
  Ring ring = points_of(geos, geometry);
  ring.pop_back();
  if ((signed_area_m2(ring) > 0.0) != counter_clockwise) {
    std::reverse(ring.begin() + 1, ring.end());
  }
  return ring;
}

// Polygons of a geometry of any type; the points and lines in which polygons merely touch are left
// out.
void append_parts(const Geos& geos, const GEOSGeometry* geometry, std::vector<PolygonPart>& parts) {
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

PolygonSet set_of(const Geos& geos, const Geometry& geometry) {
  PolygonSet set;
  append_parts(geos, geometry.get(), set.parts);
  return set;
}

Ring circumscribed_circle(const Eigen::Vector2d& centre_W, double radius_m) {
  constexpr int kCorners = 4 * kQuadrantSegments;
  const double corner_radius_m = radius_m / std::cos(std::numbers::pi / kCorners);
  Ring ring;
  ring.reserve(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kCorners;
    ring.emplace_back(centre_W +
                      corner_radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return ring;
}

}  // namespace

PolygonSet from_field(const Field& field, double obstacle_margin_m) {
  PolygonSet ground{{PolygonPart{field.boundary, field.holes}}};
  if (field.obstacles.empty()) return ground;
  std::vector<PolygonSet> discs;
  for (const Obstacle& obstacle : field.obstacles) {
    const double radius_m = obstacle.radius_m + obstacle_margin_m;
    if (radius_m > 0.0) {
      discs.push_back({{PolygonPart{circumscribed_circle(obstacle.p_W, radius_m), {}}}});
    }
  }
  return difference(ground, united(discs));
}

PolygonSet buffered(const PolygonSet& set, double distance_m, Join join, int quadrant_segments) {
  const Geos geos;
  const int style = join == Join::kMitre ? GEOSBUF_JOIN_MITRE : GEOSBUF_JOIN_ROUND;
  return set_of(
      geos, owned(geos,
                  GEOSBufferWithStyle_r(geos.handle(), geometry_of(geos, set).get(), distance_m,
                                        quadrant_segments, GEOSBUF_CAP_ROUND, style, kMitreLimit),
                  "buffer"));
}

PolygonSet difference(const PolygonSet& a, const PolygonSet& b) {
  const Geos geos;
  return set_of(geos, owned(geos,
                            GEOSDifferencePrec_r(geos.handle(), geometry_of(geos, a).get(),
                                                 geometry_of(geos, b).get(), kGrid_m),
                            "difference"));
}

PolygonSet intersection(const PolygonSet& a, const PolygonSet& b) {
  const Geos geos;
  return set_of(geos, owned(geos,
                            GEOSIntersectionPrec_r(geos.handle(), geometry_of(geos, a).get(),
                                                   geometry_of(geos, b).get(), kGrid_m),
                            "intersection"));
}

PolygonSet united(std::span<const PolygonSet> sets) {
  const Geos geos;
  return set_of(
      geos,
      owned(geos, GEOSUnaryUnionPrec_r(geos.handle(), geometry_of_parts(geos, sets).get(), kGrid_m),
            "union"));
}

bool covers(const PolygonSet& whole, const PolygonSet& part) {
  if (part.parts.empty()) return true;
  const Geos geos;
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

PolygonSet strip(const Polyline& line, double width_m) {
  if (!(length_m(line) > 0.0)) return {};
  const Geos geos;
  return set_of(geos,
                owned(geos,
                      GEOSBufferWithStyle_r(geos.handle(), geometry_of_line(geos, line).get(),
                                            width_m / 2.0, kQuadrantSegments, GEOSBUF_CAP_FLAT,
                                            GEOSBUF_JOIN_ROUND, kMitreLimit),
                      "strip"));
}

std::vector<Polyline> clip_line(const Polyline& line, const PolygonSet& set) {
  if (!(length_m(line) > 0.0)) return {};
  const Geos geos;
  const Geometry geometry = geometry_of_line(geos, line);
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
