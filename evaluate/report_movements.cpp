#include "evaluate/report_movements.h"

#include <algorithm>
#include <cmath>

#include "evaluate/geojson.h"

namespace headland {

std::vector<Movement> movements_of(const Path& path, const std::vector<SegmentRecord>& records) {
  std::vector<Movement> movements;
  double error_sum_m3 = 0.0;
  int manoeuvre = -1;
  for (const SegmentRecord& record : records) {
    const PathSegment& segment = path.segments[static_cast<std::size_t>(record.segment)];
    if (movements.empty() || segment.manoeuvre != manoeuvre) {
      manoeuvre = segment.manoeuvre;
      error_sum_m3 = 0.0;
      movements.push_back({.kind = segment.kind, .start_time_s = record.start_time_s});
    }
    Movement& movement = movements.back();
    movement.duration_s += record.duration_s;
    movement.distance_m += record.distance_m;
    movement.energy_wh += record.energy.battery_j / kJoulePerWattHour;
    movement.peak_power_w = std::max(movement.peak_power_w, record.peak_power_w);
    movement.scuffed_m2 += record.scuffed_m2;
    if (segment.gear == Gear::kReverse) ++movement.reverses;
    error_sum_m3 += record.cross_track_sum_m3;
    if (movement.distance_m > 0.0) {
      movement.track_rms_m = std::sqrt(error_sum_m3 / movement.distance_m);
    }
  }
  return movements;
}

nlohmann::ordered_json movements_json(const Path& path, const std::vector<SegmentRecord>& records) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Movement& movement : movements_of(path, records)) {
    json.push_back({{"kind", path_kind_name(movement.kind)},
                    {"start_time_s", rounded(movement.start_time_s, 2)},
                    {"duration_s", rounded(movement.duration_s, 2)},
                    {"distance_m", rounded(movement.distance_m, 2)},
                    {"energy_wh", rounded(movement.energy_wh, 3)},
                    {"peak_power_w", rounded(movement.peak_power_w, 0)},
                    {"scuffed_m2", rounded(movement.scuffed_m2, 2)},
                    {"track_rms_m", rounded(movement.track_rms_m, 4)},
                    {"reverses", movement.reverses}});
  }
  return json;
}

}  // namespace headland
