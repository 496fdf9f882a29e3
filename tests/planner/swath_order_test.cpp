#include "planner/swath_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "planner/seeded_random.h"
#include "planner/swath_pattern.h"
#include "tests/planner/made_up_cost.h"
#include "tests/planner/waves.h"

namespace headland {
namespace {

constexpr double kCostRounding = 1e-6;

Pass swath(double x_m, double from_m, double to_m) {
  return {PassKind::kSwath, {{x_m, from_m}, {x_m, to_m}}};
}

// Parallel swaths `spacing_m` apart with ragged ends, driven up and down.
std::vector<Pass> up_and_down(std::size_t count, double spacing_m, std::uint64_t seed) {
  SeededRandom random(seed);
  std::vector<Pass> swaths;
  for (std::size_t i = 0; i < count; ++i) {
    const double x_m = spacing_m * static_cast<double>(i);
    const double low_m = 8.0 * draw_unit(random) - 4.0;
    const double high_m = 60.0 + 8.0 * draw_unit(random) - 4.0;
    swaths.push_back(i % 2 == 0 ? swath(x_m, low_m, high_m) : swath(x_m, high_m, low_m));
  }
  return swaths;
}

// The least of all orders and directions (Held and Karp), by another way through the problem.
double least_cost(const std::vector<Pass>& swaths, const TurnCosts& costs) {
  std::vector<Pass> ways;
  for (const Pass& pass : swaths) {
    ways.push_back(pass);
    ways.push_back(pass);
    std::ranges::reverse(ways.back().points_W);
  }
  const std::size_t subsets = std::size_t{1} << swaths.size();
  std::vector<double> least(subsets * ways.size(), std::numeric_limits<double>::infinity());
  // One swath by itself: 0 in metres, what working it takes by measured costs.
  for (std::size_t way = 0; way < ways.size(); ++way) {
    least[(std::size_t{1} << (way / 2)) * ways.size() + way] =
        order_cost({ways[way]}, std::nullopt, costs);
  }
  for (std::size_t subset = 1; subset < subsets; ++subset) {
    for (std::size_t from = 0; from < ways.size(); ++from) {
      const double so_far = least[subset * ways.size() + from];
      if (so_far == std::numeric_limits<double>::infinity()) continue;
      for (std::size_t to = 0; to < ways.size(); ++to) {
        const std::size_t bit = std::size_t{1} << (to / 2);
        if ((subset & bit) != 0) continue;
        double& known = least[(subset | bit) * ways.size() + to];
        known = std::min(known, so_far + link_cost(ways[from], ways[to], costs) +
                                    order_cost({ways[to]}, std::nullopt, costs));
      }
    }
  }
  return *std::min_element(least.end() - static_cast<std::ptrdiff_t>(ways.size()), least.end());
}

TEST(SwathOrder, KeepsEverySwathOnce) {
  const std::vector<Pass> given = up_and_down(40, 2.0, 3);
  const std::vector<Pass> made = optimised_order(given, std::nullopt, {4.5, Gears::kBoth});
  ASSERT_EQ(made.size(), given.size());
  for (const Pass& pass : given) {
    EXPECT_EQ(std::ranges::count_if(made,
                                    [&](const Pass& other) {
                                      return other.points_W.front().x() ==
                                             pass.points_W.front().x();
                                    }),
              1);
  }
}

TEST(SwathOrder, IsNeverWorseThanGivenAndNearTheOptimum) {
  constexpr double kNearOptimum = 1.1;  // a local search from one order, and the best of all
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const Gears gears : {Gears::kBoth, Gears::kForwardOnly}) {
      const TurnCosts costs{4.0, gears};
      const std::vector<Pass> given = up_and_down(7, 2.5, seed);
      const double given_m = order_cost(given, std::nullopt, costs);
      const double made_m =
          order_cost(optimised_order(given, std::nullopt, costs), std::nullopt, costs);
      const double least_m = least_cost(given, costs);
      EXPECT_LE(made_m, given_m + kCostRounding);
      EXPECT_GE(made_m, least_m - kCostRounding);
      EXPECT_LE(made_m, kNearOptimum * least_m) << "seed " << seed;
    }
  }
}

