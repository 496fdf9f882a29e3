#include "planner/arcs.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

// Below this turned angle the chord formula loses digits and the line's is exact enough.
constexpr double kStraightAngle_rad = 1e-9;

double sign_of(Gear gear) { return gear == Gear::kForward ? 1.0 : -1.0; }

// Way of a clothoid from a pose that heads along x, by quadrature: with 15 places and no more than
// kMostTurned_rad of turning at once it is exact to rounding.
constexpr double kMostTurned_rad = 1.5;

Pose along_clothoid(const Pose& from, const Arc& arc, double distance_m) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const double sign = sign_of(arc.gear);
  const auto heading_at = [&](double s_m) {
    return from.heading_rad + sign * s_m * (arc.curvature_per_m + 0.5 * arc.sharpness_per_m2 * s_m);
  };
  const double most_per_m =
      std::max(std::abs(arc.curvature_per_m),
               std::abs(arc.curvature_per_m + arc.sharpness_per_m2 * distance_m));
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(most_per_m * distance_m / kMostTurned_rad)));
  const double half_m = 0.5 * distance_m / pieces;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int piece = 0; piece < pieces; ++piece) {
    const double middle_m = (2 * piece + 1) * half_m;
    // Its first place is the middle.
    sum += Rule::weights()[0] * direction_of(heading_at(middle_m));
    for (std::size_t i = 1; i < Rule::abscissa().size(); ++i) {
      const double off_m = half_m * Rule::abscissa()[i];
      sum += Rule::weights()[i] * (direction_of(heading_at(middle_m - off_m)) +
                                   direction_of(heading_at(middle_m + off_m)));
    }
  }
  return {from.p_W + sign * half_m * sum, wrap_angle(heading_at(distance_m))};
}

}  // namespace

double end_curvature_per_m(const Arc& arc) {
  return arc.curvature_per_m + arc.sharpness_per_m2 * arc.length_m;
}

double wrap_angle(double angle_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double wrapped = angle_rad - kTurn * std::floor((angle_rad + std::numbers::pi) / kTurn);
  return wrapped >= std::numbers::pi ? wrapped - kTurn : wrapped;
}

Eigen::Vector2d direction_of(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

Eigen::Vector2d left_of(double heading_rad) {
  return {-std::sin(heading_rad), std::cos(heading_rad)};
}

Pose pose_along(const Pose& from, const Arc& arc, double distance_m) {
  if (arc.sharpness_per_m2 != 0.0) return along_clothoid(from, arc, distance_m);
  const double signed_m = sign_of(arc.gear) * distance_m;
  const double turned_rad = signed_m * arc.curvature_per_m;
  if (std::abs(turned_rad) < kStraightAngle_rad) {
    return {from.p_W + signed_m * direction_of(from.heading_rad), from.heading_rad + turned_rad};
  }
  const double heading_rad = from.heading_rad + turned_rad;
  const double radius_m = 1.0 / arc.curvature_per_m;
  return {from.p_W + radius_m * (left_of(from.heading_rad) - left_of(heading_rad)),
          wrap_angle(heading_rad)};
}

Pose end_of(const Pose& from, const std::vector<Arc>& arcs) {
  Pose pose = from;
  for (const Arc& arc : arcs) pose = pose_along(pose, arc, arc.length_m);
  return pose;
}

std::vector<Arc> driven_back(const std::vector<Arc>& arcs) {
  std::vector<Arc> back(arcs.rbegin(), arcs.rend());
  for (Arc& arc : back) {
    arc.curvature_per_m = end_curvature_per_m(arc);
    arc.sharpness_per_m2 = -arc.sharpness_per_m2;
    arc.gear = arc.gear == Gear::kForward ? Gear::kReverse : Gear::kForward;
  }
  return back;
}

Pose begin_pose(const std::vector<Eigen::Vector2d>& line_W) {
  const Eigen::Vector2d along = line_W[1] - line_W[0];
  return {line_W.front(), std::atan2(along.y(), along.x())};
}

Pose end_pose(const std::vector<Eigen::Vector2d>& line_W) {
  const Eigen::Vector2d along = line_W.back() - line_W[line_W.size() - 2];
  return {line_W.back(), std::atan2(along.y(), along.x())};
}

double length_m(const std::vector<Arc>& arcs) {
  double sum_m = 0.0;
  for (const Arc& arc : arcs) sum_m += arc.length_m;
  return sum_m;
}

double reverse_length_m(const std::vector<Arc>& arcs) {
  double sum_m = 0.0;
  for (const Arc& arc : arcs) {
    if (arc.gear == Gear::kReverse) sum_m += arc.length_m;
  }
  return sum_m;
}

int cusp_count(const std::vector<Arc>& arcs) {
  int cusps = 0;
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    if (arcs[i].gear != arcs[i - 1].gear) ++cusps;
  }
  return cusps;
}

std::vector<PathSegment> sample(const Pose& from, const std::vector<Arc>& arcs, double spacing_m) {
  std::vector<PathSegment> segments;
  Pose pose = from;
  for (const Arc& arc : arcs) {
    if (arc.length_m <= 0.0) continue;
    if (segments.empty() || segments.back().gear != arc.gear) {
      segments.emplace_back();
      segments.back().kind = PathKind::kTurn;
      segments.back().gear = arc.gear;
      segments.back().points.push_back(
          {pose.p_W, wrap_angle(pose.heading_rad), arc.curvature_per_m});
    } else {
      segments.back().points.back().curvature_per_m = arc.curvature_per_m;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(arc.length_m / spacing_m)));
    for (int i = 1; i <= steps; ++i) {
      const Pose at = pose_along(pose, arc, arc.length_m * i / steps);
      const double curvature_per_m =
          arc.curvature_per_m + arc.sharpness_per_m2 * arc.length_m * i / steps;
      segments.back().points.push_back({at.p_W, wrap_angle(at.heading_rad), curvature_per_m});
    }
    pose = pose_along(pose, arc, arc.length_m);
  }
  return segments;
}

}  // namespace headland
