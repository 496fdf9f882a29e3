// How long planning takes and how much memory, over the number of swaths.
#pragma once

#include <string>
#include <vector>

#include "planner/plan.h"

namespace headland::bench {

struct TimesAsked {
  std::vector<int> swaths = {100, 300, 1000, 2000, 5000, 10000};  // of made-up strips
  std::vector<std::string> files;                                 // and these fields
  Parameters parameters;                                          // for them
  bool json = false;
};

// Prints seconds of the processor for planning and for making drivable, lengths of the paths and
// the peak of memory: made-up strips for the transplanter, fields for the utility tractor.
void print_planning_times(const TimesAsked& asked);

}  // namespace headland::bench
