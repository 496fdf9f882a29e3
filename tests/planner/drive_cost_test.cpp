#include "planner/drive_cost.h"

#include <gtest/gtest.h>

#include <numbers>

#include "planner/arcs.h"
#include "planner/path_energy.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

constexpr double kWhRounding = 1e-9;
constexpr double kQuarter_rad = 0.5 * std::numbers::pi;

TEST(SlopeCosts, AreMeetAndJoinWhatWasMeasured) {
  const SlopeCost cost = made_up_cost().working;
  EXPECT_NEAR(wh_per_m(cost, 0.0), 1.0, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, 0.1), 1.8, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, 0.05), 1.4, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, -0.2), 0.2, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, 0.0, 0.1), 1.02, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, 0.0, -0.1), 1.02, kWhRounding);
}

// On by the last line, then held; never below nothing.
TEST(SlopeCosts, BeyondWhatWasMeasuredGoOnAndAreHeld) {
  const SlopeCost cost = made_up_cost().working;
  EXPECT_NEAR(wh_per_m(cost, 0.3), 3.4, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, kSteepest), 5.0, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, 9.0), 5.0, kWhRounding);
  EXPECT_NEAR(wh_per_m(cost, -0.25), 0.1, kWhRounding);
  EXPECT_EQ(wh_per_m(cost, -0.45), 0.0);
  EXPECT_NEAR(wh_per_m(cost, 0.0, 9.0), 1.0 + 2.0 * kSteepest * kSteepest, kWhRounding);
  EXPECT_NEAR(wh_per_m(made_up_cost().transit, 0.2), 0.3, kWhRounding);  // one slope alone
}

TEST(RowTurns, AreTheCheapestThatTheSpacingAllows) {
  const DriveCost cost = made_up_cost();
  // 8 m raised at 0.4 and 1.2 more, against 12 m and 1.0 of the omega turn.
  const RowTurnCost near = cheapest_row_turn(cost, 2.0);
  EXPECT_EQ(near.kind, RowTurn::kThreePoint);
  EXPECT_NEAR(energy_wh(cost, near), 4.4, kWhRounding);
  const RowTurnCost far = cheapest_row_turn(cost, 8.0);
  EXPECT_EQ(far.kind, RowTurn::kU);
  EXPECT_NEAR(energy_wh(cost, far), 12.0 * 0.4 + 0.7, kWhRounding);
  EXPECT_NEAR(energy_wh(cost, cheapest_row_turn(cost, 20.0)), 14.0 * 0.4 + 0.9, kWhRounding);
  EXPECT_EQ(cheapest_row_turn(cost, 0.0).kind, RowTurn::kThreePoint);
}

PathSegment segment_of(PathKind kind, Gear gear, bool down, const Pose& from,
                       const std::vector<Arc>& arcs, int manoeuvre) {
  PathSegment segment = sample(from, arcs, 0.25).front();
  segment.kind = kind;
  segment.gear = gear;
  segment.implement_down = down;
  segment.manoeuvre = manoeuvre;
  return segment;
}

Path straight_path(bool down, PathKind kind) {
  Path path;
  path.segments = {
      segment_of(kind, Gear::kForward, down, {{0.0, 0.0}, 0.0}, {{100.0, 0.0, Gear::kForward}}, 0)};
  return path;
}

// A plane that rises to the east.
Heightfield ramp(double slope) {
  Heightfield terrain;
  terrain.columns = terrain.rows = 2;
  terrain.cell_m = 200.0;
  terrain.origin_W = {-50.0, -50.0};
  terrain.height_m = {0.0, 200.0 * slope, 0.0, 200.0 * slope};
  return terrain;
}

TEST(PredictedEnergyTest, OfAStraightIsItsMetresAndAStop) {
  const DriveCost cost = made_up_cost();
  EXPECT_NEAR(predicted_energy(straight_path(true, PathKind::kSwath), nullptr, cost).energy_wh,
              100.0 + 0.8, kWhRounding);
  EXPECT_NEAR(predicted_energy(straight_path(false, PathKind::kTurn), nullptr, cost).energy_wh,
              40.0 + 0.2, kWhRounding);
  EXPECT_NEAR(predicted_energy(straight_path(false, PathKind::kTransit), nullptr, cost).energy_wh,
              30.0 + 0.2, kWhRounding);
  const Heightfield uphill = ramp(0.1);
  const Heightfield downhill = ramp(-0.1);
  EXPECT_NEAR(predicted_energy(straight_path(true, PathKind::kSwath), &uphill, cost).energy_wh,
              180.0 + 0.8, kWhRounding);
  EXPECT_NEAR(predicted_energy(straight_path(true, PathKind::kSwath), &downhill, cost).energy_wh,
              40.0 + 0.8, kWhRounding);
}

