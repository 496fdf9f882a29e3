// Independent work on several threads, with progress and an early end.
#pragma once

#include <cstddef>
#include <functional>

#include "evaluate/comparison.h"

namespace headland {

// Calls `work` with 0 .. count - 1, begun in this order, on options.jobs threads; it says whether
// it came to its end. No work is begun after the options ask for an early end.
void run_in_parallel(std::size_t count, const ComparisonOptions& options,
                     const std::function<bool(std::size_t, const CancelAsked&)>& work);

}  // namespace headland
