#include "planner/swath_pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace headland {
namespace {

using testing::ElementsAre;

std::size_t apart(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }

TEST(SwathPattern, EachIsAnOrderOfAllSwaths) {
  for (const SwathPattern pattern :
       {SwathPattern::kNext, SwathPattern::kSkip, SwathPattern::kSpiral}) {
    for (std::size_t skip = 0; skip <= 7; ++skip) {
      for (std::size_t count = 0; count <= 60; ++count) {
        std::vector<std::size_t> sequence = swath_sequence(count, pattern, skip);
        std::ranges::sort(sequence);
        std::vector<std::size_t> all(count);
        std::iota(all.begin(), all.end(), 0);
        ASSERT_EQ(sequence, all) << count << " swaths, " << skip << " left between";
      }
    }
  }
}

TEST(SwathPattern, AreWhatTheyAreCalled) {
  EXPECT_THAT(swath_sequence(5, SwathPattern::kNext, 3), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(swath_sequence(5, SwathPattern::kSpiral, 3), ElementsAre(0, 4, 1, 3, 2));
  EXPECT_THAT(swath_sequence(5, SwathPattern::kSkip, 1), ElementsAre(0, 3, 1, 4, 2));
  EXPECT_THAT(swath_sequence(7, SwathPattern::kSkip, 2), ElementsAre(0, 4, 1, 5, 2, 6, 3));
}

// Where there are enough swaths for it, any two that follow each other leave `skip` between, and
// none are further apart than a land is wide.
TEST(SwathPattern, SkippingLeavesAsManyBetweenAsAsked) {
  for (std::size_t skip = 1; skip <= 6; ++skip) {
    const std::size_t land = 2 * skip + 3;
    for (std::size_t count = land; count <= 20 * land; ++count) {
      const auto sequence = swath_sequence(count, SwathPattern::kSkip, skip);
      for (std::size_t i = 1; i < sequence.size(); ++i) {
        const std::size_t between = apart(sequence[i - 1], sequence[i]) - 1;
        ASSERT_GE(between, skip) << "after place " << i << " of " << count;
        ASSERT_LE(between, 2 * land) << "after place " << i << " of " << count;
      }
    }
  }
}

TEST(SwathPattern, AsManyAreSkippedAsAUTurnNeeds) {
  EXPECT_EQ(skip_for_u_turns(5.0, 2.5), 0U);  // the next swath is two radii away
  EXPECT_EQ(skip_for_u_turns(4.9, 2.5), 1U);
  EXPECT_EQ(skip_for_u_turns(2.0, 4.5), 4U);  // the fifth is 10 m away, the fourth 8 m
}

}  // namespace
}  // namespace headland
