#include "planner/headland_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/free_space.h"
#include "planner/headland_by_edge.h"
#include "planner/outline.h"

namespace headland {
namespace {

// Rounding, clearance slack and filter may add up to this [part of the turning radius].
constexpr double kRingErrorPerRadius = 0.035;

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

// The implement may hang over the boundary but not into obstacles, whatever a ring's error.
double obstacle_margin_m(const PlanRequest& request, double first_m) {
  const double ring_error_m = kRingErrorPerRadius * request.turning_radius_m;
  return std::max(0.0, 0.5 * request.working_width_m + kObstacleClearances * request.clearance_m +
                           ring_error_m - first_m);
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

void refuse_headland(const PlanRequest& request, const PolygonSet& field, const FirstRound& first) {
  const Disc widest = widest_disc(field);
  throw PlanInfeasible(fmt::format(
      "the turning radius fits nowhere: a round inside the boundary needs ground {:.1f} m wide "
      "(working width {:.2f} m, turning radius {:.2f} m, clearance {:.2f} m); the widest is "
      "{:.1f} m at ({:.1f}, {:.1f}) m",
      2.0 * (first.distance_m + kRadiusMargin * first.radius_m), request.working_width_m,
      request.turning_radius_m, request.clearance_m, 2.0 * widest.radius_m, widest.centre_W.x(),
      widest.centre_W.y()));
}

HeadlandRound round_of_all(const PlanRequest& request, const PolygonSet& field,
                           const FirstRound& first, int round) {
  const double distance_m = first.distance_m + round * request.working_width_m;
  const double radius_m = kRadiusMargin * request.turning_radius_m;
  const double corner_radius_m = round == 0 ? kRadiusMargin * first.radius_m : radius_m;
  // A corner that sticks into the ground is passed at constant distance where the vehicle can
  // follow that arc, else along its sharp offset, rounded.
  const Join join = distance_m < radius_m ? Join::kMitre : Join::kRound;
  return round_along(buffered(field, -distance_m, join), round,
                     {radius_m, corner_radius_m, field, first.distance_m}, request);
}

Headland make_headland(const PlanRequest& request, int rounds) {
  const double width_m = request.working_width_m;
  const FirstRound first = first_round(request);
  const double first_m = first.distance_m;
  const PolygonSet field = from_field(request.field, obstacle_margin_m(request, first_m));
  Headland headland = headland_ground(request, field, rounds, first_m);
  if (differs_by_edge(headland)) {
    add_rounds_by_edge(request, field, first, headland);
    return headland;
  }
  std::vector<PolygonSet> inner{headland.inner};
  PolygonSet inside_before;
  // What rounds leave in their corners gets short swaths of its own, where there is no room to come
  // round to without reversing.
  const bool corners_are_worked = !request.forward_only;
  // What rounds leave is measured on fewer points than they are driven on.
  const auto beside = [&](const PolygonSet& ground, double distance_m) {
    return simplified(buffered(ground, distance_m, Join::kRound), kOutlineTolerance_m);
  };
  for (int round = 0; round < headland.rounds; ++round) {
    stop_if(request.cancelled);
    const HeadlandRound made = round_of_all(request, field, first, round);
    headland.rings.insert(headland.rings.end(), made.rings.begin(), made.rings.end());
    if (round > 0 && corners_are_worked) {
      inner.push_back(
          worth_working(difference(inside_before, beside(made.ground, width_m / 2.0)), width_m));
    }
    inside_before = beside(made.ground, -width_m / 2.0);
  }
  if (corners_are_worked) {
    inner.push_back(worth_working(difference(inside_before, headland.inner), width_m));
  }
  headland.inner = united(inner);
  if (headland.rings.empty()) refuse_headland(request, field, first);
  return headland;
}

}  // namespace headland
