#include "planner/algorithms/boustrophedon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include "planner/arcs.h"
#include "planner/polygon.h"
#include "terrains/field_source.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

Field square() { return field_of("square", rectangle_ring(0, 0, 150, 150)); }

PlanRequest tractor(const Field& field) { return tractor_request(field, "boustrophedon"); }

std::ptrdiff_t count_of(const Plan& plan, PassKind kind) {
  return std::ranges::count(plan.passes, kind, &Pass::kind);
}

std::string refusal(const PlanRequest& request) {
  try {
    plan_boustrophedon(request);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Boustrophedon, SquareTakesTheSwathsThatItsInnerWidthNeeds) {
  const Plan plan = plan_boustrophedon(tractor(square()));
  EXPECT_DOUBLE_EQ(plan.headland_width_m, 18.0);
  EXPECT_EQ(count_of(plan, PassKind::kSwath), 13);  // 114 m / 9 m
  EXPECT_EQ(count_of(plan, PassKind::kHeadlandPass), 2);
}

TEST(Boustrophedon, NeighbouringSwathsFollowEachOtherUpAndDown) {
  const Plan plan = plan_boustrophedon(tractor(square()));
  for (std::size_t i = 1; i < 13; ++i) {
    const Polyline& before = plan.passes[i - 1].points_W;
    const Polyline& after = plan.passes[i].points_W;
    EXPECT_NEAR((after.front() - before.back()).norm(), 114.0 / 13.0, 0.01);
    const Eigen::Vector2d a = before.back() - before.front();
    EXPECT_LT(a.dot(after.back() - after.front()), 0.0);
  }
}

TEST(Boustrophedon, HeadlandComesFirstFromOutsideOrLastFromInside) {
  PlanRequest request = tractor(square());
  const Plan last = plan_boustrophedon(request);
  EXPECT_EQ(last.passes.front().kind, PassKind::kSwath);
  ASSERT_EQ(last.passes.back().kind, PassKind::kHeadlandPass);
  EXPECT_GT(length_m(last.passes.back().points_W),
            length_m(last.passes[last.passes.size() - 2].points_W));
  request.parameters["headland_order"] = std::string("first");
  const Plan first = plan_boustrophedon(request);
  ASSERT_EQ(first.passes.front().kind, PassKind::kHeadlandPass);
  EXPECT_EQ(first.passes.back().kind, PassKind::kSwath);
  EXPECT_GT(length_m(first.passes[0].points_W), length_m(first.passes[1].points_W));
}

TEST(Boustrophedon, RoundsAroundHolesMayComeBeforeTheSwathsAndTheOthersAfter) {
  Field field = square();
  field.holes = {reversed(rectangle_ring(60, 60, 90, 90))};
  PlanRequest request = tractor(field);
  request.parameters["headland_order"] = std::string("holes_first");
  const Plan plan = plan_boustrophedon(request);
  const auto around_hole = [](const Pass& pass) {
    return std::ranges::all_of(pass.points_W, [](const Eigen::Vector2d& p_W) {
      return (p_W - Eigen::Vector2d(75, 75)).norm() < 60.0;
    });
  };
  ASSERT_GE(plan.passes.size(), 6U);
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    if (plan.passes[i].kind == PassKind::kSwath) continue;
    EXPECT_EQ(around_hole(plan.passes[i]), i < 2) << i;
    EXPECT_TRUE(i < 2 || i + 2 >= plan.passes.size()) << i;
  }
}

TEST(Boustrophedon, WorkBeginsNearTheEntry) {
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(150, 150)}) {
    PlanRequest request = tractor(square());
    request.field.entry_W = corner;
    // The nearest swath begins at the inner field's corner, half a spacing in.
    const Plan last = plan_boustrophedon(request);
    EXPECT_NEAR((last.passes[0].points_W[0] - corner).norm(), std::hypot(18.0, 18.0 + 114.0 / 26.0),
                0.05);
    request.parameters["headland_order"] = std::string("first");
    const Plan first = plan_boustrophedon(request);
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p_W : first.passes[0].points_W) {
      nearest_m = std::min(nearest_m, (p_W - corner).norm());
    }
    EXPECT_NEAR((first.passes[0].points_W[0] - corner).norm(), nearest_m, 0.5);
  }
}

TEST(Boustrophedon, ParametersAreTakenAtTheirWord) {
  PlanRequest request = tractor(square());
  request.parameters["headland_passes"] = 3.0;
  request.parameters["swath_direction_deg"] = 30.0;
  const Plan plan = plan_boustrophedon(request);
  EXPECT_EQ(count_of(plan, PassKind::kHeadlandPass), 3);
  EXPECT_DOUBLE_EQ(plan.headland_width_m, 27.0);
  EXPECT_NEAR(plan.swath_direction_rad, std::numbers::pi / 6.0, 1e-12);
  const Polyline& swath = plan.passes[0].points_W;
  const Eigen::Vector2d along = (swath[1] - swath[0]).normalized();
  EXPECT_NEAR(std::abs(along.x()), std::cos(std::numbers::pi / 6.0), 1e-9);
}

