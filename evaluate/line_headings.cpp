#include "evaluate/line_headings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/arcs.h"

namespace headland {
namespace {

// What a corner stands for.
struct Bend {
  bool curve = false;  // one that the vehicle can follow
  bool whole = false;  // over half of both edges
  double radius_m = std::numeric_limits<double>::infinity();
  double curvature_per_m = 0.0;  // signed
  double tangent_rad = 0.0;      // by the circle through the corner and its neighbours
};

Bend bend_between(const EdgeHeading& before, const EdgeHeading& after, double least_radius_m) {
  const double turn_rad = wrap_angle(after.direction_rad - before.direction_rad);
  const double both_m = before.length_m + after.length_m;
  Bend bend;
  bend.radius_m = corner_radius_m(turn_rad, before.length_m, after.length_m);
  bend.curve = std::abs(turn_rad) <= kCurveCorner_rad && bend.radius_m >= least_radius_m;
  bend.curvature_per_m = 2.0 * turn_rad / both_m;
  bend.whole = bend.radius_m * std::abs(bend.curvature_per_m) > 1.0 - 1e-9 || turn_rad == 0.0;
  bend.tangent_rad = before.direction_rad + turn_rad * before.length_m / both_m;
  return bend;
}

double middle_of(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

}  // namespace

double corner_radius_m(double turn_rad, double edge_before_m, double edge_after_m) {
  constexpr double kStraight_rad = 1e-9;
  const double angle_rad = std::abs(turn_rad);
  if (angle_rad < kStraight_rad) return std::numeric_limits<double>::infinity();
  return std::min(0.5 * (edge_before_m + edge_after_m) / angle_rad,
                  kCornerTolerance_m / (1.0 / std::cos(0.5 * angle_rad) - 1.0));
}

std::vector<EdgeHeading> edge_headings(std::span<const Eigen::Vector2d> points_W,
                                       double least_radius_m) {
  std::vector<EdgeHeading> edges;
  for (std::size_t i = 1; i < points_W.size(); ++i) {
    const Eigen::Vector2d edge = points_W[i] - points_W[i - 1];
    edges.push_back({std::atan2(edge.y(), edge.x()), edge.norm()});
  }
  std::vector<Bend> bends(edges.size());  // before each edge; the first one has none
  for (std::size_t i = 1; i < edges.size(); ++i) {
    bends[i] = bend_between(edges[i - 1], edges[i], least_radius_m);
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Bend& bend = bends[i];
    if (!bend.curve) continue;
    EdgeHeading& before = edges[i - 1];
    EdgeHeading& after = edges[i];
    double tangent_rad = bend.tangent_rad;
    const bool between = i > 1 && i + 1 < edges.size();
    if (between && bends[i - 1].whole && bends[i - 1].curve && bends[i + 1].whole &&
        bends[i + 1].curve) {
      const auto near = [&](double angle_rad) {
        return tangent_rad + wrap_angle(angle_rad - tangent_rad);
      };
      tangent_rad = middle_of(
          tangent_rad,
          near(before.direction_rad + 0.5 * bends[i - 1].curvature_per_m * before.length_m),
          near(after.direction_rad - 0.5 * bends[i + 1].curvature_per_m * after.length_m));
    }
    const double reach_m = bend.whole
                               ? std::max(before.length_m, after.length_m)
                               : bend.radius_m * std::tan(0.25 * std::abs(bend.curvature_per_m) *
                                                          (before.length_m + after.length_m));
    before.end_off_rad = wrap_angle(tangent_rad - before.direction_rad);
    before.end_reach_m = std::min(0.5 * before.length_m, reach_m);
    after.begin_off_rad = wrap_angle(tangent_rad - after.direction_rad);
    after.begin_reach_m = std::min(0.5 * after.length_m, reach_m);
  }
  if (edges.size() > 1 && bends[1].whole) {
    edges.front().begin_off_rad = -edges.front().end_off_rad;
    edges.front().begin_reach_m = edges.front().end_reach_m;
  }
  if (edges.size() > 1 && bends.back().whole) {
    edges.back().end_off_rad = -edges.back().begin_off_rad;
    edges.back().end_reach_m = edges.back().begin_reach_m;
  }
  return edges;
}

double heading_on(const EdgeHeading& edge, double from_begin_m) {
  const auto share = [](double away_m, double reach_m) {
    return reach_m > 0.0 ? std::max(0.0, 1.0 - away_m / reach_m) : 0.0;
  };
  return wrap_angle(edge.direction_rad +
                    edge.begin_off_rad * share(from_begin_m, edge.begin_reach_m) +
                    edge.end_off_rad * share(edge.length_m - from_begin_m, edge.end_reach_m));
}

}  // namespace headland
