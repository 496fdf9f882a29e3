#include "planner/edge_filling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "planner/algorithms/boustrophedon.h"
#include "planner/algorithms/decomposed.h"
#include "planner/drivable_path.h"
#include "planner/headland_rings.h"
#include "planner/planned_vehicle.h"
#include "tests/planner/field_shapes.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kBandEdges_m = 2e-3;     // bands look at ground 1 mm inside their edges
constexpr double kSetRounding_m2 = 1e-3;  // of set operations, along a few hundred metres

PolygonSet ground(const Ring& outer) { return {{PolygonPart{outer, {}}}}; }

// Without headland along its lower edge, which bends by 16 degrees.
Field bent_field(double bend_m) {
  return field_of("bent", {{0, 0}, {70, -bend_m}, {140, 0}, {140, 90}, {0, 90}});
}

PlanRequest bent_request(const Field& field, bool decomposed) {
  PlanRequest request = tractor_request(field, decomposed ? "decomposed" : "boustrophedon");
  set_vehicle(request, load_vehicle("utility_tractor"));
  EdgeHeadland bare;
  bare.at_W = Eigen::Vector2d(70, field.boundary[1].y());
  bare.passes = 0;
  request.headland_edges = {bare};
  return request;
}

PolygonSet worked_by(const std::vector<Pass>& passes, double width_m, bool swaths_alone) {
  std::vector<PolygonSet> strips;
  for (const Pass& pass : passes) {
    if (swaths_alone && pass.kind != PassKind::kSwath) continue;
    strips.push_back(strip(pass.points_W, width_m));
  }
  return united(strips);
}

double beyond_m2(const Field& field, const PolygonSet& worked, double over_m) {
  return area_m2(difference(worked, buffered(from_field(field), over_m, Join::kMitre)));
}

// The last strip of three over 26 m would reach 0.17 m over the edge that it begins at.
TEST(SwathsBesideBareEdges, BeginWithTheEdgeItself) {
  const PolygonSet inner = ground(rectangle_ring(0, 0, 100, 26));
  const PolygonSet below = ground(rectangle_ring(-20, -20, 120, 0));
  const SwathGrid even = lay_swaths({inner, inner}, 0.0, 9.0, 0.0);
  EXPECT_NEAR(even.first_line_m, 26.0 / 3 / 2, 1e-9) << "where nothing is in the way";
  const SwathGrid flush = lay_swaths({inner, inner, below}, 0.0, 9.0, 0.0);
  EXPECT_EQ(flush.lines, 3);
  EXPECT_NEAR(flush.first_line_m, 4.5, 1e-9);
  EXPECT_NEAR(flush.spacing_m, (26.0 - 4.5) / 2.5, 1e-9);
  const PolygonSet around = difference(ground(rectangle_ring(-20, -20, 120, 50)), inner);
  const SwathGrid between = lay_swaths({inner, inner, around}, 0.0, 9.0, 0.0);
  EXPECT_NEAR(between.first_line_m, 4.5, 1e-9);
  EXPECT_NEAR(between.spacing_m, (26.0 - 9.0) / 2.0, 1e-9);
  const PolygonSet narrow = ground(rectangle_ring(0, 0, 100, 5));
  EXPECT_NEAR(lay_swaths({narrow, narrow, below}, 0.0, 9.0, 0.0).first_line_m, 4.5, 1e-9);
}

// Slanted ends and a lone tip that lie nearer to the edge than half a spacing below the first line.
TEST(SwathsBesideBareEdges, ReachAsFarAsTheGroundBesideTheEdge) {
  for (const double across_m : {5.0, 10.0}) {  // one line and two
    for (const bool high : {false, true}) {
      const auto at = [&](double x_m, double from_edge_m) {
        return Eigen::Vector2d(x_m, high ? across_m - from_edge_m : from_edge_m);
      };
      const auto ring = [&](Ring points) {
        if (high) std::reverse(points.begin(), points.end());
        return points;
      };
      const PolygonSet inner{
          {PolygonPart{ring({at(0, 0), at(100, 0), at(80, across_m), at(20, across_m)}), {}},
           PolygonPart{ring({at(120, 0), at(130, 0), at(125, 1)}), {}}}};
      const PolygonSet taken = high ? ground(rectangle_ring(-20, across_m, 150, across_m + 20))
                                    : ground(rectangle_ring(-20, -20, 150, 0));
      const SwathGrid grid = lay_swaths({inner, inner, taken}, 0.0, 9.0, 0.0);
      std::vector<Swath> beside;
      for (const Swath& swath : grid.swaths) {
        if (swath.line == (high ? grid.lines - 1 : 0)) beside.push_back(swath);
      }
      ASSERT_EQ(beside.size(), 2U) << across_m << " m, " << (high ? "high" : "low");
      // Slants come in by at most 20 m over 5 m, the tip by 5 m over 1 m.
      EXPECT_NEAR(beside[0].from_m, 0.0, 4.0 * kBandEdges_m);
      EXPECT_NEAR(beside[0].to_m, 100.0, 4.0 * kBandEdges_m);
      EXPECT_NEAR(beside[1].from_m, 120.0, 5.0 * kBandEdges_m);
      EXPECT_NEAR(beside[1].to_m, 130.0, 5.0 * kBandEdges_m);
    }
  }
}

