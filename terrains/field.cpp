#include "terrains/field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace headland {
namespace {

// Crossing number and nearest edge in the same walk around the ring: the callers want both.
struct RingView {
  bool inside = false;
  double nearest_squared_m2 = std::numeric_limits<double>::infinity();
};

bool crosses_ray(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p_W) {
  if ((a.y() > p_W.y()) == (b.y() > p_W.y())) return false;
  return p_W.x() < a.x() + (p_W.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

double squared_distance_m2(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                           const Eigen::Vector2d& p_W) {
  const Eigen::Vector2d edge = b - a;
  const Eigen::Vector2d to_p = p_W - a;
  const double length_squared = edge.squaredNorm();
  const double along =
      length_squared > 0.0 ? std::clamp(edge.dot(to_p) / length_squared, 0.0, 1.0) : 0.0;
  return (to_p - along * edge).squaredNorm();
}

RingView view_ring(const Ring& ring, const Eigen::Vector2d& p_W) {
  RingView view;
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
    if (crosses_ray(ring[before], ring[i], p_W)) view.inside = !view.inside;
    view.nearest_squared_m2 =
        std::min(view.nearest_squared_m2, squared_distance_m2(ring[before], ring[i], p_W));
  }
  return view;
}

}  // namespace

double signed_area_m2(const Ring& ring) {
  // Taken about the first point: coordinates of a projected CRS would cost seven digits.
  double twice_m2 = 0.0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i - 1] - ring[0];
    const Eigen::Vector2d b = ring[i] - ring[0];
    twice_m2 += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice_m2;
}

double field_area_m2(const Field& field) {
  double area_m2 = std::abs(signed_area_m2(field.boundary));
  for (const Ring& hole : field.holes) area_m2 -= std::abs(signed_area_m2(hole));
  return area_m2;
}

bool inside_ring(const Ring& ring, const Eigen::Vector2d& p_W) {
  bool inside = false;
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
    if (crosses_ray(ring[before], ring[i], p_W)) inside = !inside;
  }
  return inside;
}

bool inside_field(const Field& field, const Eigen::Vector2d& p_W) {
  return inside_ring(field.boundary, p_W) &&
         std::ranges::none_of(field.holes,
                              [&](const Ring& hole) { return inside_ring(hole, p_W); });
}

double field_clearance_m(const Field& field, const Eigen::Vector2d& p_W) {
  RingView view = view_ring(field.boundary, p_W);
  for (const Ring& hole : field.holes) {
    const RingView in_hole = view_ring(hole, p_W);
    view.inside = view.inside && !in_hole.inside;
    view.nearest_squared_m2 = std::min(view.nearest_squared_m2, in_hole.nearest_squared_m2);
  }
  const double distance_m = std::sqrt(view.nearest_squared_m2);
  return view.inside ? distance_m : -distance_m;
}

Eigen::Vector2d nearest_of(const Obstacle& obstacle, const Eigen::Vector2d& p_W) {
  const double squared = obstacle.run_W.squaredNorm();
  if (squared == 0.0) return obstacle.p_W;
  const double t = std::clamp((p_W - obstacle.p_W).dot(obstacle.run_W) / squared, 0.0, 1.0);
  return obstacle.p_W + t * obstacle.run_W;
}

double obstacle_gap_m(const Obstacle& obstacle, const Eigen::Vector2d& p_W) {
  return (p_W - nearest_of(obstacle, p_W)).norm() - obstacle.radius_m;
}

std::string_view obstacle_kind_name(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::kTree:
      return "tree";
    case ObstacleKind::kPole:
      return "pole";
    case ObstacleKind::kRock:
      return "rock";
    case ObstacleKind::kWall:
      return "wall";
    case ObstacleKind::kFence:
      return "fence";
  }
  return "";
}

}  // namespace headland
