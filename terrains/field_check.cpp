#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "terrains/field_source.h"
#include "terrains/input_error.h"
#include "terrains/ring_fault.h"

namespace headland {
namespace {

std::string hole_name(std::size_t index) { return fmt::format("hole {}", index + 1); }

[[noreturn]] void refuse(const Field& field, const std::string& source, const std::string& where,
                         const Eigen::Vector2d& p_W, const std::string& what) {
  throw InputError(source, where, "", what + " at " + place_text(field.frame, p_W));
}

void require_finite(const std::string& source, const std::string& where, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].allFinite()) continue;
    throw InputError(source, fmt::format("{} point {}", where, i + 1),
                     fmt::format("{}, {}", ring[i].x(), ring[i].y()), "not a finite coordinate");
  }
}

void merge_repeated_points(Ring& ring) {
  const auto same = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() <= kSamePlace_m;
  };
  ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
  while (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
}

// Whether no point is further than kSamePlace_m from one line.
bool on_one_line(const Ring& ring) {
  const auto far = std::ranges::max_element(
      ring, {}, [&](const Eigen::Vector2d& p_W) { return (p_W - ring.front()).squaredNorm(); });
  const Eigen::Vector2d along = (*far - ring.front()).normalized();
  return std::ranges::all_of(ring, [&](const Eigen::Vector2d& p_W) {
    const Eigen::Vector2d to = p_W - ring.front();
    return std::abs(along.x() * to.y() - along.y() * to.x()) <= kSamePlace_m;
  });
}

void require_area(const Field& field, const std::string& source, const std::string& where,
                  const Ring& ring) {
  if (ring.size() < 3) {
    throw InputError(source, where, fmt::format("{} points", ring.size()),
                     "bounds no area; give at least three different points");
  }
  if (on_one_line(ring)) {
    throw InputError(source, where, fmt::format("{} points", ring.size()),
                     "the points lie on one line and bound no area");
  }
  if (const std::optional<RingFault> fault = ring_fault(ring)) {
    refuse(field, source, where, fault->p_W, fault->reason);
  }
}

void require_field_size(const Field& field, const std::string& source) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : field.boundary) box.extend(p_W);
  const double extent_m = field.boundary.empty() ? 0.0 : box.sizes().maxCoeff();
  const std::string value = fmt::format("{:.3g} m across", extent_m);
  if (!field.boundary.empty() && extent_m < kMinFieldExtent_m) {
    throw InputError(source, "boundary", value,
                     fmt::format("too small for a field (at least {} m); coordinates in degrees "
                                 "need crs: EPSG:4326",
                                 kMinFieldExtent_m));
  }
  if (extent_m > kMaxFieldExtent_m) {
    throw InputError(source, "boundary", value,
                     fmt::format("too large for one field (at most {} m); is the crs right?",
                                 kMaxFieldExtent_m));
  }
}

// Every ring is already valid by itself.
void check_holes(const Field& field, const std::string& source) {
  Field shell;
  shell.boundary = field.boundary;
  for (std::size_t i = 0; i < field.holes.size(); ++i) {
    const Ring& hole = field.holes[i];
    if (const auto p_W = meeting_place(hole, field.boundary, kSamePlace_m)) {
      refuse(field, source, hole_name(i), *p_W, "crosses or touches the boundary");
    }
    if (!inside_field(shell, hole.front())) {
      refuse(field, source, hole_name(i), hole.front(), "lies outside the boundary");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto p_W = meeting_place(hole, field.holes[j], kSamePlace_m)) {
        refuse(field, source, hole_name(i), *p_W, "crosses or touches " + hole_name(j));
      }
      Field other;
      other.boundary = field.holes[j];
      Field itself;
      itself.boundary = hole;
      if (inside_field(other, hole.front())) {
        refuse(field, source, hole_name(i), hole.front(), "lies inside " + hole_name(j));
      }
      if (inside_field(itself, field.holes[j].front())) {
        refuse(field, source, hole_name(j), field.holes[j].front(), "lies inside " + hole_name(i));
      }
    }
  }
}

