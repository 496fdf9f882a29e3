// How children of chromosomes come about. Wu et al. 2023 (10.20944/preprints202305.1306.v1), 2.2.
#pragma once

#include <array>
#include <vector>

namespace headland {

// Repeats, turns and U-turns; also their weights.
using Three = std::array<double, 3>;

// 2.2.4: the first `kept` nodes of `one`, then what is missing as it follows in `other`. Both are
// orders of the nodes 0 up to their number less one; closed tours have their first node once more
// at the end.
std::vector<int> crossed(const std::vector<int>& one, const std::vector<int>& other, int kept);

// Eqs (2) to (10): the weight of what is counted more than the mean of the parents grows by the
// share it is above; then all are scaled to sum to 1. `weights` have a positive sum.
void adapt_weights(const Three& parents_mean, const Three& counted, Three& weights);

}  // namespace headland
