#include "planner/worked_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "planner/drivable_path.h"
#include "planner/headland_order.h"
#include "planner/plan.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Vehicle wheeled_vehicle() {
  Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  vehicle.front.track_m = 1.0;
  vehicle.rear.track_m = 1.0;
  return vehicle;
}

Field rows_field() { return field_of("f", rectangle_ring(0, 0, 60, 60)); }

PathSegment straight_segment(PathKind kind, bool down, const Eigen::Vector2d& a,
                             const Eigen::Vector2d& b) {
  const Eigen::Vector2d run = b - a;
  const double length_m = run.norm();
  PathSegment segment;
  segment.kind = kind;
  segment.implement_down = down;
  const int steps = static_cast<int>(length_m / 0.1);
  for (int i = 0; i <= steps; ++i) {
    segment.points.push_back({a + run * i / steps, std::atan2(run.y(), run.x()), 0.0});
  }
  return segment;
}

// A row 1.6 m wide is crossed square, by the front wheels and, 1.9 m behind, by the rear ones.
TEST(DrivenOverWorked, CrossingARowIsMeasured) {
  const Vehicle vehicle = wheeled_vehicle();
  Path path;
  path.segments.push_back(straight_segment(PathKind::kSwath, true, {10, 20}, {50, 20}));
  path.segments.push_back(straight_segment(PathKind::kTransit, false, {30, 30}, {30, 10}));
  const DrivenOverWorked over = driven_over_worked(rows_field(), vehicle, path);
  EXPECT_EQ(over.stretches, 2);
  EXPECT_NEAR(over.length_m, 2.0 * kRowShare * 2.0, 2.0 * kGroundCell_m + 0.2);
  EXPECT_NEAR(over.p_W.x(), 30.0, 0.01);
}

// Rows of neighbouring parts of a field may cross.
TEST(WorkRows, TakenBackLeaveWhatOtherRowsHaveWorked) {
  const Vehicle vehicle = wheeled_vehicle();
  WorkedGround ground = ground_to_work(rows_field());
  WorkLine along;
  along.points = straight_segment(PathKind::kSwath, true, {10, 20}, {50, 20}).points;
  WorkLine across;
  across.points = straight_segment(PathKind::kSwath, true, {30, 40}, {30, 10}).points;
  EXPECT_FALSE(work_rows(ground, along, 0, along.points.size() - 1, vehicle).empty());
  const auto newly = work_rows(ground, across, 0, across.points.size() - 1, vehicle);
  EXPECT_EQ(state_at(ground, {30, 30}), GroundState::kWorked);
  unwork(ground, newly);
  EXPECT_EQ(state_at(ground, {30, 30}), GroundState::kToWork);
  EXPECT_EQ(state_at(ground, {30, 20}), GroundState::kWorked);
}

TEST(DrivenOverWorked, WorkItselfHeadlandAndWhatComesBeforeAreNot) {
  const Vehicle vehicle = wheeled_vehicle();
  Path path;
  path.segments.push_back(straight_segment(PathKind::kTransit, false, {30, 30}, {30, 10}));
  path.segments.push_back(straight_segment(PathKind::kSwath, true, {10, 20}, {50, 20}));
  path.segments.push_back(straight_segment(PathKind::kSwath, true, {50, 20.5}, {10, 20.5}));
  path.segments.push_back(straight_segment(PathKind::kHeadlandPass, true, {10, 40}, {50, 40}));
  path.segments.push_back(straight_segment(PathKind::kSwath, true, {10, 45}, {50, 45}));
  path.segments.back().optional = true;
  path.segments.push_back(straight_segment(PathKind::kTransit, false, {30, 50}, {30, 30}));
  EXPECT_EQ(driven_over_worked(rows_field(), vehicle, path).length_m, 0.0);
}

// Three swaths, of which the middle one lies between the two others and is driven first: the way
// from the second to the third leads across it or around its end.
Plan around_the_first(double end_m) {
  Plan plan;
  plan.headland_width_m = 8.0;
  plan.passes = {{PassKind::kSwath, {{14, 30}, {end_m, 30}}},
                 {PassKind::kSwath, {{40, 40}, {20, 40}}},
                 {PassKind::kSwath, {{20, 20}, {40, 20}}}};
  return plan;
}

TEST(KeepOffWorked, TheWayLeadsAroundRows) {
  const Vehicle vehicle = wheeled_vehicle();
  PathOptions options;
  const Path across = make_path(rows_field(), vehicle, around_the_first(46), options);
  EXPECT_GT(driven_over_worked(rows_field(), vehicle, across).length_m, 3.0);
  options.keep_off_worked = true;
  const Path around = make_path(rows_field(), vehicle, around_the_first(46), options);
  EXPECT_EQ(driven_over_worked(rows_field(), vehicle, around).length_m, 0.0);
  EXPECT_GT(length_m(around), length_m(across));
}

TEST(KeepOffWorked, OnlyWhatIsNotChosenYetMayHelp) {
  PlanRequest request;
  request.field = rows_field();
  request.field.holes.clear();
  const auto ways = [&](const char* headland_order) {
    request.parameters = {{"swath_order", std::string("skip")},
                          {"headland_order", std::string(headland_order)}};
    return ways_off_rows(request);
  };
  const std::string other = "another swath_order than skip";
  EXPECT_THAT(ways("last"), ElementsAre(other, "headland_order: first"));
  EXPECT_THAT(ways("first"), ElementsAre(other));
  request.field.holes.push_back({{20, 20}, {20, 21}, {21, 21}});
  EXPECT_THAT(ways("last"),
              ElementsAre(other, "headland_order: first", "headland_order: holes_first"));
  EXPECT_THAT(ways("holes_first"), ElementsAre(other, "headland_order: first"));
}

TEST(KeepOffWorked, WhatCannotIsRefusedWithItsPlace) {
  const Vehicle vehicle = wheeled_vehicle();
  PathOptions options;
  options.keep_off_worked = true;
  Plan plan = around_the_first(46);
  plan.passes[0] = {PassKind::kSwath, {{1.5, 30}, {57, 30}}};
  plan.headland_width_m = 1.5;
  try {
    make_path(rows_field(), vehicle, plan, options);
    FAIL() << "the first swath shuts the others off from each other";
  } catch (const PlanInfeasible& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("keeps off the rows worked (path.keep_off_worked)"));
    EXPECT_THAT(refused.what(), HasSubstr("let wheels run over rows"));
    EXPECT_THAT(refused.what(), Not(HasSubstr("swath_order"))) << "this plan has none";
  }
  // Where overruns are allowed it is driven, and told.
  options.allow_overrun = true;
  const Path path = make_path(rows_field(), vehicle, plan, options);
  EXPECT_GT(driven_over_worked(rows_field(), vehicle, path).length_m, 0.0);
  EXPECT_THAT(
      path.violations,
      Contains(testing::Field(&PathViolation::what, HasSubstr("keeps the wheels off the rows"))));
}

}  // namespace
}  // namespace headland
