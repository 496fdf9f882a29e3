#include "evaluate/parallel_runs.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <mutex>

namespace headland {

void run_in_parallel(std::size_t count, const ParallelOptions& options,
                     const std::function<bool(std::size_t, const CancelAsked&)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  int done = 0;
  std::atomic<bool> failed = false;
  const CancelAsked cancelled = [&] {
    return failed || (options.cancelled && options.cancelled());
  };
  // More threads than processors only when asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.jobs));
  tbb::task_arena arena(options.jobs);
  arena.execute([&] {
    tbb::parallel_for(0, options.jobs, [&](int) {
      for (std::size_t i = next++; i < count && !cancelled(); i = next++) {
        bool ended = false;
        try {
          ended = work(i, cancelled);
        } catch (...) {
          failed = true;
          throw;
        }
        const std::scoped_lock lock(mutex);
        done += ended ? 1 : 0;
        if (options.progress) options.progress(done, static_cast<int>(count));
      }
    });
  });
}

}  // namespace headland
