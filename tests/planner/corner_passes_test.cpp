// Headland passes into corners, and passes over what rounds and swaths leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/algorithms/boustrophedon.h"
#include "planner/edge_passes.h"
#include "planner/fill_passes.h"
#include "planner/work_line.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

struct Edged {
  PlanRequest request;
  FreeSpace space;
  WorkedGround ground;

  explicit Edged(const Field& field)
      : request(transplanter_request(field, "boustrophedon")),
        space(free_space(field, hull_of(request))),
        ground(ground_to_work(field)) {}

  std::vector<EdgePass> round(double distance_m) {
    return edge_round(request, space, from_field(request.field, request.clearance_m), distance_m, 0,
                      {0.0, 0.5}, ground);
  }
};

void expect_inside(const Edged& edged, const Polyline& line) {
  const WorkLine work = work_line({PassKind::kHeadlandPass, line}, edged.request.implement_x_B_m);
  for (const PathPoint& point : work.points) {
    ASSERT_TRUE(fits(edged.space, pose_of(point), edged.request.clearance_m - kFitTolerance_m))
        << point.p_W.transpose();
    ASSERT_TRUE(works_inside(edged.space, pose_of(point), 0.0)) << point.p_W.transpose();
  }
}

// Four edges, each from backed into one corner, 0.9 m of rear and 0.1 m of clearance away, to the
// front before the next edge, 2.3 m and 0.1 m: of every corner 2.4 m x 1 m and 0.4 m x 1 m are
// left.
TEST(EdgePasses, WorkASquareRightIntoItsCorners) {
  Edged edged(field_of("square", rectangle_ring(0, 0, 50, 50)));
  const std::vector<EdgePass> passes = edged.round(edge_distance_m(edged.request));
  ASSERT_EQ(passes.size(), 4U);
  for (const EdgePass& pass : passes) {
    EXPECT_FALSE(pass.closed);
    EXPECT_FALSE(pass.around_hole);
    EXPECT_EQ(pass.ring, passes.front().ring);
    expect_inside(edged, pass.line_W);
  }
  const double band_m2 = 50.0 * 50.0 - 46.0 * 46.0;
  const double worked_m2 = 50.0 * 50.0 - to_work_m2(edged.ground);
  constexpr double kEnds_m2 = 8 * 2.0 * 0.25;  // ends are drawn in by 0.25 m at most
  EXPECT_NEAR(worked_m2, band_m2 - 4.0 * 2.8, kEnds_m2);
}

TEST(EdgePasses, GoRoundWithoutAStopWhereThereAreNoCorners) {
  Edged edged(field_of("round", regular_ring({0, 0}, 40, 60)));
  const std::vector<EdgePass> passes = edged.round(edge_distance_m(edged.request));
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_TRUE(passes[0].closed);
  EXPECT_EQ(passes[0].line_W.front(), passes[0].line_W.back());
  expect_inside(edged, passes[0].line_W);
}

TEST(EdgePasses, ThatFindNothingToWorkAreLeftOut) {
  Edged edged(field_of("square", rectangle_ring(0, 0, 50, 50)));
  const double distance_m = edge_distance_m(edged.request);
  ASSERT_EQ(edged.round(distance_m).size(), 4U);
  EXPECT_TRUE(edged.round(distance_m).empty());
}

FillOptions fill_options(const PlanRequest& request) {
  FillOptions options;
  options.working_width_m = request.working_width_m;
  options.turning_radius_m = request.turning_radius_m;
  options.clearance_m = request.clearance_m;
  options.least_patch_m2 = 1.0;
  return options;
}

TEST(FillPasses, NothingLeftNeedsNone) {
  Edged edged(field_of("square", rectangle_ring(0, 0, 50, 50)));
  work_along(edged.ground, {{-1, 25}, {51, 25}}, 60.0);
  EXPECT_TRUE(fill_passes(edged.space, fill_options(edged.request), edged.ground).empty());
}

// A strip along an edge and a corner are left: one pass works the strip.
TEST(FillPasses, WorkWhatIsLeftAndStayInside) {
  Edged edged(field_of("square", rectangle_ring(0, 0, 50, 50)));
  work_along(edged.ground, {{-1, 26}, {51, 26}}, 48.0);
  EXPECT_NEAR(to_work_m2(edged.ground), 100.0, 11.0);
  const std::vector<Pass> passes =
      fill_passes(edged.space, fill_options(edged.request), edged.ground);
  ASSERT_FALSE(passes.empty());
  EXPECT_LE(passes.size(), 3U);
  EXPECT_GT(length_m(passes.front().points_W), 45.0);
  for (const Pass& pass : passes) {
    EXPECT_TRUE(pass.optional);
    expect_inside(edged, pass.points_W);
  }
  // At either end what the rear and the clearance keep it from.
  EXPECT_LT(to_work_m2(edged.ground), 2.0 * 2.0 * 1.0);
}

// The rounded headland leaves every corner, the covered one next to nothing.
TEST(CoveredHeadland, LeavesAFifthOfWhatRoundedOnesLeave) {
  const Field field = field_of("square", rectangle_ring(0, 0, 60, 45));
  PlanRequest request = transplanter_request(field, "boustrophedon");
  const auto missed_m2 = [&](const std::string& corners) {
    request.parameters["headland_corners"] = corners;
    const Plan plan = plan_boustrophedon(request);
    std::vector<PolygonSet> strips;
    for (const Pass& pass : plan.passes) {
      strips.push_back(strip(pass.points_W, request.working_width_m));
    }
    return area_m2(difference(from_field(field), united(strips)));
  };
  const double rounded_m2 = missed_m2("rounded");
  const double covered_m2 = missed_m2("covered");
  EXPECT_LT(covered_m2, 0.2 * rounded_m2);
  EXPECT_LT(covered_m2, 0.005 * 60.0 * 45.0);
}

TEST(CoveredHeadland, IsRefusedWhereItCannotBe) {
  const Field field = field_of("square", rectangle_ring(0, 0, 60, 45));
  PlanRequest request = transplanter_request(field, "boustrophedon");
  request.parameters["overhang_m"] = 0.5;
  EXPECT_THROW(plan_boustrophedon(request), InputError);
  request.parameters["headland_corners"] = std::string("covered");
  EXPECT_NO_THROW(plan_boustrophedon(request));
  request.forward_only = true;
  EXPECT_THROW(plan_boustrophedon(request), InputError);
}

TEST(CoveredHeadland, ImplementStaysOnTheFieldUnlessItMayHangOver) {
  const Field field = field_of("triangle", {{0, 0}, {60, 0}, {10, 40}});
  PlanRequest request = transplanter_request(field, "boustrophedon");
  request.parameters["headland_corners"] = std::string("covered");
  const auto outside_m2 = [&](double overhang_m) {
    request.parameters["overhang_m"] = overhang_m;
    std::vector<PolygonSet> strips;
    for (const Pass& pass : plan_boustrophedon(request).passes) {
      strips.push_back(strip(pass.points_W, request.working_width_m));
    }
    return area_m2(difference(united(strips), from_field(field)));
  };
  // Ends of bars may stand out by as much as fitting is looked at.
  EXPECT_LT(outside_m2(0.0), kFitTolerance_m * 170.0);
  EXPECT_GT(outside_m2(1.0), 1.0) << outside_m2(0.0);
}

}  // namespace
}  // namespace headland
