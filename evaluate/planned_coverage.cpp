#include "evaluate/planned_coverage.h"

#include <algorithm>
#include <vector>

#include "planner/arcs.h"

namespace headland {

CoverageFigures planned_coverage(const Field& field, const Vehicle& vehicle, const Path& path,
                                 double cell_m) {
  const double width_m = vehicle.implement.working_width_m;
  std::vector<FootprintSample> footprints;
  double along_m = 0.0;
  for (const PathSegment& segment : path.segments) {
    for (std::size_t i = 0; i < segment.points.size(); ++i) {
      const PathPoint& point = segment.points[i];
      if (i > 0) along_m += (point.p_W - segment.points[i - 1].p_W).norm();
      if (!segment.implement_down) continue;
      const Eigen::Vector2d middle_W =
          point.p_W + vehicle.implement.x_B_m * direction_of(point.heading_rad);
      const Eigen::Vector2d half_bar = 0.5 * width_m * left_of(point.heading_rad);
      footprints.push_back({middle_W + half_bar, middle_W - half_bar, 0.0, along_m, i == 0});
    }
  }
  return coverage_figures(
      measure_coverage(field, footprints, width_m, std::min(cell_m, 0.5 * width_m)));
}

}  // namespace headland
