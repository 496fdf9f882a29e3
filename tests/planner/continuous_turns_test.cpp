#include "planner/continuous_turns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/drivable_path.h"
#include "planner/planners.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kSharpness = 0.4;  // 1/m2
constexpr double kArcRadius_m = 3.0;
constexpr double kSameForm = 1e-9;

double total_turn_rad(const std::vector<Arc>& arcs) {
  double sum_rad = 0.0;
  for (const Arc& arc : arcs) {
    const double sign = arc.gear == Gear::kForward ? 1.0 : -1.0;
    sum_rad += sign * arc.length_m * 0.5 * (arc.curvature_per_m + end_curvature_per_m(arc));
  }
  return sum_rad;
}

// The cheapest that exists between two poses.
std::optional<Turn> cheapest_ramped(const Pose& from, const Pose& to, double radius_m,
                                    Gears gears) {
  const double wide_m = ramped_radius_m(radius_m, kSharpness);
  std::optional<Turn> best;
  for (const Turn& word : turns(from, to, wide_m, gears)) {
    auto turn = continuous_turn(from, to, word.arcs, kSharpness, wide_m / radius_m);
    if (turn && (!best || turn->cost_m < best->cost_m)) best = std::move(turn);
  }
  return best;
}

TEST(Clothoid, IsWhereManySmallArcsLeadTo) {
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    const Arc clothoid{4.0, -0.2, gear, 0.3};
    const Pose from{{1.0, 2.0}, 0.7};
    constexpr int kPieces = 4000;
    Pose pose = from;
    for (int i = 0; i < kPieces; ++i) {
      const double middle_m = 4.0 * (i + 0.5) / kPieces;
      pose = pose_along(pose, {4.0 / kPieces, -0.2 + 0.3 * middle_m, gear}, 4.0 / kPieces);
    }
    const Pose end = pose_along(from, clothoid, 4.0);
    // The arcs' error goes with the square of their length: 1e-6 at 4 m of 1 mm.
    EXPECT_LT((end.p_W - pose.p_W).norm(), 1e-6);
    EXPECT_NEAR(wrap_angle(end.heading_rad - pose.heading_rad), 0.0, kSameForm);
    EXPECT_NEAR(end_curvature_per_m(clothoid), 1.0, kSameForm);
    const Pose back = end_of(end, driven_back({clothoid}));
    EXPECT_LT((back.p_W - from.p_W).norm(), kSameForm);
  }
}

TEST(Clothoid, IsSampledWithItsCurvature) {
  const auto segments = sample({}, {{2.0, 0.0, Gear::kForward, 0.25}}, 0.5);
  ASSERT_EQ(segments.size(), 1U);
  ASSERT_EQ(segments[0].points.size(), 5U);
  for (int i = 0; i <= 4; ++i) {
    EXPECT_NEAR(segments[0].points[static_cast<std::size_t>(i)].curvature_per_m, 0.125 * i,
                kSameForm);
  }
}

// Every arc of angle a takes a R + (1/R)/sharpness, the ramps being half lost.
TEST(ContinuousTurn, UTurnHasItsAnalyticLength) {
  const Pose from{{0.0, 0.0}, kPi / 2.0};
  const Pose to{{12.0, 0.0}, -kPi / 2.0};
  const auto turn = cheapest_ramped(from, to, kArcRadius_m, Gears::kForwardOnly);
  ASSERT_TRUE(turn);
  EXPECT_NEAR(total_turn_rad(turn->arcs), -kPi, 1e-6);
  // A quarter turn brings the vehicle by ends.x() sideways, the rest is straight.
  const double ramp_m = 1.0 / (kArcRadius_m * kSharpness);
  const double arc_m = kPi / 2.0 * kArcRadius_m - ramp_m;
  const std::vector<Arc> quarter{{ramp_m, 0.0, Gear::kForward, -kSharpness},
                                 {arc_m, -1.0 / kArcRadius_m, Gear::kForward},
                                 {ramp_m, -1.0 / kArcRadius_m, Gear::kForward, kSharpness}};
  const double sideways_m = end_of(from, quarter).p_W.x();
  EXPECT_NEAR(turn->cost_m, 2.0 * (arc_m + 2.0 * ramp_m) + 12.0 - 2.0 * sideways_m, 1e-6);
}

TEST(ContinuousTurn, ThreePointTurnsHaveNoRampsWhereTheyStop) {
  const Pose from{{0.0, 0.0}, kPi / 2.0};
  const Pose to{{2.0, 0.0}, -kPi / 2.0};
  int with_cusps = 0;
  for (const Turn& word : turns(from, to, kArcRadius_m)) {
    const auto turn = continuous_turn(from, to, word.arcs, kSharpness);
    if (!turn || cusp_count(turn->arcs) == 0) continue;
    ++with_cusps;
    for (std::size_t i = 1; i < turn->arcs.size(); ++i) {
      if (turn->arcs[i].gear == turn->arcs[i - 1].gear) continue;
      EXPECT_EQ(turn->arcs[i].sharpness_per_m2, 0.0);
      EXPECT_EQ(turn->arcs[i - 1].sharpness_per_m2, 0.0);
    }
  }
  EXPECT_GT(with_cusps, 0);
}

