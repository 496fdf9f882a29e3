// What a run does not depend on: threads, left or right, the way the world is turned.
#include <gtest/gtest.h>

#include <thread>

#include "sim/simulation.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

Vehicle transplanter() { return load_vehicle("transplanter"); }

bool same(const RunRecord& a, const RunRecord& b) {
  if (a.samples.size() != b.samples.size()) return false;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    if (a.samples[i].p_WB != b.samples[i].p_WB) return false;
    if (a.samples[i].battery_power_w != b.samples[i].battery_power_w) return false;
  }
  return a.energy.battery_j == b.energy.battery_j && a.outcome == b.outcome;
}

TEST(Invariance, SameSetupSameRecordAlsoInTwoThreads) {
  const Vehicle vehicle = transplanter();
  const Path path = test::rows_with_omega_turns(2, 20.0, 2.0, planning_turning_radius_m(vehicle));
  const Heightfield terrain = test::hills(0.5, 20.0);
  const SoilMap soil = test::textbook_soil();
  const RunRecord alone = test::run(path, vehicle, terrain, soil);
  EXPECT_TRUE(same(alone, test::run(path, vehicle, terrain, soil)));
  RunRecord first;
  RunRecord second;
  std::thread one([&] { first = test::run(path, vehicle, terrain, soil); });
  std::thread two([&] { second = test::run(path, vehicle, terrain, soil); });
  one.join();
  two.join();
  EXPECT_TRUE(same(alone, first));
  EXPECT_TRUE(same(alone, second));
}

TEST(Invariance, LeftTurnMirrorsRightTurnOnFlatGround) {
  Path left;
  test::extend(left, PathKind::kTransit, Gear::kForward, false, 5.0, 0.0);
  test::extend(left, PathKind::kUTurn, Gear::kForward, false, 8.0, 0.35);
  Path right = left;
  for (PathSegment& segment : right.segments) {
    for (PathPoint& point : segment.points) {
      point.p_W.y() = -point.p_W.y();
      point.heading_rad = -point.heading_rad;
      point.curvature_per_m = -point.curvature_per_m;
    }
  }
  const Heightfield flat = test::plane(0.0, 0.0);
  const RunRecord a = test::run(left, transplanter(), flat, test::textbook_soil());
  const RunRecord b = test::run(right, transplanter(), flat, test::textbook_soil());
  // The solver visits left wheels first, which is all that differs.
  constexpr double kSweepOrder = 1e-4;
  EXPECT_NEAR(a.energy.battery_j, b.energy.battery_j, kSweepOrder * a.energy.battery_j);
  EXPECT_NEAR(a.samples.back().p_WB.y(), -b.samples.back().p_WB.y(), 1e-3);
}

// Rows, turns and a slope, all turned by the same angle about the origin. A plane is the one ground
// whose grid of heights turns exactly.
TEST(Invariance, TurningTheWorldTurnsTheRun) {
  const Vehicle vehicle = transplanter();
  const Path path = test::rows_with_omega_turns(3, 20.0, vehicle.implement.working_width_m,
                                                planning_turning_radius_m(vehicle));
  constexpr double kTurn_rad = 2.1;
  const Eigen::Rotation2Dd turn(kTurn_rad);
  Path turned_path = path;
  for (PathSegment& segment : turned_path.segments) {
    for (PathPoint& point : segment.points) {
      point.p_W = turn * point.p_W;
      point.heading_rad += kTurn_rad;
    }
  }
  const Eigen::Vector2d slope(0.06, -0.04);
  const Eigen::Vector2d turned_slope = turn * slope;
  const RunRecord run =
      test::run(path, vehicle, test::plane(slope.x(), slope.y()), test::textbook_soil());
  const RunRecord turned = test::run(
      turned_path, vehicle, test::plane(turned_slope.x(), turned_slope.y()), test::textbook_soil());
  ASSERT_EQ(run.outcome, Outcome::kFinished) << run.outcome_detail;
  // Rounding may end a run one step sooner or later: 1/240 s of some 100 s.
  constexpr double kOneStep = 1e-4;
  EXPECT_NEAR(turned.energy.battery_j, run.energy.battery_j, kOneStep * run.energy.battery_j);
  ASSERT_EQ(turned.samples.size(), run.samples.size());
  for (std::size_t i = 0; i < run.samples.size(); i += 50) {
    const Eigen::Vector2d there = turn * run.samples[i].p_WB.head<2>();
    EXPECT_LT((turned.samples[i].p_WB.head<2>() - there).norm(), 1e-3) << run.samples[i].time_s;
  }
}

}  // namespace
}  // namespace headland
