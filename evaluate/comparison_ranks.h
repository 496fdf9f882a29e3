// Whether the planners of a comparison differ, by rank tests on one figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/rank_tests.h"

namespace headland {

// A pair of planners (by their place in the comparison) with Wilcoxon's test.
struct PlannerPair {
  int first = 0;
  int second = 0;
  WilcoxonTest test;
  double holm_p = 1.0;  // of all pairs together
};

struct ComparisonRanks {
  Blocks blocks;            // of the figure, less being better; infinity: failed
  int blocks_left_out = 0;  // some planner's runs are missing: the comparison was ended early
  int failures = 0;         // refused runs and plans with jumps; they rank last in their block
  std::vector<double> average_ranks;
  std::optional<FriedmanTest> friedman;  // of at least kLeastFriedmanBlocks
  double distance = 0.0;                 // Bonferroni and Dunn; 0: no control, or no test
  int control = -1;                      // planner, -1: none
  // With a control the pairs of it and each other, else all.
  std::vector<PlannerPair> pairs;
  // No pair of so few blocks could come out significant, not even one that always wins.
  bool pairs_too_few = false;
  std::vector<std::string> notes;  // overrun budgets; what the tests cannot say, what would help
};

// A block is a map, with the mean over the repeats, or a single run (ComparisonTests). A planner
// that failed in any run of a map failed on the map: a mean over the other runs would flatter it.
// Figures are rounded to kFigureDigits digits, so that sums of weights tie as they should.
ComparisonRanks rank_planners(const Comparison& comparison, const std::vector<ComparedRun>& runs);

inline constexpr int kFigureDigits = 12;

}  // namespace headland