TEST(SwathsBesideBareEdges, AreCutWhereTheirWidthReachesOver) {
  const PolygonSet inner = ground(rectangle_ring(0, 0, 100, 27));
  // A tip that comes 4 m into the first strip and not into the second.
  const PolygonSet tip = ground({{40, -1}, {60, -1}, {50, 4}});
  const SwathGrid laid = lay_swaths({inner, inner}, 0.0, 9.0, 0.0);
  EXPECT_EQ(kept_within(laid, {inner, inner}, 9.0).swaths.size(), 3U);
  const SwathGrid kept = kept_within(laid, {inner, inner, tip}, 9.0);
  ASSERT_EQ(kept.swaths.size(), 4U);
  EXPECT_NEAR(kept.swaths[0].from_m, 0.0, kBandEdges_m);
  EXPECT_NEAR(kept.swaths[0].to_m, 42.0, kBandEdges_m * 2);
  EXPECT_NEAR(kept.swaths[1].from_m, 58.0, kBandEdges_m * 2);
  EXPECT_EQ(kept.swaths[2].line, 1);
}

class BentEdge : public ::testing::TestWithParam<std::string> {};

TEST_P(BentEdge, ImplementsStayOnTheFieldAndTheGroundIsWorked) {
  // Of the ground with rounded corners: four of the field, and two where rounds turn off.
  constexpr double kLeastWorked = 0.975;
  const bool decomposed = GetParam() == "decomposed";
  for (const double bend_m : {10.0, -10.0, 1.0}) {
    const Field field = bent_field(bend_m);
    PlanRequest request = bent_request(field, decomposed);
    if (GetParam() == "covered") request.parameters["headland_corners"] = std::string("covered");
    const Plan plan = decomposed ? plan_decomposed(request) : plan_boustrophedon(request);
    const double width_m = request.working_width_m;
    EXPECT_LT(beyond_m2(field, worked_by(plan.passes, width_m, true), kOverEdge_m), kSetRounding_m2)
        << bend_m << " m";
    const PolygonSet worked =
        intersection(from_field(field), worked_by(plan.passes, width_m, false));
    EXPECT_GT(area_m2(worked), kLeastWorked * field_area_m2(field)) << bend_m << " m";
    EXPECT_TRUE(make_path(field, load_vehicle("utility_tractor"), plan, {}).violations.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Plans, BentEdge, ::testing::Values("rounded", "covered", "decomposed"));

// What the above is about: swaths laid without regard to the edge reach far over it.
TEST(SwathsBesideBareEdges, ReachOverABentOneWhenTheyAreNotCut) {
  const Field field = bent_field(10.0);
  const PlanRequest request = bent_request(field, false);
  const Headland headland = make_headland(request, 2);
  const SwathGround regardless{headland.inner, headland.drivable};
  const SwathGrid grid = lay_swaths(regardless, 0.0, 9.0, 0.0);
  const SwathGrid kept = kept_within(grid, regardless, 9.0);
  std::vector<Pass> passes;
  passes.reserve(kept.swaths.size());
  for (const Swath& swath : kept.swaths) {
    passes.push_back({PassKind::kSwath,
                      {point_on_line(grid, swath.line, swath.from_m),
                       point_on_line(grid, swath.line, swath.to_m)}});
  }
  EXPECT_GT(beyond_m2(field, worked_by(passes, 9.0, true), kOverEdge_m), 50.0);
}

TEST(SwathsBesideBareEdges, ReachOverByTheOverhangAndNoFurther) {
  const Field field = bent_field(10.0);
  PlanRequest request = bent_request(field, false);
  request.parameters["headland_corners"] = std::string("covered");
  request.parameters["overhang_m"] = 2.0;
  request.parameters["swath_direction_deg"] = 0.0;
  const PolygonSet worked =
      worked_by(plan_boustrophedon(request).passes, request.working_width_m, true);
  EXPECT_GT(beyond_m2(field, worked, 1.0), 1.0);
  EXPECT_LT(beyond_m2(field, worked, 2.0 + kOverEdge_m), kSetRounding_m2);
}

}  // namespace
}  // namespace headland
