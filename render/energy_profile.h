// Battery energy per metre along the driven track.
#pragma once

#include <span>
#include <vector>

#include "sim/run_record.h"

namespace headland {

// For every sample, the energy drawn at the battery's terminals within `window_m` of travel around
// it over that travel [Wh/m], negative where more was regenerated than used. The power between
// samples is taken as linear in time, the energy as linear in travel; at the ends of the track the
// window is what there is. Empty for fewer than two samples or no travel.
std::vector<double> energy_per_metre_wh(std::span<const RunSample> samples, double window_m);

struct EnergyFigures {
  double min_wh_per_m = 0.0;
  double median_wh_per_m = 0.0;
  double max_wh_per_m = 0.0;
  double scale_low_wh_per_m = 0.0;   // 2nd percentile, at most 0
  double scale_high_wh_per_m = 0.0;  // 98th percentile, more than the low one
};

// Over the samples, each weighted by the travel it stands for; values that are not finite (of a run
// that diverged) count for nothing. The profile must not be empty.
EnergyFigures energy_figures(std::span<const RunSample> samples, std::span<const double> profile);

}  // namespace headland
