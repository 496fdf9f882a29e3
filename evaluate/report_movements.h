// What every movement of a drive cost, one by one.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {

// The segments of one manoeuvre together, in the order driven.
struct Movement {
  PathKind kind = PathKind::kSwath;
  double start_time_s = 0.0;
  double duration_s = 0.0;
  double distance_m = 0.0;
  double energy_wh = 0.0;  // from the battery's cells
  double peak_power_w = 0.0;
  double scuffed_m2 = 0.0;
  double track_rms_m = 0.0;
  int reverses = 0;  // segments driven backwards
};

// Records must point into the path. NaN (of a run that diverged) stays.
std::vector<Movement> movements_of(const Path& path, const std::vector<SegmentRecord>& records);

nlohmann::ordered_json movements_json(const Path& path, const std::vector<SegmentRecord>& records);

}  // namespace headland
