// Independent work on several threads, with progress and an early end.
#pragma once

#include <cstddef>
#include <functional>

#include "planner/cancel.h"

namespace headland {

struct ParallelOptions {
  int jobs = 1;  // threads
  // Called with the runs that are done, by one thread at a time.
  std::function<void(int done, int all)> progress;
  // Asked several times a second; true ends the work: what is done is kept.
  CancelAsked cancelled;
};

// Calls `work` with 0 .. count - 1, begun in this order, on options.jobs threads; it says whether
// it came to its end. No work is begun after the options ask for an early end, or after one threw,
// which is thrown on when those begun have ended.
void run_in_parallel(std::size_t count, const ParallelOptions& options,
                     const std::function<bool(std::size_t, const CancelAsked&)>& work);

}  // namespace headland
