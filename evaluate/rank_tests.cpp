#include "evaluate/rank_tests.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/statistics/bivariate_statistics.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace headland {
namespace {

double cubed_less_itself(double count) { return count * count * count - count; }

// Sum of t^3 - t over the groups of t equal figures.
double tie_term(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  double sum = 0.0;
  for (auto first = figures.begin(); first != figures.end();) {
    const auto last = std::find_if(first, figures.end(), [&](double f) { return f != *first; });
    sum += cubed_less_itself(static_cast<double>(last - first));
    first = last;
  }
  return sum;
}

// Differences in whole steps of `step`, so that equal ones of figures that are sums of weights tie
// whatever their rounding. Neither is NaN; two failures are alike.
double difference(double first, double second, double step) {
  if (first == second) return 0.0;
  const double apart = first - second;
  return std::isfinite(apart) ? step * std::round(apart / step) : apart;
}

// What the figures' twelfth digit stands for.
double rounding_step(std::span<const double> first, std::span<const double> second) {
  double largest = 0.0;
  for (const std::span<const double> figures : {first, second}) {
    for (const double figure : figures) {
      if (std::isfinite(figure)) largest = std::max(largest, std::abs(figure));
    }
  }
  constexpr double kDigits = 11.0;
  return largest > 0.0 ? std::pow(10.0, std::floor(std::log10(largest)) - kDigits) : 1.0;
}

// Two-sided p of a rank sum as small as `smaller` when each of the ranks belongs to either side
// with equal probability. Counted in halves of a rank, in which shared ranks are whole.
double exact_p(const std::vector<double>& ranks, double smaller) {
  const auto halves = [](double rank) { return static_cast<std::size_t>(std::lround(2.0 * rank)); };
  std::vector<double> chance{1.0};  // by rank sum
  for (const double rank : ranks) {
    const std::size_t step = halves(rank);
    std::vector<double> next(chance.size() + step, 0.0);
    for (std::size_t sum = 0; sum < chance.size(); ++sum) {
      next[sum] += 0.5 * chance[sum];
      next[sum + step] += 0.5 * chance[sum];
    }
    chance = std::move(next);
  }
  double tail = 0.0;
  for (std::size_t sum = 0; sum <= halves(smaller); ++sum) tail += chance[sum];
  return std::min(1.0, 2.0 * tail);
}

double normal_p(const std::vector<double>& ranks, double smaller) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double rank : ranks) {
    sum += rank;
    squares += rank * rank;
  }
  constexpr double kContinuity = 0.5;
  const double z = (smaller - 0.5 * sum + kContinuity) / std::sqrt(0.25 * squares);
  return std::min(1.0, 2.0 * boost::math::cdf(boost::math::normal(), z));
}

}  // namespace

std::vector<double> ranks_of(std::span<const double> figures) {
  std::vector<std::size_t> order(figures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return figures[a] < figures[b]; });
  std::vector<double> ranks(figures.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && figures[order[end]] == figures[order[first]]) ++end;
    const double shared = 0.5 * static_cast<double>(first + 1 + end);
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = shared;
    first = end;
  }
  return ranks;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  if (values.size() % 2 == 1) return values[half];
  return 0.5 * (values[half - 1] + values[half]);
}

double spearman(std::span<const double> first, std::span<const double> second) {
  const auto says_nothing = [](std::span<const double> figures) {
    return std::ranges::count(figures, figures.front()) == std::ssize(figures);
  };
  if (first.empty() || says_nothing(first) || says_nothing(second)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return boost::math::statistics::correlation_coefficient(ranks_of(first), ranks_of(second));
}

std::vector<double> average_ranks(const Blocks& blocks) {
  std::vector<double> average(blocks.empty() ? 0 : blocks.front().size(), 0.0);
  for (const std::vector<double>& block : blocks) {
    const std::vector<double> ranks = ranks_of(block);
    for (std::size_t j = 0; j < average.size(); ++j) average[j] += ranks[j];
  }
  // Ranks are whole or halves: their sums are exact, and ties stay ties.
  for (double& rank : average) rank /= static_cast<double>(blocks.size());
  return average;
}

FriedmanTest friedman_test(const Blocks& blocks) {
  FriedmanTest test;
  test.blocks = static_cast<int>(blocks.size());
  test.methods = static_cast<int>(blocks.front().size());
  const double n = test.blocks;
  const double k = test.methods;
  double squares = 0.0;
  for (const double rank : average_ranks(blocks)) {
    squares += (rank - 0.5 * (k + 1.0)) * (rank - 0.5 * (k + 1.0));
  }
  double ties = 0.0;
  for (const std::vector<double>& block : blocks) ties += tie_term(block);
  test.tie_correction = 1.0 - ties / (n * cubed_less_itself(k));
  if (!(test.tie_correction > 0.0)) return test;
  test.chi_square = 12.0 * n / (k * (k + 1.0)) * squares / test.tie_correction;
  test.chi_square_p =
      boost::math::cdf(boost::math::complement(boost::math::chi_squared(k - 1.0), test.chi_square));
  // Of the same order in all blocks nothing but rounding is left.
  const double left = n * (k - 1.0) - test.chi_square;
  constexpr double kRounding = 1e-9;
  if (left < kRounding * n * k) {
    test.f = std::numeric_limits<double>::infinity();
    test.f_p = 0.0;
    return test;
  }
  test.f = (n - 1.0) * test.chi_square / left;
  test.f_p = boost::math::cdf(
      boost::math::complement(boost::math::fisher_f(k - 1.0, (k - 1.0) * (n - 1.0)), test.f));
  return test;
}

double bonferroni_dunn_distance(int methods, int blocks, double alpha) {
  const double k = methods;
  const double z = boost::math::quantile(
      boost::math::complement(boost::math::normal(), 0.5 * alpha / (k - 1.0)));
  return z * std::sqrt(k * (k + 1.0) / (6.0 * blocks));
}

WilcoxonTest wilcoxon_test(std::span<const double> first, std::span<const double> second) {
  WilcoxonTest test;
  std::vector<double> differences;
  std::vector<double> sizes;
  const double step = rounding_step(first, second);
  for (std::size_t i = 0; i < first.size(); ++i) {
    differences.push_back(difference(first[i], second[i], step));
    sizes.push_back(std::abs(differences.back()));
  }
  const std::vector<double> ranks = ranks_of(sizes);
  std::vector<double> left;  // ranks of differences other than 0
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (differences[i] == 0.0) {
      ++test.ties;
      continue;
    }
    left.push_back(ranks[i]);
    ++(differences[i] < 0.0 ? test.wins : test.losses);
    (differences[i] < 0.0 ? test.rank_sum_wins : test.rank_sum_losses) += ranks[i];
  }
  test.median_difference = median(differences);
  test.least_p = std::min(1.0, std::ldexp(2.0, -static_cast<int>(first.size())));
  if (left.empty()) return test;
  const double smaller = std::min(test.rank_sum_wins, test.rank_sum_losses);
  test.exact = left.size() <= static_cast<std::size_t>(kMostExactPairs);
  test.p = test.exact ? exact_p(left, smaller) : normal_p(left, smaller);
  return test;
}

std::vector<double> holm_adjusted(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, static_cast<double>(p.size() - i) * p[order[i]]);
    adjusted[order[i]] = std::min(1.0, largest);
  }
  return adjusted;
}

}  // namespace headland
