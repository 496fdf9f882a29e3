#include "planner/line_ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/drivable_path.h"
#include "planner/hull.h"
#include "planner/planned_vehicle.h"
#include "planner/planners.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

Field plain_field(double length_m, double width_m) {
  Field field;
  field.name = "rectangle";
  field.boundary = {{0, 0}, {length_m, 0}, {length_m, width_m}, {0, width_m}};
  return field;
}

// Two neighbouring swaths whose facing ends are `from_edge_m` from the right boundary.
Plan two_swaths(double from_edge_m, double headland_width_m) {
  Plan plan;
  plan.headland_width_m = headland_width_m;
  plan.passes = {{PassKind::kSwath, {{8, 18}, {60 - from_edge_m, 18}}},
                 {PassKind::kSwath, {{60 - from_edge_m, 20}, {8, 20}}}};
  return plan;
}

Plan boustrophedon(const Field& field, const Vehicle& vehicle) {
  const PlannerEntry& planner = find_planner("boustrophedon", "test");
  PlanRequest request;
  request.field = field;
  set_vehicle(request, vehicle);
  request.parameters = resolve_parameters(planner.parameters, {}, "test", "planner");
  return planner.plan(request);
}

double longest_swath_m(const Path& path) {
  double longest_m = 0.0;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind == PathKind::kSwath) longest_m = std::max(longest_m, length_m(segment));
  }
  return longest_m;
}

TEST(LineEnds, SwathsThatReachIntoTheHeadlandAreCutBackUntilTheyCanTurn) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Path path = make_path(plain_field(60, 40), vehicle, two_swaths(1.5, 6.0), {});
  EXPECT_TRUE(path.violations.empty());
  ASSERT_EQ(path.cut_back_m.size(), 2U);
  for (const double cut_m : path.cut_back_m) {
    EXPECT_GT(cut_m, 0.0);
    EXPECT_LE(cut_m, 4.5 + kPathSpacing_m);  // the headland's edge
  }
  EXPECT_NEAR(longest_swath_m(path), 60 - 1.5 - 8 - path.cut_back_m.front(), 1e-6);
}

// Nothing turns at the end of the last swath; where an edge has no headland it ends at the edge.
TEST(LineEnds, TheLastSwathIsCutUntilTheHullFits) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = plain_field(60, 40);
  Plan plan = two_swaths(6.0, 6.0);
  plan.passes.back().points_W.back().x() = 0.5;
  EXPECT_THROW(make_path(field, vehicle, plan, {}), PlanInfeasible);
  plan.kept_whole = PolygonSet{{PolygonPart{{{6, 6}, {54, 6}, {54, 34}, {6, 34}}, {}}}};
  const Path path = make_path(field, vehicle, plan, {});
  EXPECT_TRUE(path.violations.empty());
  ASSERT_EQ(path.cut_back_m.size(), 1U);
  // Its front is ahead of the implement by so much, and no more is cut than keeps the clearance, in
  // steps of the path.
  const double front_m =
      hull_of(vehicle).front_m - vehicle.implement.x_B_m + PathOptions{}.clearance_m;
  EXPECT_NEAR(path.cut_back_m.front(), front_m - 0.5, kPathSpacing_m + kFitTolerance_m);
}

TEST(LineEnds, SwathsThatCanTurnStayAsPlanned) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Path path = make_path(plain_field(60, 40), vehicle, two_swaths(8.0, 8.0), {});
  EXPECT_TRUE(path.cut_back_m.empty());
  EXPECT_NEAR(longest_swath_m(path), 44.0, 1e-6);
}

// Negative control: a swath is not cut beyond the headland's edge; a headland that is too narrow
// is refused with the width that would do.
TEST(LineEnds, ANarrowHeadlandIsRefusedNotCutInto) {
  const Vehicle vehicle = load_vehicle("transplanter");
  try {
    make_path(plain_field(60, 40), vehicle, two_swaths(1.5, 1.5), {});
    FAIL() << "the hull cannot even reach the swath's end";
  } catch (const PlanInfeasible& refused) {
    EXPECT_NE(std::string(refused.what()).find("needs a headland of"), std::string::npos)
        << refused.what();
  }
}

TEST(LineEnds, RoundsBeginWhereATurnReachesThem) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = plain_field(60, 40);
  Plan plan = two_swaths(8.0, 8.0);
  // A closed round that begins right behind the last swath's end, heading back: no turn fits there.
  const Plan whole = boustrophedon(field, vehicle);
  const auto outermost =
      std::ranges::find_if(whole.passes.rbegin(), whole.passes.rend(),
                           [](const Pass& pass) { return pass.kind == PassKind::kHeadlandPass; });
  ASSERT_NE(outermost, whole.passes.rend());
  plan.passes.push_back(*outermost);
  double ring_m = 0.0;
  for (std::size_t i = 1; i < outermost->points_W.size(); ++i) {
    ring_m += (outermost->points_W[i] - outermost->points_W[i - 1]).norm();
  }
  const Path path = make_path(field, vehicle, plan, {});
  EXPECT_TRUE(path.violations.empty());
  EXPECT_NEAR(length_m(path.segments.back()), ring_m, 0.01 * ring_m);
}

// The whole chain on the simplest of fields, which needs both mends.
TEST(LineEnds, PlainRectanglesBecomeDrivable) {
  for (const char* name : {"transplanter", "utility_tractor"}) {
    const Vehicle vehicle = load_vehicle(name);
    for (const double scale : {1.0, 1.5, 2.0}) {
      const Field field = plain_field(100.0 * scale, 70.0 * scale);
      const Path path = make_path(field, vehicle, boustrophedon(field, vehicle), {});
      EXPECT_TRUE(path.violations.empty()) << name << ", scale " << scale;
    }
  }
}

}  // namespace
}  // namespace headland
