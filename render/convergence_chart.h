// How the best plans of several planners came along on one map.
#pragma once

#include <string>
#include <vector>

#include "planner/plan_search.h"

namespace headland {

// The runs of one planner.
struct ConvergenceLine {
  std::string label;
  std::vector<std::vector<ConvergencePoint>> runs;  // each in the order of the search
  std::vector<int> iterations;                      // of each run in all
  std::vector<std::int64_t> evaluations;
};

// A script for chart_of (render/gnuplot.h) with two panels: the mean cost of the best plan so far
// over iterations and over evaluations, with a band of one standard deviation of the runs to either
// side. A mean begins where the last of its runs has its first plan; a run that has ended counts
// with what it ended with. A plan that took no search is a line all along. A line without runs
// is left out; at least one has some.
std::string convergence_chart_script(const std::string& title,
                                     const std::vector<ConvergenceLine>& lines);

inline constexpr int kConvergenceChartWidth_px = 1200;
inline constexpr int kConvergenceChartHeight_px = 520;

}  // namespace headland
