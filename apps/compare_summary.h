// What a comparison came to, for people.
#pragma once

#include <string>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/comparison_ranks.h"

namespace headland {

// A table for each map, then ranks, then tests with what they cannot say.
std::string comparison_summary(const Comparison& comparison, const std::vector<ComparedRun>& runs,
                               const ComparisonRanks& ranks);

}  // namespace headland
