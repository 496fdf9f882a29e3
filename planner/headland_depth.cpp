#include "planner/headland_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace headland {
namespace {

double perimeter_m(const Ring& ring) {
  double sum_m = (ring.front() - ring.back()).norm();
  for (std::size_t i = 1; i < ring.size(); ++i) sum_m += (ring[i] - ring[i - 1]).norm();
  return sum_m;
}

// Ground outside arcs of radius_m that touch both edges of every convex corner.
double corners_cut_m2(const Ring& ring, double radius_m) {
  constexpr double kSharpest_rad = 2.8;  // a needle's area is bounded by its edges, not by the arc
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Eigen::Vector2d out = ring[(i + 1) % ring.size()] - ring[i];
    const double turn_rad = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    if (turn_rad <= 0.0) continue;
    const double half_rad = 0.5 * std::min(turn_rad, kSharpest_rad);
    sum_m2 += (std::tan(half_rad) - half_rad) * radius_m * radius_m;
  }
  return sum_m2;
}

}  // namespace

FirstRound first_round(const PlanRequest& request) {
  const double half_width_m = request.working_width_m / 2.0;
  FirstRound best;
  double least_m2 = std::numeric_limits<double>::infinity();
  constexpr int kChoices = 7;
  for (int choice = 0; choice < kChoices; ++choice) {
    FirstRound round;
    round.radius_m =
        request.turning_radius_m * (1.0 + (kWidestCorner - 1.0) * choice / (kChoices - 1));
    const double swing_m =
        std::hypot(round.radius_m + request.vehicle_width_m / 2.0, request.vehicle_front_m) -
        round.radius_m;
    round.distance_m = std::max(half_width_m, swing_m + request.clearance_m + kRingMargin_m);
    const double unworked_m2 =
        (round.distance_m - half_width_m) * perimeter_m(request.field.boundary) +
        corners_cut_m2(request.field.boundary, round.radius_m + round.distance_m);
    if (unworked_m2 < least_m2) {
      least_m2 = unworked_m2;
      best = round;
    }
  }
  return best;
}

double turning_depth_m(const PlanRequest& request) {
  const double radius_m = request.turning_radius_m;
  const double apart_m = radius_m + request.working_width_m / 2.0;
  const double bulb_m = request.forward_only && apart_m < 2.0 * radius_m
                            ? std::sqrt(4.0 * radius_m * radius_m - apart_m * apart_m)
                            : 0.0;
  return std::max(request.vehicle_rear_m, -request.implement_x_B_m) + bulb_m +
         std::max(radius_m + request.working_width_m / 2.0,
                  std::hypot(radius_m + request.vehicle_width_m / 2.0, request.vehicle_front_m)) +
         request.clearance_m;
}

int rounds_for_turning(const PlanRequest& request) {
  const double outside_m = first_round(request).distance_m - request.working_width_m / 2.0;
  return std::max(1, static_cast<int>(std::ceil((turning_depth_m(request) - outside_m) /
                                                request.working_width_m)));
}

}  // namespace headland
