// When a search for a plan ends, and how it came along.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/cancel.h"

namespace headland {

// The search ends at the first of these. 0 is no limit, except of iterations. With `seconds` alone
// the result depends on the clock.
struct SearchStop {
  int iterations = 600;
  std::int64_t evaluations = 0;  // plans whose cost was looked up, in full or by a change
  double seconds = 0.0;
  int stagnation = 0;  // iterations without a better plan
};

// Throws InputError(source, "stop. ...") for less than one iteration and what is negative or NaN.
void check_stop(const SearchStop& stop, const std::string& source);

enum class StopReason {
  kIterations,
  kEvaluations,
  kTime,
  kStagnation,
  kNothingBetter,  // the plan is as good as any, or the planner builds but one
};
std::string_view stop_reason_name(StopReason reason);

// The best plan costs `cost` from here on.
struct ConvergencePoint {
  int iteration = 0;  // 0: what was begun with
  std::int64_t evaluations = 0;
  double cost = 0.0;
  double seconds = 0.0;  // by the clock, since the search began
};

struct PlanSearch {
  SearchStop stop;
  CancelAsked cancelled;
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
  int iteration = 0;  // the one that runs, counted from 1; 0 while the search is set up
  std::int64_t evaluations = 0;
  double best = std::numeric_limits<double>::infinity();
  double least = -std::numeric_limits<double>::infinity();  // no plan costs less
  std::vector<ConvergencePoint> convergence;
  std::optional<StopReason> stopped_by;
};

// Whether another iteration is to run; begins it. Throws Cancelled.
bool next_iteration(PlanSearch& search);

// Whether the running iteration is to be finished; once it says no it stays so. Throws Cancelled.
bool goes_on(PlanSearch& search);

// The share [0, 1] of the search that was over when its running iteration began, by whichever limit
// is nearest: what planners that change their ways towards the end go by. Stagnation is no limit
// that comes nearer.
double share_over(const PlanSearch& search);

// Changes of cost nearer to 0 than this are none: sums are rounded.
inline constexpr double kNoChange = 1e-9;

// Says that a plan of this cost is known. True when it is the best so far by more than rounding.
bool note_cost(PlanSearch& search, double cost);

}  // namespace headland
