#include "planner/headland_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planner/free_space.h"
#include "planner/headland_by_edge.h"
#include "planner/outline.h"

namespace headland {
namespace {

// Rounding, clearance slack and filter may add up to this [part of the turning radius].
constexpr double kRingErrorPerRadius = 0.035;

// The implement may hang over the boundary but not into obstacles, whatever a ring's error.
double obstacle_margin_m(const PlanRequest& request, double first_m) {
  const double ring_error_m = kRingErrorPerRadius * request.turning_radius_m;
  return std::max(0.0, 0.5 * request.working_width_m + kObstacleClearances * request.clearance_m +
                           ring_error_m - first_m);
}

}  // namespace

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
