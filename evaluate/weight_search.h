// Searching weights by what comes of planning with them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace headland {

// Three weights of a fitness, of which only the ratios matter: their sum is 1.
using WeightShares = std::array<double, 3>;

// To be made small; may throw, which ends the search.
using WeightLoss = std::function<double(const WeightShares&)>;

struct WeightSearch {
  WeightShares weights{};  // of the least loss
  double loss = 0.0;
  int evaluations = 0;
  std::vector<double> least_so_far;  // after each evaluation
};

// CMA-ES (Hansen 2006, as in pagmo) on the logarithms of the second and third weight over the
// first, within factors of kMostRatio, in generations of kSearchPopulation. The first generation
// has the weights of `starts` in it. Calls `loss` one at a time, at most `evaluations` times, of
// which there are at least two generations, or only with `starts` when there are fewer. Weights are
// taken to three digits: what planners make of two that differ less is the same run. Draws come
// from `seed` alone.
WeightSearch search_weights(const WeightLoss& loss, const std::vector<WeightShares>& starts,
                            int evaluations, std::uint64_t seed);
inline constexpr double kMostRatio = 100.0;
inline constexpr int kSearchPopulation = 6;

}  // namespace headland
