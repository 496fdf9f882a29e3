#include "planner/swath_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "planner/algorithms/boustrophedon.h"
#include "planner/algorithms/decomposed.h"
#include "planner/swath_order.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

using testing::HasSubstr;

Field square() { return field_of("square", rectangle_ring(0, 0, 150, 150)); }

std::vector<Pass> swaths_of(const Plan& plan) {
  std::vector<Pass> swaths;
  std::ranges::copy_if(plan.passes, std::back_inserter(swaths),
                       [](const Pass& pass) { return pass.kind == PassKind::kSwath; });
  return swaths;
}

std::string refusal(const PlanRequest& request) {
  try {
    plan_boustrophedon(request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

// Every swath lies a whole number of widths beside the line, in its direction, and the inner field
// is covered from side to side.
TEST(AbLine, SwathsLieOnItAndBesideIt) {
  PlanRequest request = transplanter_request(square(), "boustrophedon");
  const Eigen::Vector2d a_W(40.3, 10.0);
  const Eigen::Vector2d b_W(80.0, 140.0);
  request.ab_line_W = {a_W, b_W};
  const Plan plan = plan_boustrophedon(request);
  const Eigen::Vector2d along = (b_W - a_W).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  for (const Pass& swath : swaths_of(plan)) {
    const Eigen::Vector2d run = swath.points_W[1] - swath.points_W[0];
    EXPECT_NEAR(run.dot(across), 0.0, 1e-6 * run.norm());
    const double widths = across.dot(swath.points_W[0] - a_W) / request.working_width_m;
    EXPECT_NEAR(widths, std::round(widths), 1e-6);
  }
  std::vector<PolygonSet> strips;
  for (const Pass& pass : plan.passes) {
    strips.push_back(strip(pass.points_W, request.working_width_m));
  }
  const PolygonSet inner = buffered(from_field(square()), -plan.headland_width_m, Join::kRound);
  EXPECT_LT(area_m2(difference(inner, united(strips))), 1e-4 * area_m2(inner));
}

TEST(AbLine, BackwardsIsTheSameLine) {
  PlanRequest request = transplanter_request(square(), "boustrophedon");
  request.ab_line_W = {Eigen::Vector2d(40.3, 10.0), Eigen::Vector2d(80.0, 140.0)};
  const Plan there = plan_boustrophedon(request);
  std::swap((*request.ab_line_W)[0], (*request.ab_line_W)[1]);
  const Plan back = plan_boustrophedon(request);
  ASSERT_EQ(there.passes.size(), back.passes.size());
  EXPECT_NEAR(there.planned_length_m, back.planned_length_m, 1e-3);
}

TEST(AbLine, IsRefusedOutsideTheFieldTooShortOrBesideADirection) {
  PlanRequest request = transplanter_request(square(), "boustrophedon");
  request.ab_line_W = {Eigen::Vector2d(200.0, 0.0), Eigen::Vector2d(200.0, 100.0)};
  EXPECT_THAT(refusal(request), HasSubstr("ab_line: '(200.0, 0.0) to (200.0, 100.0) m': lies"));
  request.ab_line_W = {Eigen::Vector2d(50.0, 50.0), Eigen::Vector2d(50.0, 50.5)};
  EXPECT_THAT(refusal(request), HasSubstr("1 m apart"));
  request.ab_line_W = {Eigen::Vector2d(-10.0, 50.0), Eigen::Vector2d(160.0, 50.0)};
  EXPECT_EQ(refusal(request), "not refused");
  request.parameters["swath_direction_deg"] = 10.0;
  EXPECT_THAT(refusal(request), HasSubstr("not together with swath_direction_deg"));
}

TEST(SwathObjectives, EnergyNeedsCosts) {
  PlanRequest request = transplanter_request(square(), "boustrophedon");
  request.parameters["swath_objective"] = std::string("energy");
  EXPECT_THAT(refusal(request), HasSubstr("headland measure"));
  const DriveCost cost = made_up_cost();
  request.cost = &cost;
  EXPECT_EQ(refusal(request), "not refused");
}

// Whatever the order, the same swaths are driven.
TEST(SwathOrders, DriveTheSameSwaths) {
  for (const Field& field : {square(), field_shapes()[5]}) {
    std::set<std::pair<double, double>> first;
    for (const char* order : {"boustrophedon", "skip", "spiral", "optimised"}) {
      PlanRequest request = transplanter_request(field, "boustrophedon");
      request.parameters["swath_order"] = std::string(order);
      std::set<std::pair<double, double>> middles;
      for (const Pass& swath : swaths_of(plan_boustrophedon(request))) {
        const Eigen::Vector2d middle_W = 0.5 * (swath.points_W[0] + swath.points_W[1]);
        middles.emplace(middle_W.x(), middle_W.y());
      }
      if (first.empty()) first = middles;
      EXPECT_EQ(middles, first) << order << " on " << field.name;
    }
  }
}

// 2 m swaths and a radius of 2.6 m: onto the next swath but one a U-turn does.
TEST(SwathOrders, SkippingAndOptimisingSaveTurns) {
  PlanRequest request = transplanter_request(square(), "boustrophedon");
  const TurnCosts costs{request.turning_radius_m, Gears::kBoth};
  const auto cost_m = [&](const char* order) {
    request.parameters["swath_order"] = std::string(order);
    return order_cost(swaths_of(plan_boustrophedon(request)), std::nullopt, costs);
  };
  const double next_m = cost_m("boustrophedon");
  const double skip_m = cost_m("skip");
  const double optimised_m = cost_m("optimised");
  EXPECT_LT(skip_m, 0.9 * next_m);
  EXPECT_LE(optimised_m, skip_m + 1e-6);
  EXPECT_GT(cost_m("spiral"), next_m);  // its first turns go across the whole field
}

// Two arms at a right angle: each has its own direction, which takes fewer swaths than one for
// both.
TEST(Decomposed, ArmsOfAnLHaveTheirOwnDirections) {
  const Field field = field_of("L", {{0, 0}, {400, 0}, {400, 60}, {60, 60}, {60, 400}, {0, 400}});
  const Plan whole = plan_boustrophedon(transplanter_request(field, "boustrophedon"));
  const PlanRequest request = transplanter_request(field, "decomposed");
  const Plan plan = plan_decomposed(request);
  std::set<int> directions_deg;
  for (const Pass& swath : swaths_of(plan)) {
    const Eigen::Vector2d run = swath.points_W[1] - swath.points_W[0];
    double direction_rad = std::atan2(run.y(), run.x());
    if (direction_rad < 0.0) direction_rad += kPi;
    directions_deg.insert(static_cast<int>(std::lround(direction_rad * 180.0 / kPi)) % 180);
  }
  EXPECT_THAT(directions_deg, testing::ElementsAre(0, 90));
  EXPECT_LT(swaths_of(plan).size(), 0.6 * static_cast<double>(swaths_of(whole).size()));
}

TEST(Decomposed, IsOnePartWhereOneDirectionServes) {
  const Plan whole = plan_boustrophedon(transplanter_request(square(), "boustrophedon"));
  const Plan plan = plan_decomposed(transplanter_request(square(), "decomposed"));
  EXPECT_EQ(swaths_of(plan).size(), swaths_of(whole).size());
  EXPECT_NEAR(plan.planned_length_m, whole.planned_length_m, 1e-6);
}

}  // namespace
}  // namespace headland