RC_GTEST_PROP(ContinuousTurn, EndsWhereItShallAndBendsNoFasterThanAllowed, ()) {
  const auto number = [](int low, int high) {
    return 0.01 * *rc::gen::inRange(100 * low, 100 * high);
  };
  const Pose from{{number(-10, 10), number(-10, 10)}, number(-3, 3)};
  const Pose to{{number(-10, 10), number(-10, 10)}, number(-3, 3)};
  int found = 0;
  for (const Turn& word : turns(from, to, kArcRadius_m)) {
    const auto turn = continuous_turn(from, to, word.arcs, kSharpness);
    if (!turn) continue;
    ++found;
    const Pose end = end_of(from, turn->arcs);
    RC_ASSERT((end.p_W - to.p_W).norm() < 1e-6);
    RC_ASSERT(std::abs(wrap_angle(end.heading_rad - to.heading_rad)) < 1e-6);
    RC_ASSERT(is_continuous(turn->arcs));
    for (const Arc& arc : turn->arcs) {
      RC_ASSERT(std::abs(arc.sharpness_per_m2) <= kSharpness + kSameForm);
      RC_ASSERT(std::abs(arc.curvature_per_m) <= 1.0 / kArcRadius_m + kSameForm);
      RC_ASSERT(std::abs(end_curvature_per_m(arc)) <= 1.0 / kArcRadius_m + kSameForm);
    }
    RC_ASSERT(length_m(turn->arcs) >= reeds_shepp_length_m(from, to, kArcRadius_m) - 1e-6);
  }
  // Some word always leaves room for its ramps where the ends are a circle apart.
  if ((to.p_W - from.p_W).norm() > 4.0 * kArcRadius_m) RC_ASSERT(found > 0);
}

TEST(ContinuousTurn, PlainArcsAreNot) {
  EXPECT_FALSE(is_continuous({{3.0, 0.3, Gear::kForward}}));
  EXPECT_TRUE(is_continuous({{3.0, 0.3, Gear::kReverse}})) << "it stops before and after";
  EXPECT_TRUE(is_continuous({{3.0, 0.0, Gear::kForward}}));
}

TEST(ContinuousTurn, VehiclesSteerAtTheirRate) {
  const Vehicle tractor = load_vehicle("utility_tractor");
  const double sharpness = turning_sharpness_per_m2(tractor);
  // Time from straight to the planning radius, at turning speed and the steering's rate, in a
  // single track: never longer than the ramp takes.
  const double radius_m = planning_turning_radius_m(tractor);
  const double steer_s = steer_for(tractor, 1.0 / radius_m) / tractor.steering.max_rate_rad_per_s;
  const double ramp_s = 1.0 / radius_m / sharpness / tractor.driver.turn_speed_mps;
  EXPECT_GE(ramp_s, steer_s);
  EXPECT_LT(ramp_s, 1.25 * steer_s);
  EXPECT_EQ(turning_sharpness_per_m2(load_vehicle("skid_steer_robot")), 0.0);
}

Plan four_rows() {
  Plan plan;
  plan.headland_width_m = 12.0;
  for (int i = 0; i < 4; ++i) {
    const double x = 12.0 + 3.0 * i;
    Pass pass{PassKind::kSwath, {{x, 14.0}, {x, 46.0}}};
    if (i % 2 == 1) std::swap(pass.points_W[0], pass.points_W[1]);
    plan.passes.push_back(pass);
  }
  return plan;
}

// Largest change of curvature from point to point of turns, a metre, but at changes of gear.
double sharpest_per_m2(const Path& path) {
  double most = 0.0;
  for (const PathSegment& segment : path.segments) {
    if (segment.implement_down) continue;
    for (std::size_t i = 1; i < segment.points.size(); ++i) {
      const PathPoint& a = segment.points[i - 1];
      const PathPoint& b = segment.points[i];
      most =
          std::max(most, std::abs(b.curvature_per_m - a.curvature_per_m) / (b.p_W - a.p_W).norm());
    }
  }
  return most;
}

