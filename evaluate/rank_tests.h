// Rank tests on paired figures of several methods: whether they differ, and which.
//
// A block holds one figure of every method under the same conditions (a map, a run); less is
// better. Infinity stands for a method that failed in the block: it ranks last, together with the
// others that did.
#pragma once

#include <span>
#include <vector>

namespace headland {

// blocks[i][j]: figure of method j in block i; all blocks are of one size, no figure is NaN.
using Blocks = std::vector<std::vector<double>>;

// 1 for the smallest; equal figures share the mean of their ranks.
std::vector<double> ranks_of(std::span<const double> figures);

// Spearman's rank correlation, -1 to 1, of as many figures of each; NaN where all figures of one
// are equal or there are fewer than two.
double spearman(std::span<const double> first, std::span<const double> second);

// NaN of none.
double median(std::vector<double> values);

// Mean of the methods' ranks over the blocks.
std::vector<double> average_ranks(const Blocks& blocks);

// With fewer blocks the distributions below say little (they hold for many), and no p is given.
inline constexpr int kLeastFriedmanBlocks = 5;

// Friedman's test that all methods rank alike: his chi-square divided by the correction for ties
// (Conover, Practical Nonparametric Statistics, 5.8) with k - 1 degrees of freedom, and what Iman
// and Davenport (1980) make of it, which is less conservative: F with k - 1 and (k - 1)(n - 1).
// Demsar, 'Statistical comparisons of classifiers over multiple data sets', JMLR 7, 2006, 3.2.2.
struct FriedmanTest {
  int blocks = 0;
  int methods = 0;
  double chi_square = 0.0;
  double tie_correction = 1.0;  // chi_square * this is Friedman's without it; 0: nothing but ties
  double chi_square_p = 1.0;
  double f = 0.0;  // infinity: the same order in all blocks
  double f_p = 1.0;
};

// At least two methods and two blocks; nothing but ties gives p = 1.
FriedmanTest friedman_test(const Blocks& blocks);

// Bonferroni and Dunn: average ranks that differ from the control's by at least this differ
// significantly, whichever of the others is looked at (Demsar, 3.2.2).
double bonferroni_dunn_distance(int methods, int blocks, double alpha);

// Wilcoxon's signed-rank test of two methods, two-sided. Differences of 0 are ranked with the
// others, then left out (Pratt 1959): dropped before, they would make the rest weigh more. Up to
// kMostExactPairs differences other than 0, p is exact for these very ranks, ties and all; above,
// it is the normal distribution's, with the variance of these ranks and corrected for continuity.
struct WilcoxonTest {
  int wins = 0;  // blocks in which the first is better
  int losses = 0;
  int ties = 0;
  double rank_sum_wins = 0.0;
  double rank_sum_losses = 0.0;
  double median_difference = 0.0;  // first less second; NaN where failures leave none
  double p = 1.0;
  double least_p = 1.0;  // no outcome of as many blocks without ties could have a smaller one
  bool exact = true;
};
inline constexpr int kMostExactPairs = 50;

// Both of the same length.
WilcoxonTest wilcoxon_test(std::span<const double> first, std::span<const double> second);

// Holm's step-down adjustment for looking at several p at once, in the order given: significant
// where still below alpha.
std::vector<double> holm_adjusted(std::span<const double> p);

}  // namespace headland