// By measured costs an order is reckoned in W h, and uphill is dearer than downhill: the same check
// on ground where that tells, and the costs do not come back over a slope.
TEST(SwathOrder, IsNearTheOptimumByDirectedCosts) {
  constexpr double kNearOptimum =
      1.02;  // working the swaths, which no order changes, is most of it
  const Heightfield terrain = waves(4.0, 60.0, 0.1);
  const DriveCost cost = made_up_cost();
  const TurnCosts costs{cost.turning_radius_m, Gears::kBoth, &cost, &terrain};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<Pass> given = up_and_down(6, 2.5, seed);
    std::vector<Pass> backwards = given;
    std::ranges::reverse(backwards);
    for (Pass& pass : backwards) std::ranges::reverse(pass.points_W);
    const double given_wh = order_cost(given, std::nullopt, costs);
    EXPECT_GT(std::abs(order_cost(backwards, std::nullopt, costs) - given_wh), 1e-3 * given_wh);
    const double made_wh =
        order_cost(optimised_order(given, std::nullopt, costs), std::nullopt, costs);
    EXPECT_LE(made_wh, given_wh + kCostRounding);
    const double least_wh = least_cost(given, costs);
    EXPECT_GE(made_wh, least_wh - kCostRounding);
    EXPECT_LE(made_wh, kNearOptimum * least_wh) << "seed " << seed;
  }
}

// Level ends, 2 m apart, a radius of 4.5 m: a turn onto the next swath changes gear, a U-turn onto
// the fifth is half a circle and a metre. No order of that many swaths is cheaper than U-turns
// alone, which is nearly reached.
TEST(SwathOrder, PassesSwathsByForPlainTurns) {
  std::vector<Pass> swaths;
  for (int i = 0; i < 40; ++i) {
    const double x_m = 2.0 * i;
    swaths.push_back(i % 2 == 0 ? swath(x_m, 0.0, 60.0) : swath(x_m, 60.0, 0.0));
  }
  const TurnCosts costs{4.5, Gears::kBoth};
  const double next_m = order_cost(swaths, std::nullopt, costs);
  const double made_m =
      order_cost(optimised_order(swaths, std::nullopt, costs), std::nullopt, costs);
  const double bound_m = 39.0 * (4.5 * std::numbers::pi + 1.0);
  EXPECT_GT(next_m, 1.1 * bound_m);
  EXPECT_LT(made_m, 1.1 * bound_m);
  EXPECT_GE(made_m, bound_m - kCostRounding);
}

TEST(SwathOrder, BeginsWhereTheVehicleComesFrom) {
  const std::vector<Pass> given = up_and_down(30, 9.0, 5);
  const Eigen::Vector2d from_W = given.back().points_W.front() + Eigen::Vector2d(5.0, -5.0);
  const TurnCosts costs{4.5, Gears::kBoth};
  const std::vector<Pass> made = optimised_order(given, from_W, costs);
  std::vector<Pass> backwards = given;
  std::ranges::reverse(backwards);
  for (Pass& pass : backwards) std::ranges::reverse(pass.points_W);
  EXPECT_LT((made.front().points_W.front() - from_W).norm(), 60.0);  // of 270 m
  EXPECT_LE(order_cost(made, from_W, costs), order_cost(backwards, from_W, costs) + kCostRounding);
}

// Backwards along the same way the turns cost the same: what the search takes links for.
TEST(SwathOrder, CostsTheSameDrivenBackwards) {
  std::vector<Pass> swaths = up_and_down(20, 3.0, 8);
  for (const Gears gears : {Gears::kBoth, Gears::kForwardOnly}) {
    const double there_m = order_cost(swaths, std::nullopt, {4.0, gears});
    std::ranges::reverse(swaths);
    for (Pass& pass : swaths) std::ranges::reverse(pass.points_W);
    EXPECT_NEAR(order_cost(swaths, std::nullopt, {4.0, gears}), there_m, 1e-4);
  }
}

}  // namespace
}  // namespace headland
