// A run's time series as a report shows them: few enough rows, no extreme lost.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "sim/run_record.h"

namespace headland {

// However long the run: what a page can draw and carry.
inline constexpr std::size_t kMostReportBuckets = 10000;

// Index of the first sample of every bucket: at most `most` + 1 buckets, the last sample in one of
// its own. Each holds an equal share of the samples and of all turning, both counting half, so that
// turns are as smooth as straights when there are more samples than buckets. Empty for no samples.
std::vector<std::size_t> bucket_starts(std::span<const RunSample> samples, std::size_t most);

// Smallest and largest value in every bucket; values that are not finite count for nothing, and a
// bucket of them alone is NaN.
struct Envelope {
  std::vector<float> low;
  std::vector<float> high;
};
Envelope envelope_of(std::span<const double> values, std::span<const std::size_t> starts);

// {"low", "high"}, packed floats each; without "high" where it is the same.
nlohmann::ordered_json envelope_json(const Envelope& envelope);

// {"count", "poses": {column: packed floats of each bucket's first sample}, "envelopes": {column:
// low, high}}. Columns are named as in run.csv; `wh_per_m` stands beside them, one value a sample,
// unless it is empty.
nlohmann::ordered_json series_json(const std::vector<RunSample>& samples,
                                   std::span<const double> wh_per_m);

// The driven footprints, thinned to `spacing_m` of travel (more where that is more than
// kMostReportBuckets rows; the ends of strips stay): left_x_m ... time_s as floats, and
// starts_strip.
nlohmann::ordered_json footprints_json(const std::vector<FootprintSample>& footprints);

// Share of the distance driven at each tracking error, at work and otherwise: {"edges_m",
// "working", "turning"}, shares in percent of all that distance. Errors beyond the outermost bins
// are in them.
nlohmann::ordered_json tracking_histogram_json(const std::vector<RunSample>& samples);

}  // namespace headland
