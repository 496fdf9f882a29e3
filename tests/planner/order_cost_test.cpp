#include "planner/order_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "planner/grid_path.h"
#include "planner/grid_plan.h"
#include "planner/seeded_random.h"
#include "terrains/grid_map_generator.h"
#include "tests/planner/grid_examples.h"
#include "tests/planner/made_up_cost.h"

namespace headland {
namespace {

constexpr double kChangeRounding = 1e-8;  // of differences of sums up to a few thousand
constexpr int kChangesTried = 3000;

// Another method: the path drawn out, counted step by step.
double counted_cost(const OrderCost& cost, const GridCost& asked, const std::vector<int>& order) {
  const GridCounts counts = count_path(*cost.graph, expanded(cost, order));
  return cost_of(asked, counts, cost.graph->cell_m);
}

class EveryObjective : public testing::TestWithParam<std::tuple<GridObjective, bool>> {
 protected:
  EveryObjective() {
    GridMap map = made_up_grid_map({9, 8, 0.2, 4, 7}, "test");
    if (std::get<1>(GetParam())) {
      for (std::size_t i = 0; i < map.blocked.size(); ++i) {
        map.height_m.push_back(std::sin(static_cast<double>(i)));
      }
    }
    map.cell_m = 2.0;
    request_.map = map;
    request_.cost.objective = std::get<0>(GetParam());
    if (request_.cost.objective == GridObjective::kMeasured) {
      request_.cost.measured = made_up_cost();
    }
    problem_ = grid_problem(request_);
    table_ = distance_table(problem_.graph, "test");
    cost_ = order_cost(problem_.graph, table_, request_.cost);
  }

  GridPlanRequest request_;
  GridProblem problem_;
  DistanceTable table_;
  OrderCost cost_;
  SeededRandom random_{5};
};

TEST_P(EveryObjective, FullCostIsThatOfThePath) {
  for (int i = 0; i < 20; ++i) {
    const std::vector<int> order = random_order(problem_, random_);
    EXPECT_NEAR(full_cost(cost_, order), counted_cost(cost_, request_.cost, order),
                kChangeRounding);
  }
}

TEST_P(EveryObjective, ChangesAreDifferencesOfFullCosts) {
  std::vector<int> order = random_order(problem_, random_);
  const int size = static_cast<int>(order.size());
  for (int k = 0; k < kChangesTried; ++k) {
    std::vector<int> changed = order;
    double change = 0.0;
    const int a = draw_below(random_, size);
    const int b = draw_below(random_, size);
    const int i = std::min(a, b);
    const int j = std::max(a, b);
    if (k % 3 == 0) {
      change = change_by_reversal(cost_, order, i, j);
      std::reverse(changed.begin() + i, changed.begin() + j + 1);
    } else if (k % 3 == 1) {
      change = change_by_swap(cost_, order, a, b);
      std::swap(changed[a], changed[b]);
    } else {
      // Near places too, where sections and their new surroundings overlap.
      const int to = k % 2 == 0 ? draw_below(random_, size + 1) - 1
                                : std::clamp(j + draw_below(random_, 9) - 4, -1, size - 1);
      const int end = std::min(j, i + draw_below(random_, 4));
      if (to >= i - 1 && to <= end) continue;
      const bool turned_round = draw_below(random_, 2) == 0;
      change = change_by_move(cost_, order, i, end, to, turned_round);
      move_section(changed, i, end, to, turned_round);
    }
    ASSERT_NEAR(full_cost(cost_, changed) - full_cost(cost_, order), change, kChangeRounding)
        << "kind " << k % 3 << ", places " << i << " " << j << " of " << size;
    order = changed;
  }
}

INSTANTIATE_TEST_SUITE_P(
    OrderCost, EveryObjective,
    testing::Combine(testing::Values(GridObjective::kLength, GridObjective::kWeighted,
                                     GridObjective::kTractor, GridObjective::kMeasured),
                     testing::Bool()));

}  // namespace
}  // namespace headland
