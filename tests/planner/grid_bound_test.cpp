#include "planner/grid_bound.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/planner/grid_examples.h"

namespace headland {
namespace {

int least(const std::string& drawn, bool closed = false) {
  GridPlanRequest request;
  request.map = drawn_map(drawn);
  request.closed = closed;
  return least_steps(grid_problem(request));
}

TEST(LeastSteps, AreThoseOfASnakeWhereNothingIsBlocked) {
  EXPECT_EQ(least("."), 0);
  EXPECT_EQ(least(".."), 1);
  EXPECT_EQ(least("....\n....\n...."), 11);
}

TEST(LeastSteps, OfAClosedTourAreEven) {
  EXPECT_EQ(least("..\n..", true), 4);
  // Nine cells: one colour has one more, which is come back to.
  EXPECT_EQ(least("...\n...\n...", true), 10);
  EXPECT_EQ(least("...", true), 4);
}

// Four arms of one cell around the middle: the path begins in one, ends in another, and comes back
// from two; both colours of a chessboard would ask for two steps less.
TEST(LeastSteps, CountsDeadEnds) {
  EXPECT_EQ(least("#.#\n...\n#.#"), 6);
  // A comb, whose five teeth of one cell and of the same colour are balanced elsewhere.
  EXPECT_EQ(least("#.#.#.#\n......."), 12);
}

TEST(LeastSteps, KeepTheParityOfGivenEnds) {
  GridPlanRequest request;
  request.map = drawn_map("....\n....");
  request.start = GridCell{0, 0};
  request.end = GridCell{1, 0};
  EXPECT_EQ(least_steps(grid_problem(request)), 7);
  request.end = GridCell{2, 0};
  EXPECT_EQ(least_steps(grid_problem(request)), 8);
}

}  // namespace
}  // namespace headland
