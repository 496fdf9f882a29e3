#include "planner/headland_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planner/ring_smoothing.h"

namespace headland {
namespace {

// Rounding is done with a larger radius, because filtering tightens a circle of radius R by
// sigma^2 / (2 R^2) = 0.5 % and leaves about 1 % of ripple.
constexpr double kRadiusMargin = 1.03;
constexpr double kFilterSigmaPerRadius = 0.1;
// Slivers between a rounded ring and an offset of the field are thinner than this [part of the
// working width].
constexpr double kSliverPerWidth = 1.0 / 16.0;

void append_rings(const PolygonSet& ground, int round, double turning_radius_m,
                  std::vector<HeadlandRing>& rings) {
  const double sigma_m = kFilterSigmaPerRadius * turning_radius_m;
  for (const PolygonPart& part : ground.parts) {
    rings.push_back({round, false, smoothed_ring(part.outer, sigma_m)});
    for (const Ring& hole : part.holes) {
      rings.push_back({round, true, smoothed_ring(hole, sigma_m)});
    }
  }
}

// Pieces of `ground` that are more than slivers and crumbs.
PolygonSet worth_working(const PolygonSet& ground, double width_m) {
  const double sliver_m = kSliverPerWidth * width_m;
  const PolygonSet opened =
      buffered(buffered(ground, -sliver_m, Join::kMitre), sliver_m, Join::kMitre);
  PolygonSet kept;
  for (const PolygonPart& part : opened.parts) {
    if (area_m2({{part}}) > width_m * width_m) kept.parts.push_back(part);
  }
  return kept;
}

}  // namespace

double first_ring_distance_m(const PlanRequest& request) {
  return std::max(request.working_width_m / 2.0,
                  request.vehicle_width_m > request.working_width_m
                      ? request.vehicle_width_m / 2.0 + kHullClearance_m
                      : 0.0);
}

double turning_depth_m(const PlanRequest& request) {
  const double radius_m = request.turning_radius_m;
  return request.vehicle_rear_m +
         std::max(radius_m + request.working_width_m / 2.0,
                  std::hypot(radius_m + request.vehicle_width_m / 2.0, request.vehicle_front_m));
}

int rounds_for_turning(const PlanRequest& request) {
  const double outside_m = first_ring_distance_m(request) - request.working_width_m / 2.0;
  return std::max(1, static_cast<int>(std::ceil((turning_depth_m(request) - outside_m) /
                                                request.working_width_m)));
}

Headland make_headland(const PlanRequest& request, int rounds) {
  const double width_m = request.working_width_m;
  const double first_m = first_ring_distance_m(request);
  const double radius_m = kRadiusMargin * request.turning_radius_m;
  const PolygonSet field = from_field(request.field);

  Headland headland;
  headland.width_m = first_m + (rounds - 0.5) * width_m;
  headland.drivable = buffered(field, -first_m, Join::kRound);
  headland.inner = buffered(field, -headland.width_m, Join::kRound);
  std::vector<PolygonSet> inner{headland.inner};
  PolygonSet inside_before;
  for (int round = 0; round < rounds; ++round) {
    const double distance_m = first_m + round * width_m;
    // A corner that sticks into the ground is passed at constant distance where the vehicle can
    // follow that arc, else along its sharp offset, rounded.
    const Join join = distance_m < radius_m ? Join::kMitre : Join::kRound;
    const PolygonSet ground = rounded(buffered(field, -distance_m, join), radius_m, field, first_m);
    append_rings(ground, round, request.turning_radius_m, headland.rings);
    if (round > 0) {
      inner.push_back(worth_working(
          difference(inside_before, buffered(ground, width_m / 2.0, Join::kRound)), width_m));
    }
    inside_before = buffered(ground, -width_m / 2.0, Join::kRound);
  }
  inner.push_back(worth_working(difference(inside_before, headland.inner), width_m));
  headland.inner = united(inner);
  if (headland.rings.empty()) {
    throw PlanInfeasible(fmt::format(
        "the turning radius fits nowhere: a round inside the boundary needs ground {:.1f} m wide "
        "(working width {:.2f} m, turning radius {:.2f} m)",
        2.0 * (first_m + radius_m), width_m, request.turning_radius_m));
  }
  return headland;
}

}  // namespace headland