void require_size(const std::string& source, const std::string& where, double size_m,
                  double least_m, double most_m) {
  if (size_m >= least_m && size_m <= most_m) return;
  throw InputError(source, where, fmt::format("{}", size_m),
                   fmt::format("from {} to {} m", least_m, most_m));
}

}  // namespace

void check_obstacle(const Field& field, const Obstacle& obstacle, const std::string& source,
                    const std::string& where) {
  Field shell;
  shell.boundary = field.boundary;
  const Eigen::Vector2d end_W = obstacle.p_W + obstacle.run_W;
  require_finite(source, where, {obstacle.p_W, end_W});
  require_size(source, where + ".height_m", obstacle.height_m, kMinObstacle_m,
               kMaxObstacleHeight_m);
  if (!runs_along_line(obstacle.kind)) {
    require_size(source, where + ".radius_m", obstacle.radius_m, kMinObstacle_m,
                 kMaxObstacleRadius_m);
    if (!inside_field(shell, obstacle.p_W)) {
      refuse(field, source, where, obstacle.p_W, "lies outside the boundary");
    }
    return;
  }
  require_size(source, where + ".thickness_m", 2.0 * obstacle.radius_m, kMinThickness_m,
               kMaxThickness_m);
  for (const Eigen::Vector2d& p_W : {obstacle.p_W, end_W}) {
    const double clearance_m = field_clearance_m(shell, p_W);
    if (clearance_m >= -kObstacleReach_m) continue;
    refuse(field, source, where, p_W,
           fmt::format("lies {:.0f} m outside the boundary (at most {:g} m)", -clearance_m,
                       kObstacleReach_m));
  }
}

void check_field(Field& field, const std::string& source) {
  require_finite(source, "boundary", field.boundary);
  require_field_size(field, source);
  merge_repeated_points(field.boundary);
  require_area(field, source, "boundary", field.boundary);
  if (signed_area_m2(field.boundary) < 0.0) std::ranges::reverse(field.boundary);
  for (std::size_t i = 0; i < field.holes.size(); ++i) {
    Ring& hole = field.holes[i];
    require_finite(source, hole_name(i), hole);
    merge_repeated_points(hole);
    require_area(field, source, hole_name(i), hole);
    if (signed_area_m2(hole) > 0.0) std::ranges::reverse(hole);
  }
  check_holes(field, source);
  const auto pieces = std::ranges::count_if(
      field.obstacles, [](const Obstacle& obstacle) { return runs_along_line(obstacle.kind); });
  if (pieces > kMostWallPieces) {
    throw InputError(source, "obstacles", fmt::format("{}", pieces),
                     fmt::format("at most {} straight pieces of walls and fences; leave out points "
                                 "that hardly bend them",
                                 kMostWallPieces));
  }
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    check_obstacle(field, field.obstacles[i], source, fmt::format("obstacles[{}]", i));
  }
}

void check_to_work(Field& field, const std::string& source) {
  for (std::size_t i = 0; i < field.to_work.size(); ++i) {
    const std::string name = fmt::format("to_work {}", i + 1);
    require_finite(source, name, field.to_work[i]);
    merge_repeated_points(field.to_work[i]);
    require_area(field, source, name, field.to_work[i]);
  }
}

void check_entry(const Field& field, const std::string& source, const std::string& where) {
  if (!field.entry_W) return;
  require_finite(source, where, {*field.entry_W});
  const double clearance_m = field_clearance_m(field, *field.entry_W);
  if (clearance_m < -kEntryTolerance_m) {
    refuse(field, source, where, *field.entry_W,
           fmt::format("lies {:.1f} m outside the field (at most {} m)", -clearance_m,
                       kEntryTolerance_m));
  }
}

}  // namespace headland
