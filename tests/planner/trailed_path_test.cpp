// Paths for a trailed implement: nothing in reverse, and straight by the time the implement works.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/connection.h"
#include "planner/drivable_path.h"
#include "planner/headland_rings.h"
#include "planner/hybrid_a_star.h"
#include "planner/turns.h"
#include "planner/work_line.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

constexpr double kTrailedRadius_m = 2.6;

Vehicle trailed_vehicle(double working_width_m) {
  Vehicle vehicle = made_up_vehicle(kTrailedRadius_m, working_width_m);
  vehicle.implement.x_B_m = -3.0;
  vehicle.implement.trailing.emplace();
  vehicle.implement.trailing->hitch_x_B_m = -0.7;
  vehicle.implement.trailing->drawbar_length_m = 2.0;
  return vehicle;
}

Field trailed_field(double width_m, double height_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  return field;
}

bool reverses(const std::vector<Arc>& arcs) { return reverse_length_m(arcs) > 0.0; }

TEST(TrailedPath, ForwardTurnsAreTheDubinsCurvesAlone) {
  const Pose from{{0.0, 0.0}, 0.5 * std::numbers::pi};
  const Pose to{{2.0, 0.0}, -0.5 * std::numbers::pi};
  const auto forward = turns(from, to, kTrailedRadius_m, Gears::kForwardOnly);
  ASSERT_FALSE(forward.empty());
  for (const Turn& turn : forward) EXPECT_FALSE(reverses(turn.arcs));
  EXPECT_NEAR(forward.front().cost_m, forward_length_m(from, to, kTrailedRadius_m), 1e-9);
  // The omega turn, R (3 pi - 4 asin((2 R + w) / 4 R)), with w the distance of the lines.
  const double r = kTrailedRadius_m;
  EXPECT_NEAR(forward.front().cost_m,
              r * (3.0 * std::numbers::pi - 4.0 * std::asin((2.0 * r + 2.0) / (4.0 * r))), 1e-9);
  for (const Turn& turn : turns_with_run_outs(from, to, r, Gears::kForwardOnly)) {
    EXPECT_FALSE(reverses(turn.arcs));
  }
  // Negative control: with both gears some reverse.
  EXPECT_TRUE(std::ranges::any_of(turns(from, to, r),
                                  [](const Turn& turn) { return reverses(turn.arcs); }));
}

TEST(TrailedPath, RoutesAroundObstaclesDriveForwardOnly) {
  Field field = trailed_field(60.0, 30.0);
  field.holes = {{{25.0, 5.0}, {25.0, 25.0}, {35.0, 25.0}, {35.0, 5.0}}};
  for (const Gears gears : {Gears::kForwardOnly, Gears::kBoth}) {
    Hull hull = hull_of(made_up_vehicle(kTrailedRadius_m, 2.0));
    hull.gears = gears;
    const FreeSpace space = free_space(field, hull);
    RouteOptions options;
    options.radius_m = kTrailedRadius_m;
    // Into the corner behind it: with reverse gear the way back is short.
    const auto route =
        find_route(space, {{20.0, 15.0}, 0.0}, {{40.0, 15.0}, 0.0}, options, nullptr);
    ASSERT_TRUE(route.has_value());
    EXPECT_TRUE(fits_along(space, {{20.0, 15.0}, 0.0}, *route, 0.0));
    if (gears == Gears::kForwardOnly) {
      EXPECT_FALSE(reverses(*route));
    }
  }
}

// Swaths two of which need an omega turn, ends level, in a field with room.
Plan trailed_swaths(double width_m) {
  Plan plan;
  plan.headland_width_m = 1.0;  // no end reaches into it: none is cut back
  plan.passes = {{PassKind::kSwath, {{40.0, 25.0}, {40.0, 75.0}}},
                 {PassKind::kSwath, {{40.0 + width_m, 75.0}, {40.0 + width_m, 25.0}}}};
  return plan;
}

TEST(TrailedPath, TurnsForwardAndComesInStraight) {
  const Vehicle vehicle = trailed_vehicle(2.0);
  const Path path = make_path(trailed_field(100.0, 100.0), vehicle, trailed_swaths(2.0), {});
  double straight_m = 0.0;
  PathPoint at_work;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const PathSegment& segment = path.segments[i];
    EXPECT_EQ(segment.gear, Gear::kForward);
    if (!segment.implement_down || i == 0) continue;
    at_work = segment.points.front();
    const std::vector<PathPoint>& turn = path.segments[i - 1].points;
    for (std::size_t k = turn.size() - 1; k > 0; --k) {
      if (std::abs(wrap_angle(turn[k - 1].heading_rad - at_work.heading_rad)) > 1e-9) break;
      straight_m = (turn[k - 1].p_W - at_work.p_W).norm();
    }
  }
  // The second swath is entered downwards: the implement, 3 m behind, starts at its begin ...
  EXPECT_NEAR(at_work.p_W.y(), 75.0 - 3.0, 1e-6);
  // ... after 6 m of straight line, which begin as far out as the first swath was driven past.
  EXPECT_NEAR(straight_m, run_in_m(vehicle), kPathSpacing_m);
  EXPECT_EQ(run_in_m(made_up_vehicle(2.6, 2.0)), 0.0);
}

TEST(TrailedPath, HeadlandIsAsDeepAsTheForwardTurnNeeds) {
  const Vehicle vehicle = trailed_vehicle(2.0);
  PlanRequest request;
  request.working_width_m = 2.0;
  request.turning_radius_m = kTrailedRadius_m;
  request.vehicle_width_m = vehicle.body.width_m;
  request.vehicle_front_m = 2.4;
  request.vehicle_rear_m = 3.0;
  const double both_m = turning_depth_m(request);
  request.forward_only = true;
  const double forward_m = turning_depth_m(request);
  EXPECT_NEAR(forward_m - both_m, std::sqrt(5.2 * 5.2 - 3.6 * 3.6), 1e-9);
  request.working_width_m = 6.0;  // wider than two radii: the plain U-turn
  const double wide_m = turning_depth_m(request);
  request.forward_only = false;
  EXPECT_EQ(wide_m, turning_depth_m(request));
  // And it is what the omega turn takes: with a metre less the way back is a longer one.
  const auto turn_m = [&](double depth_m) {
    const Field field = trailed_field(100.0, 75.0 + depth_m);
    const Path path = make_path(field, vehicle, trailed_swaths(2.0), {});
    return length_m(path.segments[2]) - run_in_m(vehicle);  // after run-in and swath
  };
  const double r = kTrailedRadius_m;
  const double omega_m =
      r * (3.0 * std::numbers::pi - 4.0 * std::asin((2.0 * r + 2.0) / (4.0 * r)));
  constexpr double kRounding_m = 0.02;  // of boundaries and of where fitting is looked at
  EXPECT_NEAR(turn_m(forward_m + kRounding_m), omega_m, 2.0 * kPathSpacing_m);
  EXPECT_GT(turn_m(forward_m - 1.0), omega_m + 2.0);
}

}  // namespace
}  // namespace headland