// A swath, a turn of a half circle in two gears, a swath.
TEST(PredictedEnergyTest, OfATurnIsItsBendsCuspsAndLowering) {
  const DriveCost cost = made_up_cost();
  const double quarter_m = kQuarter_rad * 2.5;
  Path path = straight_path(true, PathKind::kSwath);
  const auto add = [&](PathKind kind, Gear gear, bool down, const Arc& arc, int manoeuvre) {
    const Pose from = pose_of(path.segments.back().points.back());
    path.segments.push_back(segment_of(kind, gear, down, from, {arc}, manoeuvre));
  };
  add(PathKind::kUTurn, Gear::kForward, false, {quarter_m, 0.4, Gear::kForward}, 1);
  add(PathKind::kUTurn, Gear::kReverse, false, {5.0, 0.0, Gear::kReverse}, 1);
  add(PathKind::kUTurn, Gear::kForward, false, {quarter_m, 0.4, Gear::kForward}, 1);
  add(PathKind::kSwath, Gear::kForward, true, {50.0, 0.0, Gear::kForward}, 2);
  const PredictedEnergy predicted = predicted_energy(path, nullptr, cost);
  EXPECT_EQ(predicted.cycles, 1);
  EXPECT_EQ(predicted.cusps, 2);
  EXPECT_NEAR(predicted.raised_quarters, 2.0, 1e-3);  // chords of the arcs
  EXPECT_NEAR(predicted.working_m, 150.0, 1e-6);
  const double turn_wh = 0.4 * predicted.raised_m + 2.0 * 0.125 + 2.0 * 0.5 + 0.25;
  EXPECT_NEAR(predicted.by_kind_wh[static_cast<std::size_t>(PathKind::kUTurn)], turn_wh, 1e-3);
  EXPECT_NEAR(predicted.energy_wh, 150.0 + 0.8 + turn_wh, 1e-3);
}

// Where a swath begins at a change of gear it begins from standstill.
TEST(PredictedEnergyTest, ASwathFromStandstillTakesHalfAStop) {
  const DriveCost cost = made_up_cost();
  Path path = straight_path(false, PathKind::kTurn);
  path.segments.front().gear = Gear::kReverse;
  path.segments.push_back(segment_of(PathKind::kSwath, Gear::kForward, true, {{100.0, 0.0}, 0.0},
                                     {{50.0, 0.0, Gear::kForward}}, 1));
  const PredictedEnergy predicted = predicted_energy(path, nullptr, cost);
  EXPECT_NEAR(predicted.by_kind_wh[static_cast<std::size_t>(PathKind::kSwath)], 50.0 + 0.4 + 0.4,
              kWhRounding);
}

TEST(PredictedEnergyTest, WideBendsTakeLessInProportion) {
  const DriveCost cost = made_up_cost();
  const auto bend_wh = [&](double radius_m) {
    Path path;
    path.segments = {segment_of(PathKind::kHeadlandPass, Gear::kForward, true, {{0.0, 0.0}, 0.0},
                                {{kQuarter_rad * radius_m, 1.0 / radius_m, Gear::kForward}}, 0)};
    const PredictedEnergy predicted = predicted_energy(path, nullptr, cost);
    return predicted.energy_wh - predicted.working_m - 0.8;
  };
  EXPECT_NEAR(bend_wh(2.5), 0.5, 1e-3);
  EXPECT_NEAR(bend_wh(10.0), 0.125, 1e-3);
}

TEST(PredictedEnergyTest, OfNothingIsNothing) {
  EXPECT_EQ(predicted_energy({}, nullptr, made_up_cost()).energy_wh, 0.0);
}

}  // namespace
}  // namespace headland
