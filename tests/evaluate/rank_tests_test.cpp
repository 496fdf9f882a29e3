#include "evaluate/rank_tests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "planner/seeded_random.h"

namespace headland {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

constexpr double kRounded3 = 0.0005;  // of what is printed with three decimals
constexpr double kRounded2 = 0.005;
constexpr double kExact = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Demsar 2006, Table 6: area under the curve of C4.5, C4.5+m, C4.5+cf, C4.5+m+cf on 14 data sets.
// More is better there. Of rows that are tied to three digits the table prints the ranks 2 and 3 in
// one ('voting'), of which a digit more decides; it is added here.
Blocks demsar_table_6() {
  Blocks blocks = {{.763, .768, .771, .798},     {.599, .591, .590, .569}, {.954, .971, .968, .967},
                   {.628, .661, .654, .657},     {.882, .888, .886, .898}, {.936, .931, .916, .931},
                   {.661, .668, .609, .685},     {.583, .583, .563, .625}, {.775, .838, .866, .875},
                   {1.000, 1.000, 1.000, 1.000}, {.940, .962, .965, .962}, {.619, .666, .614, .669},
                   {.972, .981, .9751, .975},    {.957, .978, .946, .970}};
  for (std::vector<double>& block : blocks) {
    for (double& figure : block) figure = -figure;
  }
  return blocks;
}

TEST(RankTests, AverageRanksAreThoseOfDemsar) {
  EXPECT_THAT(average_ranks(demsar_table_6()),
              Pointwise(DoubleNear(kRounded3), {3.143, 2.000, 2.893, 1.964}));
}

// 1 - 6 sum d^2 / (n (n^2 - 1)) without ties.
TEST(RankTests, SpearmanIsThatOfTheDifferences) {
  const std::vector<double> figures = {1.0, 20.0, 3.0, 400.0, 5.0};
  const std::vector<double> others = {2.0, 1.0, 3.0, 5.0, 4.0};
  EXPECT_NEAR(spearman(figures, others), 1.0 - 6.0 * (1.0 + 9.0 + 1.0 + 0.0 + 1.0) / 120.0, kExact);
  std::vector<double> against;
  for (const double figure : figures) against.push_back(-figure);
  EXPECT_NEAR(spearman(figures, figures), 1.0, kExact);
  EXPECT_NEAR(spearman(figures, against), -1.0, kExact);
  // Ranks 1.5, 1.5, 3 and 1, 2, 3: 1.5 / sqrt(1.5 * 2).
  EXPECT_NEAR(spearman(std::vector{1.0, 1.0, 7.0}, std::vector{1.0, 2.0, 3.0}), std::sqrt(0.75),
              kExact);
  EXPECT_TRUE(std::isnan(spearman(std::vector{1.0, 1.0, 1.0}, std::vector{1.0, 2.0, 3.0})));
  EXPECT_TRUE(std::isnan(spearman(std::vector{1.0}, std::vector{1.0})));
  EXPECT_TRUE(std::isnan(spearman({}, {})));
}

TEST(RankTests, MedianIsInTheMiddle) {
  EXPECT_EQ(median({5.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({5.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(RankTests, FriedmanIsThatOfDemsarButForHisTies) {
  const FriedmanTest test = friedman_test(demsar_table_6());
  // He leaves ties uncorrected: three pairs and one row of four.
  EXPECT_NEAR(test.tie_correction, 1.0 - (3 * 6 + 60) / (14.0 * 60.0), kExact);
  const double without = test.chi_square * test.tie_correction;
  EXPECT_NEAR(without, 9.28, kRounded2);
  EXPECT_NEAR(13.0 * without / (14.0 * 3.0 - without), 3.69, kRounded2);
  EXPECT_GT(test.chi_square, without);
  EXPECT_LT(test.f_p, 0.05);
}

// Hollander and Wolfe 1973, p. 140 (round first base; 22 players, 3 ways), with ties; chi-square
// and p as R's documentation of friedman.test prints them.
TEST(RankTests, FriedmanWithTiesIsThatOfHollanderAndWolfe) {
  const Blocks times = {
      {5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40},
      {5.90, 5.85, 5.70}, {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35},
      {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70}, {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45},
      {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40}, {5.45, 5.55, 5.50},
      {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
      {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}};
  const FriedmanTest test = friedman_test(times);
  EXPECT_NEAR(test.chi_square, 11.1429, 5e-5);
  EXPECT_NEAR(test.chi_square_p, 0.003805, 5e-7);
}

TEST(RankTests, BonferroniDunnDistancesAreThoseOfDemsar) {
  // 2.394 and 2.128 times sqrt(4 * 5 / (6 * 14)), his section 3.2.2.
  EXPECT_NEAR(bonferroni_dunn_distance(4, 14, 0.05), 2.394 * std::sqrt(20.0 / 84.0), kRounded3);
  EXPECT_NEAR(bonferroni_dunn_distance(4, 14, 0.10), 2.128 * std::sqrt(20.0 / 84.0), kRounded3);
}

// Darwin's fifteen pairs of crossed and self-fertilised maize (Fisher, The Design of Experiments,
// chapter III); the p of SciPy's documentation of wilcoxon: 24 and 0.041259765625.
TEST(RankTests, WilcoxonIsExactOnDarwinsMaize) {
  const std::vector<double> difference = {6,  8,   14, 16, 23, 24,  28, 29,
                                          41, -48, 49, 56, 60, -67, 75};
  const std::vector<double> none(difference.size(), 0.0);
  const WilcoxonTest test = wilcoxon_test(difference, none);
  EXPECT_EQ(test.wins, 2);
  EXPECT_EQ(test.losses, 13);
  EXPECT_EQ(test.rank_sum_wins, 24.0);
  EXPECT_EQ(test.rank_sum_losses, 96.0);
  EXPECT_NEAR(test.p, 0.041259765625, kExact);
  EXPECT_EQ(test.median_difference, 24.0);
  EXPECT_TRUE(test.exact);
  const WilcoxonTest turned = wilcoxon_test(none, difference);
  EXPECT_EQ(turned.p, test.p);
  EXPECT_EQ(turned.wins, test.losses);
}

// Hollander and Wolfe 1973, p. 29 (depression before and after), as in R's wilcox.test: V = 40,
// one-sided p = 0.01953.
TEST(RankTests, WilcoxonIsExactOnHollanderAndWolfe) {
  const std::vector<double> before = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> after = {.878, .647, .598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  const WilcoxonTest test = wilcoxon_test(before, after);
  EXPECT_EQ(test.rank_sum_losses, 40.0);
  EXPECT_NEAR(test.p, 2.0 * 0.01953, 1e-5);
}

// Demsar 2006, Table 2: differences with two of 0, whose ranks he gives to both sides in halves
// (R+ = 93, R- = 12); here nobody has them.
TEST(RankTests, WilcoxonRanksZerosAsDemsarDoesAndLeavesThemOut) {
  const std::vector<double> second = {.005, -.008, .017, .033, .006, -.005, .007,
                                      0.0,  .063,  0.0,  .022, .047, .009,  .021};
  const std::vector<double> first(second.size(), 0.0);
  const WilcoxonTest test = wilcoxon_test(first, second);
  EXPECT_EQ(test.ties, 2);
  EXPECT_EQ(test.rank_sum_wins + 1.5, 93.0);
  EXPECT_EQ(test.rank_sum_losses + 1.5, 12.0);
  EXPECT_LT(test.p, 0.05);  // as he concludes
}

// All sign patterns one by one.
TEST(RankTests, WilcoxonWithTiesIsWhatCountingGives) {
  const std::vector<double> first = {1, 1, 2, -2, 2, 5, 0, -7, 3};
  const std::vector<double> second(first.size(), 0.0);
  const WilcoxonTest test = wilcoxon_test(first, second);
  std::vector<double> sizes;
  for (const double d : first) sizes.push_back(std::abs(d));
  std::vector<double> ranks = ranks_of(sizes);
  ranks.erase(ranks.begin() + 6);  // of the 0
  int as_extreme = 0;
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    double sum = 0.0;
    for (unsigned i = 0; i < 8; ++i) sum += (pattern >> i & 1U) != 0U ? ranks[i] : 0.0;
    as_extreme += sum <= test.rank_sum_wins ? 1 : 0;
  }
  EXPECT_NEAR(test.p, 2.0 * as_extreme / 256.0, kExact);
}

TEST(RankTests, TheNormalApproximationGoesOnFromTheExactP) {
  SeededRandom random(5);
  std::vector<double> first;
  for (int i = 0; i < kMostExactPairs; ++i) first.push_back(draw_unit(random) - 0.4);
  std::vector<double> second(first.size(), 0.0);
  const WilcoxonTest exact = wilcoxon_test(first, second);
  first.push_back(0.001);  // the smallest of all: hardly any news
  second.push_back(0.0);
  const WilcoxonTest normal = wilcoxon_test(first, second);
  EXPECT_TRUE(exact.exact);
  EXPECT_FALSE(normal.exact);
  EXPECT_NEAR(normal.p, exact.p, 0.02);  // the approximation's own error at n = 50 is a tenth of it
}

TEST(RankTests, FailuresRankLastAndAreAlike) {
  EXPECT_THAT(ranks_of(std::array{3.0, kInfinity, 1.0, kInfinity}),
              ElementsAre(2.0, 3.5, 1.0, 3.5));
  const std::vector<double> fine = {1, 2, 3, 4, 5, 6};
  std::vector<double> failing(6, kInfinity);
  const WilcoxonTest test = wilcoxon_test(fine, failing);
  EXPECT_EQ(test.wins, 6);
  EXPECT_NEAR(test.p, 2.0 / 64.0, kExact);
  EXPECT_EQ(wilcoxon_test(failing, failing).ties, 6);
}

// Differences of 0.2 between sums of weights, each rounded differently: they share a rank.
TEST(RankTests, EqualDifferencesOfRoundedFiguresTie) {
  const std::vector<double> first = {4.4, 5.6, 9.3, 3.0};
  const std::vector<double> second = {4.2, 5.4, 9.1, 3.2};
  ASSERT_NE(first[0] - second[0], first[1] - second[1]);
  const WilcoxonTest test = wilcoxon_test(first, second);
  EXPECT_EQ(test.rank_sum_losses, 3 * 2.5);
  EXPECT_EQ(test.rank_sum_wins, 2.5);
  EXPECT_NEAR(test.median_difference, 0.2, 1e-11);
}

TEST(RankTests, TheSmallestPossiblePIsThatOfWinningEverywhere) {
  for (std::size_t n = 1; n <= 12; ++n) {
    const std::vector<double> first(n, 0.0);
    std::vector<double> second;
    for (std::size_t i = 0; i < n; ++i) second.push_back(static_cast<double>(i + 1));
    const WilcoxonTest test = wilcoxon_test(first, second);
    EXPECT_NEAR(test.p, test.least_p, kExact) << n;
  }
}

// Demsar 2006, 3.2.2: three of four methods against the control, z and p from the ranks above.
TEST(RankTests, HolmRejectsWhatDemsarsExampleRejects) {
  const std::vector<double> adjusted = holm_adjusted(std::array{0.016, 0.607, 0.019});
  EXPECT_THAT(adjusted, Pointwise(DoubleNear(kExact), {0.048, 0.607, 0.048}));
  EXPECT_THAT(holm_adjusted(std::array{0.01, 0.04, 0.03, 0.02}),
              Pointwise(DoubleNear(kExact), {0.04, 0.06, 0.06, 0.06}));
  EXPECT_THAT(holm_adjusted(std::array{0.9, 0.8}), ElementsAre(1.0, 1.0));
}

TEST(RankTests, EqualMethodsAreNotSignificant) {
  const Blocks tied(10, std::vector<double>(4, 7.0));
  const FriedmanTest test = friedman_test(tied);
  EXPECT_EQ(test.chi_square_p, 1.0);
  EXPECT_EQ(test.f_p, 1.0);
  EXPECT_EQ(wilcoxon_test(tied[0], tied[1]).p, 1.0);
}

// Under no difference p < 0.05 must come about one time in twenty; more often would be a test that
// finds what is not there. The bound is four standard deviations of 2000 trials above that.
TEST(RankTests, FindsDifferencesInNoiseNoMoreOftenThanItSays) {
  constexpr int kTrials = 2000;
  constexpr double kMost = 0.05 + 4.0 * 0.0049;
  SeededRandom random(11);
  for (const int blocks : {kLeastFriedmanBlocks, 8, 20}) {
    int friedman = 0;
    int wilcoxon = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      Blocks noise(static_cast<std::size_t>(blocks), std::vector<double>(4));
      std::vector<double> first;
      std::vector<double> second;
      for (std::vector<double>& block : noise) {
        for (double& figure : block) figure = draw_unit(random);
        first.push_back(block[0]);
        second.push_back(block[1]);
      }
      friedman += friedman_test(noise).f_p < 0.05 ? 1 : 0;
      wilcoxon += wilcoxon_test(first, second).p < 0.05 ? 1 : 0;
    }
    EXPECT_LT(friedman, kMost * kTrials) << blocks << " blocks";
    EXPECT_LT(wilcoxon, kMost * kTrials) << blocks << " blocks";
  }
}

TEST(RankTests, AClearlyWorseMethodIsFound) {
  SeededRandom random(3);
  Blocks blocks(8, std::vector<double>(3));
  for (std::vector<double>& block : blocks) {
    for (double& figure : block) figure = draw_unit(random);
    block[2] += 2.0;
  }
  EXPECT_LT(friedman_test(blocks).f_p, 0.05);
  const std::vector<double> ranks = average_ranks(blocks);
  EXPECT_EQ(ranks[2], 3.0);
  EXPECT_GT(ranks[2] - std::min(ranks[0], ranks[1]), bonferroni_dunn_distance(3, 8, 0.05));
  const Blocks same(8, {1.0, 2.0, 3.0});
  EXPECT_EQ(friedman_test(same).f, kInfinity);
  EXPECT_EQ(friedman_test(same).f_p, 0.0);
}

}  // namespace
}  // namespace headland
