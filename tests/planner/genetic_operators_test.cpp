// Operators of the papers' searches on orders small enough to reckon by hand.
#include "planner/genetic_operators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planner/order_population.h"
#include "tests/planner/grid_examples.h"

namespace headland {
namespace {

using testing::ElementsAre;

constexpr double kRounding = 1e-12;

// Genes 1 to 10 without 2 as nodes 0 to 8.
std::vector<int> nodes_of(std::vector<int> genes) {
  for (int& gene : genes) gene -= gene > 2 ? 2 : 1;
  return genes;
}

// Wu et al., Figure 9, by the rule of 2.2.4; the child printed there is the first parent itself.
TEST(Crossed, IsThePapersExampleByItsRule) {
  const std::vector<int> one = nodes_of({1, 8, 10, 6, 9, 7, 4, 3, 5});
  const std::vector<int> child = nodes_of({1, 8, 10, 6, 3, 7, 5, 9, 4});
  EXPECT_EQ(crossed(one, nodes_of({1, 3, 7, 10, 8, 5, 6, 9, 4}), 4), child);
  EXPECT_EQ(crossed(one, nodes_of({3, 6, 10, 7, 5, 8, 9, 4, 1}), 4), child);
  EXPECT_EQ(crossed(one, child, static_cast<int>(one.size())), one);
}

TEST(Crossed, KeepsTheTwoEndsOfAClosedTour) {
  EXPECT_THAT(crossed({2, 0, 1, 3, 2}, {2, 3, 1, 0, 2}, 2), ElementsAre(2, 0, 3, 1, 2));
}

// Eq (2): 0.3 (1 + (10 - 8) / 10) = 0.36 of repeats; what is at the mean or below keeps its weight
// before all are scaled by their sum, 1.06.
TEST(AdaptWeights, IsEqTwoByHand) {
  Three weights = {0.3, 0.2, 0.5};
  adapt_weights({8.0, 5.0, 2.0}, {10.0, 5.0, 1.0}, weights);
  EXPECT_NEAR(weights[0], 0.36 / 1.06, kRounding);
  EXPECT_NEAR(weights[1], 0.20 / 1.06, kRounding);
  EXPECT_NEAR(weights[2], 0.50 / 1.06, kRounding);
}

// Orders of the cells of a row: distances are differences of the nodes.
struct RowOfCells {
  GridPlanRequest request;
  OrderTask task;
  OrderSearch search;
  RowOfCells() : request{request_of()}, task(request), search(order_search(task)) {}
  static GridPlanRequest request_of() {
    GridPlanRequest request;
    request.map = drawn_map("........\n");
    return request;
  }
  Individual of(std::vector<int> order) const { return individual_of(task.cost, std::move(order)); }
};

// Wang et al., Figure 5: the node after order[k] in the teacher comes beside it.
TEST(Learn, PutsThePairTogetherAndLeavesItsFirstNodeWhereItIs) {
  RowOfCells row;
  const Individual teacher = row.of({0, 1, 2, 3, 4, 5, 6, 7});
  // 1 at place 1, 2 at place 4: places 2 to 4 are turned round.
  Individual later = row.of({0, 1, 4, 3, 2, 5, 6, 7});
  EXPECT_TRUE(learn(row.search, later, teacher, 1, Keep::kBetter));
  EXPECT_THAT(later.order, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(later.cost, 7.0);
  EXPECT_EQ(later.cost, full_cost(row.task.cost, later.order));
  // 5 at place 5, 6 at place 1: places 1 to 4 are turned round, 6 comes before 5.
  Individual earlier = row.of({0, 6, 7, 2, 1, 5, 4, 3});
  EXPECT_TRUE(learn(row.search, earlier, teacher, 5, Keep::kBetter));
  EXPECT_THAT(earlier.order, ElementsAre(0, 1, 2, 7, 6, 5, 4, 3));
  EXPECT_EQ(earlier.cost, 11.0);
}

TEST(Learn, KeepsNothingThatIsWorse) {
  RowOfCells row;
  const Individual teacher = row.of({0, 7, 1, 2, 3, 4, 5, 6});
  Individual one = row.of({0, 1, 2, 3, 4, 5, 6, 7});
  const auto evaluations = row.task.search.evaluations;
  EXPECT_FALSE(learn(row.search, one, teacher, 0, Keep::kNotWorse));
  EXPECT_THAT(one.order, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(row.task.search.evaluations, evaluations + 1);
}

// 3 5 4 0 and 3 4 5 0 are seven steps each.
TEST(Learn, KeepsWhatIsEqualByRule) {
  RowOfCells row;
  const Individual teacher = row.of({3, 4, 5, 0, 1, 2, 6, 7});
  Individual one = row.of({3, 5, 4, 0, 1, 2, 6, 7});
  EXPECT_FALSE(learn(row.search, one, teacher, 0, Keep::kBetter));
  EXPECT_TRUE(learn(row.search, one, teacher, 0, Keep::kNotWorse));
  EXPECT_EQ(one.order, teacher.order);
  EXPECT_EQ(one.cost, teacher.cost);
}

}  // namespace
}  // namespace headland
