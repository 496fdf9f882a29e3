#include "planner/plan_search.h"

#include <fmt/format.h>

#include <algorithm>

#include "terrains/input_error.h"

namespace headland {
namespace {

// What ends a search at any time.
std::optional<StopReason> reason_to_stop_now(const PlanSearch& search) {
  const SearchStop& stop = search.stop;
  if (search.best <= search.least + kNoChange) return StopReason::kNothingBetter;
  if (stop.evaluations > 0 && search.evaluations >= stop.evaluations) {
    return StopReason::kEvaluations;
  }
  if (stop.seconds > 0.0) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - search.begun;
    if (gone.count() >= stop.seconds) return StopReason::kTime;
  }
  return std::nullopt;
}

// What ends it between iterations.
std::optional<StopReason> reason_not_to_iterate(const PlanSearch& search) {
  const SearchStop& stop = search.stop;
  if (search.iteration >= stop.iterations) return StopReason::kIterations;
  const int improved = search.convergence.empty() ? 0 : search.convergence.back().iteration;
  if (stop.stagnation > 0 && search.iteration - improved >= stop.stagnation) {
    return StopReason::kStagnation;
  }
  return std::nullopt;
}

}  // namespace

void check_stop(const SearchStop& stop, const std::string& source) {
  if (stop.iterations < 1) {
    throw InputError(source, "stop.iterations", fmt::format("{}", stop.iterations),
                     "a whole number from 1 up");
  }
  if (stop.evaluations < 0) {
    throw InputError(source, "stop.evaluations", fmt::format("{}", stop.evaluations),
                     "a whole number from 0 (no limit) up");
  }
  if (!(stop.seconds >= 0.0)) {
    throw InputError(source, "stop.seconds", fmt::format("{}", stop.seconds),
                     "a number from 0 (no limit) up");
  }
  if (stop.stagnation < 0) {
    throw InputError(source, "stop.stagnation", fmt::format("{}", stop.stagnation),
                     "a whole number from 0 (no limit) up");
  }
}

std::string_view stop_reason_name(StopReason reason) {
  switch (reason) {
    case StopReason::kIterations:
      return "iterations";
    case StopReason::kEvaluations:
      return "evaluations";
    case StopReason::kTime:
      return "time";
    case StopReason::kStagnation:
      return "stagnation";
    case StopReason::kNothingBetter:
      break;
  }
  return "nothing better";
}

bool goes_on(PlanSearch& search) {
  stop_if(search.cancelled);
  if (!search.stopped_by) search.stopped_by = reason_to_stop_now(search);
  return !search.stopped_by;
}

bool next_iteration(PlanSearch& search) {
  if (goes_on(search)) search.stopped_by = reason_not_to_iterate(search);
  if (!search.stopped_by) ++search.iteration;
  return !search.stopped_by;
}

double share_over(const PlanSearch& search) {
  const SearchStop& stop = search.stop;
  double share = std::max(0, search.iteration - 1) / static_cast<double>(stop.iterations);
  if (stop.evaluations > 0) {
    share = std::max(
        share, static_cast<double>(search.evaluations) / static_cast<double>(stop.evaluations));
  }
  if (stop.seconds > 0.0) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - search.begun;
    share = std::max(share, gone.count() / stop.seconds);
  }
  return std::min(1.0, share);
}

bool note_cost(PlanSearch& search, double cost) {
  if (!(cost < search.best - kNoChange)) return false;
  search.best = cost;
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - search.begun;
  const ConvergencePoint point{search.iteration, search.evaluations, cost, gone.count()};
  // One point an iteration: what it ended with.
  if (!search.convergence.empty() && search.convergence.back().iteration == point.iteration) {
    search.convergence.back() = point;
  } else {
    search.convergence.push_back(point);
  }
  return true;
}

}  // namespace headland
