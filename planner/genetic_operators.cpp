#include "planner/genetic_operators.h"

#include <numeric>

#include "planner/indexed.h"

namespace headland {

std::vector<int> crossed(const std::vector<int>& one, const std::vector<int>& other, int kept) {
  std::vector<int> child(one.begin(), one.begin() + kept);
  std::vector<char> taken(one.size(), 0);
  for (const int node : child) at(taken, node) = 1;
  for (const int node : other) {
    if (at(taken, node) == 0) child.push_back(node);
    at(taken, node) = 1;
  }
  // The end of a closed tour is its start too.
  if (child.size() < one.size()) child.push_back(one.back());
  return child;
}

void adapt_weights(const Three& parents_mean, const Three& counted, Three& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (counted[i] > parents_mean[i]) {
      weights[i] *= 1.0 + (counted[i] - parents_mean[i]) / counted[i];
    }
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
}

}  // namespace headland
