// A run as it was at a moment.
#pragma once

#include <optional>

#include "sim/run_record.h"

namespace headland {

// Between the samples around it; the first or last one before the start and after the end. Samples
// without a finite place (of a run that diverged) count for nothing; none when there are no others.
std::optional<RunSample> sample_at(const RunRecord& run, double time_s);

// The record up to then: samples, the last of them at that moment, footprints, distance, time and
// charge. Segments, energy and peaks stay those of the whole run.
RunRecord run_until(const RunRecord& run, double time_s);

}  // namespace headland
