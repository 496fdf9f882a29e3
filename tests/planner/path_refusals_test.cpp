// Plans that cannot be driven: refused, or recorded where that is asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "planner/arcs.h"
#include "planner/drivable_path.h"
#include "planner/free_space.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"
#include "tests/planner/path_fixture.h"

namespace headland {
namespace {

using test::expect_continuous;
using test::expect_inside;
using test::kRounding;
using test::rectangle;
using test::ring_m;
using test::up_and_down;
using testing::HasSubstr;

TEST(MakePath, NarrowHeadlandIsRefusedWithAWidthThatWorks) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  std::string message;
  try {
    make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, 3.0), {});
  } catch (const PlanInfeasible& infeasible) {
    message = infeasible.what();
  }
  EXPECT_THAT(message,
              HasSubstr("no turn from pass 1 (swath) to pass 2 (swath) fits at (4.0, 57.0) m"));
  EXPECT_THAT(message, HasSubstr("there are 3.0 m"));
  const std::string before_width = "it needs a headland of ";
  const std::size_t width_at = message.find(before_width);
  ASSERT_NE(width_at, std::string::npos);
  EXPECT_THAT(message, HasSubstr("; widen the headland, turn tighter or allow overruns"));
  Plan on_cells = up_and_down(40.0, 60.0, 2.0, 3.0);
  on_cells.remedies.has_headland = false;
  EXPECT_THAT(
      [&] { make_path(field, vehicle, on_cells, {}); },
      testing::ThrowsMessage<PlanInfeasible>(HasSubstr("; turn tighter or allow overruns")));
  const double would_do_m = std::stod(message.substr(width_at + before_width.size()));
  const Path path = make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, would_do_m), {});
  EXPECT_TRUE(path.violations.empty());
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
}

TEST(MakePath, OverrunsAreRecordedWhenAllowed) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  PathOptions options;
  options.allow_overrun = true;
  const Path path =
      make_path(rectangle(40.0, 60.0), vehicle, up_and_down(40.0, 60.0, 2.0, 3.0), options);
  expect_continuous(path, vehicle);
  ASSERT_FALSE(path.violations.empty());
  for (const PathViolation& violation : path.violations) {
    EXPECT_GT(violation.overrun_m, 0.0);
    EXPECT_THAT(violation.what, HasSubstr("beyond the boundary"));
    EXPECT_TRUE(violation.p_W.y() <= kRounding || violation.p_W.y() >= 60.0 - kRounding);
  }
}

TEST(MakePath, RefusalNamesThePlaceOnTheMap) {
  Field field = rectangle(40.0, 60.0);
  field.frame = {true, 52.0, 10.0};
  try {
    make_path(field, made_up_vehicle(2.6, 2.0), up_and_down(40.0, 60.0, 2.0, 3.0), {});
    FAIL() << "accepted";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), HasSubstr("[lon 10.00005"));
    EXPECT_THAT(infeasible.what(), HasSubstr(", lat 52.0005"));
  }
}

TEST(MakePath, PlanWithoutPassesIsRefused) {
  EXPECT_THROW(make_path(rectangle(40.0, 60.0), made_up_vehicle(2.6, 2.0), {}, {}), PlanInfeasible);
}

// A wall with a gap narrower than the hull, and passes on its other side.
TEST(MakePath, AVehicleThatReachesLittleOfItsPassesIsRefused) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Field field = rectangle(80.0, 40.0);
  field.holes.push_back({{40.0, 1.0}, {40.0, 39.0}, {41.0, 39.0}, {41.0, 1.0}});
  const auto plan_with = [](int beyond) {
    Plan plan;
    plan.passes.push_back({PassKind::kSwath, {{10.0, 10.0}, {30.0, 10.0}}});
    for (int i = 0; i < beyond; ++i) {
      const double y = 10.0 + 6.0 * i;
      plan.passes.push_back({PassKind::kSwath, {{50.0, y}, {70.0, y}}, true});
    }
    return plan;
  };
  const Path path = make_path(field, vehicle, plan_with(1), {});
  ASSERT_EQ(path.left_out.size(), 1U);
  EXPECT_THAT(path.left_out[0].why, HasSubstr("at (60.0, 10.0) m fits"));
  // 20 m at a width of 2 m, in cells of 0.1 m.
  EXPECT_NEAR(path.left_out[0].area_m2, 40.0, 0.5);
  EXPECT_EQ(left_out_m2(path), path.left_out[0].area_m2);
  try {
    make_path(field, vehicle, plan_with(2), {});
    FAIL() << "planned though 80 of 120 m² cannot be reached";
  } catch (const PlanInfeasible& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("no more than 40 of 120 m² that passes would work"));
    EXPECT_THAT(refused.what(), HasSubstr("1 other is left out"));
    EXPECT_THAT(refused.what(), HasSubstr("Take a smaller vehicle"));
  }
}

TEST(MakePath, PassTighterThanTheVehicleIsRefusedOrRecorded) {
  const Vehicle vehicle = made_up_vehicle(4.0, 2.0);
  Plan plan;
  plan.passes.push_back({PassKind::kHeadlandPass, ring_m(10.0, 50.0, 2.0)});
  try {
    make_path(rectangle(60.0, 60.0), vehicle, plan, {});
    FAIL() << "accepted";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), HasSubstr("pass 1 (headland pass) bends with a radius of "));
    EXPECT_THAT(infeasible.what(), HasSubstr("the vehicle's least is 3.48 m"));
  }
  PathOptions options;
  options.allow_overrun = true;
  const Path path = make_path(rectangle(60.0, 60.0), vehicle, plan, options);
  ASSERT_EQ(path.violations.size(), 1U);
  EXPECT_GT(path.violations[0].overrun_m, 1.0);
}

}  // namespace
}  // namespace headland