TEST(Boustrophedon, SeedChangesNothing) {
  PlanRequest request = tractor(field_shapes()[5]);
  const Plan a = plan_boustrophedon(request);
  request.seed = 77;
  const Plan b = plan_boustrophedon(request);
  ASSERT_EQ(a.passes.size(), b.passes.size());
  EXPECT_DOUBLE_EQ(a.planned_length_m, b.planned_length_m);
}

TEST(Boustrophedon, FieldThatRoundsCoverNeedsNoSwaths) {
  // 34 m square: the second round is a square of 7 m, and 9 m wide.
  PlanRequest request = tractor(field_of("small", rectangle_ring(0, 0, 34, 34)));
  request.turning_radius_m = 3.0;
  const Plan plan = plan_boustrophedon(request);
  EXPECT_EQ(count_of(plan, PassKind::kSwath), 0);
  EXPECT_EQ(count_of(plan, PassKind::kHeadlandPass), 2);
}

// 36 m square: a second round would be a square of 9 m, tighter than the vehicle turns.
TEST(Boustrophedon, SwathsTakeTheGroundOfARoundThatDoesNotFit) {
  const Plan plan = plan_boustrophedon(tractor(field_of("small", rectangle_ring(0, 0, 36, 36))));
  EXPECT_EQ(count_of(plan, PassKind::kSwath), 2);  // 18 m / 9 m
  EXPECT_EQ(count_of(plan, PassKind::kHeadlandPass), 1);
}

TEST(Boustrophedon, ThousandsOfSwathsArePlanned) {
  PlanRequest request =
      transplanter_request(field_of("large", rectangle_ring(0, 0, 4000, 4000)), "boustrophedon");
  request.working_width_m = 1.9;
  const Plan plan = plan_boustrophedon(request);
  // The headland is three rounds of 1.9 m on both sides.
  EXPECT_EQ(count_of(plan, PassKind::kSwath), std::lround(std::ceil((4000.0 - 11.4) / 1.9)));
}

TEST(Boustrophedon, BadRequestsAreRefusedByName) {
  PlanRequest request = tractor(square());
  request.working_width_m = -2.0;
  EXPECT_EQ(refusal(request), "plan: working_width_m: '-2': a length above 0 m");
  request = tractor(square());
  request.turning_radius_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(request), "plan: turning_radius_m: 'nan': a length above 0 m");
  request = tractor(square());
  request.working_width_m = 160.0;
  EXPECT_EQ(
      refusal(request),
      "plan: working_width_m: '160': wider than the field 'square' anywhere; at most 150.0 m");
  request = tractor(square());
  request.vehicle_width_m = 200.0;
  EXPECT_THAT(refusal(request), testing::HasSubstr("vehicle_width_m: '200'"));
}

TEST(Boustrophedon, TurningRadiusThatFitsNowhereIsInfeasible) {
  PlanRequest request = tractor(square());
  request.turning_radius_m = 90.0;
  EXPECT_THROW(plan_boustrophedon(request), PlanInfeasible);
  EXPECT_THAT(refusal(request), testing::HasSubstr("the turning radius fits nowhere"));
}

TEST(Boustrophedon, TooManySwathsAreInfeasible) {
  PlanRequest request = tractor(field_of("huge", rectangle_ring(0, 0, 3000, 3000)));
  request.working_width_m = 0.1;
  request.vehicle_width_m = 0.1;
  request.turning_radius_m = 1.0;
  request.parameters["headland_passes"] = 1.0;
  EXPECT_THAT(refusal(request), testing::HasSubstr("at most 20000"));
}

// 27.7 ha with a wavy boundary and a hole; the rows of the combine that made the log ran north.
TEST(Boustrophedon, OutlineOfThousandsOfTeethIsRefused) {
  Ring teeth;
  for (int i = 0; i < 6000; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / 6000;
    teeth.emplace_back((200.0 + 0.3 * (i % 2)) * direction_of(angle_rad));
  }
  EXPECT_THAT(refusal(tractor(field_of("teeth", teeth))),
              testing::AllOf(testing::HasSubstr("still has 6000 points when simplified to 0.01 m"),
                             testing::HasSubstr("more than 5000; draw it with fewer")));
}

TEST(Boustrophedon, GartnerFieldIsCovered) {
  FieldSource source;
  source.file = HEADLAND_SOURCE_DIR "/../shared/data/gartner/boundary.geojson";
  if (!std::filesystem::exists(source.file)) GTEST_SKIP() << source.file << " is not there";
  const PlanRequest request = tractor(read_field(source, "test"));
  const Plan plan = plan_boustrophedon(request);
  EXPECT_NEAR(plan.swath_direction_rad, std::numbers::pi / 2.0, 0.02);
  std::vector<PolygonSet> strips;
  for (const Pass& pass : plan.passes) {
    strips.push_back(strip(pass.points_W, request.working_width_m));
  }
  const PolygonSet field = from_field(request.field);
  const double field_m2 = area_m2(field);
  const double missed_m2 = area_m2(difference(field, united(strips)));
  EXPECT_LT(missed_m2, 0.002 * field_m2);  // the boundary's corners and teeth
  // No plan can be shorter than its area by its width; this one may add the overlap of rounds
  // around corners and of swaths into the headland's waves.
  EXPECT_LT(plan.planned_length_m * request.working_width_m, 1.03 * field_m2);
}

}  // namespace
}  // namespace headland
