#include "evaluate/weight_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <string>

namespace headland {
namespace {

const double kMostLog = std::log(kMostRatio);
constexpr double kLeastShare = 1e-6;  // of a weight, to have a logarithm

double to_three_digits(double value) { return std::stod(fmt::format("{:.3g}", value)); }

WeightShares shares_of(const pagmo::vector_double& logs) {
  const double second = std::exp(logs[0]);
  const double third = std::exp(logs[1]);
  const double sum = 1.0 + second + third;
  return {to_three_digits(1.0 / sum), to_three_digits(second / sum), to_three_digits(third / sum)};
}

pagmo::vector_double logs_of(const WeightShares& weights) {
  const auto log_ratio = [&](double weight) {
    const double ratio = std::max(weight, kLeastShare) / std::max(weights[0], kLeastShare);
    return std::clamp(std::log(ratio), -kMostLog, kMostLog);
  };
  return {log_ratio(weights[1]), log_ratio(weights[2])};
}

// What copies of pagmo's problem share.
struct Searched {
  const WeightLoss& loss;
  WeightSearch result;
  std::map<WeightShares, double> known;
};

struct Problem {
  Searched* searched = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& logs) const {
    const WeightShares weights = shares_of(logs);
    const auto [entry, is_new] = searched->known.try_emplace(weights, 0.0);
    if (is_new) entry->second = searched->loss(weights);
    WeightSearch& result = searched->result;
    ++result.evaluations;
    if (result.least_so_far.empty() || entry->second < result.loss) {
      result.loss = entry->second;
      result.weights = weights;
    }
    result.least_so_far.push_back(result.loss);
    return {entry->second};
  }
  static std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() {
    return {{-kMostLog, -kMostLog}, {kMostLog, kMostLog}};
  }
};

}  // namespace

WeightSearch search_weights(const WeightLoss& loss, const std::vector<WeightShares>& starts,
                            int evaluations, std::uint64_t seed) {
  Searched searched{loss, {}, {}};
  const auto draws = static_cast<unsigned>(seed);
  pagmo::population population{pagmo::problem{Problem{&searched}}, 0U, draws};
  const auto room = [&] { return searched.result.evaluations < evaluations; };
  for (const WeightShares& start : starts) {
    if (room()) population.push_back(logs_of(start));
  }
  const int generations = evaluations / kSearchPopulation - 1;
  if (generations < 1) return searched.result;
  while (population.size() < static_cast<std::size_t>(kSearchPopulation)) {
    population.push_back(population.random_decision_vector());
  }
  constexpr double kOwnDefault = -1.0;  // pagmo's, from the dimension
  constexpr double kFirstSpread = 0.3;  // of the bounds' width
  constexpr double kNever = 0.0;        // to end before the budget
  const pagmo::cmaes search(static_cast<unsigned>(generations), kOwnDefault, kOwnDefault,
                            kOwnDefault, kOwnDefault, kFirstSpread, kNever, kNever, false, true,
                            draws);
  search.evolve(population);
  return searched.result;
}

}  // namespace headland