TEST(ContinuousTurns, PathsHaveThemWhereAsked) {
  Vehicle vehicle = made_up_vehicle(2.6, 3.0);
  vehicle.steering.max_rate_rad_per_s = 0.5;
  vehicle.driver.turn_speed_mps = 1.0;
  const Field field = field_of("f", rectangle_ring(0, 0, 45, 60));
  PathOptions options;
  const Path plain = make_path(field, vehicle, four_rows(), options);
  options.continuous_turns = true;
  const Path smooth = make_path(field, vehicle, four_rows(), options);
  EXPECT_EQ(smooth.abrupt_turns, 0);
  EXPECT_EQ(smooth.abrupt_joints, 0) << "all passes are straight";
  const double limit = turning_sharpness_per_m2(vehicle);
  EXPECT_GT(sharpest_per_m2(plain), 2.0 * limit);
  // Chords are shorter than what they stand for by less than 1 %.
  EXPECT_LT(sharpest_per_m2(smooth), 1.01 * limit);
  EXPECT_GT(length_m(smooth), length_m(plain));
}

TEST(ContinuousTurns, JumpToBentPassesAtTheirEnds) {
  constexpr double kPass_per_m = 0.1;
  const std::vector<Arc> turn{{2.0, 0.0, Gear::kForward, 0.15}, {2.0, 0.3, Gear::kForward, -0.15}};
  EXPECT_EQ(abrupt_joints(turn, 0.0, 0.0), 0);
  EXPECT_EQ(abrupt_joints(turn, kPass_per_m, 0.0), 1);
  EXPECT_EQ(abrupt_joints(turn, kPass_per_m, -kPass_per_m), 2);
  EXPECT_EQ(abrupt_joints(turn, 0.5 * kJointJump_per_m, 0.0), 0) << "within what is not known";
  // The vehicle stops where it goes into reverse.
  const std::vector<Arc> backed{{2.0, 0.0, Gear::kReverse}, {2.0, 0.0, Gear::kForward}};
  EXPECT_EQ(abrupt_joints(backed, kPass_per_m, kPass_per_m), 1);
}

TEST(ContinuousTurns, EndsAtBentPassesAreCounted) {
  Vehicle vehicle = made_up_vehicle(2.6, 3.0);
  vehicle.steering.max_rate_rad_per_s = 0.5;
  vehicle.driver.turn_speed_mps = 1.0;
  const auto row = [](double y) { return Pass{PassKind::kSwath, {{35.0, y}, {65.0, y}}}; };
  Plan plan;
  plan.passes.push_back(row(30.0));
  // A round on a circle of 15 m, with a turn before it and one after it.
  Pass round{PassKind::kHeadlandPass, {}};
  constexpr int kChords = 120;
  for (int i = 0; i <= kChords; ++i) {
    round.points_W.emplace_back(Eigen::Vector2d(50.0, 50.0) +
                                15.0 * direction_of(2.0 * kPi * (i % kChords) / kChords));
  }
  plan.passes.push_back(round);
  plan.passes.push_back(row(70.0));
  PathOptions options;
  options.continuous_turns = true;
  const Field field = field_of("f", rectangle_ring(0, 0, 100, 100));
  const Path path = make_path(field, vehicle, plan, options);
  EXPECT_EQ(path.abrupt_turns, 0);
  EXPECT_EQ(path.abrupt_joints, 2);
  options.continuous_turns = false;
  EXPECT_EQ(make_path(field, vehicle, plan, options).abrupt_joints, 0) << "nobody asked";
}

TEST(ContinuousTurns, LeadFromTheEntryToo) {
  Vehicle vehicle = made_up_vehicle(2.6, 3.0);
  vehicle.steering.max_rate_rad_per_s = 0.5;
  vehicle.driver.turn_speed_mps = 1.0;
  Field field = field_of("f", rectangle_ring(0, 0, 45, 60));
  field.entry_W = {30.0, 30.0};
  PathOptions options;
  options.continuous_turns = true;
  const Path path = make_path(field, vehicle, four_rows(), options);
  EXPECT_EQ(path.abrupt_turns, 0);
  EXPECT_LT(sharpest_per_m2(path), 1.01 * turning_sharpness_per_m2(vehicle));
}

TEST(ContinuousTurns, AreToldWhereNoneFitsAndRefusedOfSkidSteering) {
  Vehicle vehicle = made_up_vehicle(2.6, 3.0);
  vehicle.steering.max_rate_rad_per_s = 0.005;  // a ramp takes 60 m
  vehicle.driver.turn_speed_mps = 1.0;
  vehicle.implement.trailing
      .emplace();  // nothing is driven in reverse, where it could steer at rest
  PathOptions options;
  options.continuous_turns = true;
  const Plan plan = four_rows();
  const Path path = make_path(field_of("f", rectangle_ring(0, 0, 45, 60)), vehicle, plan, options);
  EXPECT_EQ(path.abrupt_turns, 3);
  const Vehicle skid = load_vehicle("skid_steer_robot");
  EXPECT_THROW(make_path(field_of("f", rectangle_ring(0, 0, 45, 60)), skid, plan, options),
               InputError);
}

}  // namespace
}  // namespace headland
