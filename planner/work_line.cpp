#include "planner/work_line.h"

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr int kWeightsEachSide = 4;  // of the triangular average

// A polyline by arc length that never ends: rings go round, others run on straight.
struct ArcLengthLine {
  std::vector<Vector2d> points;
  std::vector<double> at_m;  // arc length of each point
  bool ring = false;

  double length_m() const { return at_m.back(); }

  Vector2d point(double s_m) const {
    if (ring) s_m -= length_m() * std::floor(s_m / length_m());
    const auto after = std::upper_bound(at_m.begin() + 1, at_m.end() - 1, s_m);
    const auto i = static_cast<std::size_t>(after - at_m.begin());
    const double t = (s_m - at_m[i - 1]) / (at_m[i] - at_m[i - 1]);
    return points[i - 1] + t * (points[i] - points[i - 1]);
  }
};

ArcLengthLine arc_length_line(const std::vector<Vector2d>& points) {
  ArcLengthLine line;
  line.points = points;
  line.ring = points.size() > 3 && points.front() == points.back();
  line.at_m.push_back(0.0);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    line.at_m.push_back(line.at_m.back() + (line.points[i] - line.points[i - 1]).norm());
  }
  return line;
}

Vector2d smooth_point(const ArcLengthLine& line, double s_m) {
  Vector2d sum = Vector2d::Zero();
  double weights = 0.0;
  for (int k = -kWeightsEachSide; k <= kWeightsEachSide; ++k) {
    const double weight = kWeightsEachSide + 1 - std::abs(k);
    sum += weight * line.point(s_m + kSmoothing_m * k / (kWeightsEachSide + 1));
    weights += weight;
  }
  return sum / weights;
}

double heading_at(const ArcLengthLine& line, double s_m) {
  const double reach_m = 0.5 * kPathSpacing_m;
  const Vector2d along = smooth_point(line, s_m + reach_m) - smooth_point(line, s_m - reach_m);
  return std::atan2(along.y(), along.x());
}

PathPoint smooth_path_point(const ArcLengthLine& line, double s_m) {
  PathPoint point;
  point.p_W = smooth_point(line, s_m);
  point.heading_rad = heading_at(line, s_m);
  const double turned_rad =
      wrap_angle(heading_at(line, s_m + kPathSpacing_m) - heading_at(line, s_m - kPathSpacing_m));
  point.curvature_per_m = turned_rad / (2.0 * kPathSpacing_m);
  return point;
}

PathPoint axle_point(const Pass& pass, const ArcLengthLine& line, double s_m) {
  if (pass.points_W.size() > 2) return smooth_path_point(line, s_m);
  const Vector2d along = pass.points_W[1] - pass.points_W[0];
  return {line.point(s_m), std::atan2(along.y(), along.x()), 0.0};
}

}  // namespace

WorkLine work_line(const Pass& pass, double implement_x_B_m) {
  WorkLine work;
  work.kind = pass.kind == PassKind::kSwath ? PathKind::kSwath : PathKind::kHeadlandPass;
  work.optional = pass.optional;
  const ArcLengthLine line = arc_length_line(pass.points_W);
  const int steps = std::max(1, static_cast<int>(std::ceil(line.length_m() / kPathSpacing_m)));
  for (int i = 0; i <= steps; ++i) {
    const double s_m = line.length_m() * i / steps - implement_x_B_m;
    work.points.push_back(axle_point(pass, line, s_m));
  }
  return work;
}

double run_in_m(const Vehicle& vehicle) {
  return vehicle.implement.trailing ? 2.0 * std::abs(vehicle.implement.x_B_m) : 0.0;
}

void add_run_in(WorkLine& line, double length_m) {
  if (!(length_m > 0.0)) return;
  const PathPoint begin = line.points.front();
  const Vector2d edge = line.points[1].p_W - begin.p_W;
  line.run_in = static_cast<std::size_t>(std::floor(length_m / edge.norm()));
  std::vector<PathPoint> before;
  for (std::size_t i = line.run_in; i > 0; --i) {
    before.push_back({begin.p_W - static_cast<double>(i) * edge, begin.heading_rad, 0.0});
  }
  line.points.insert(line.points.begin(), before.begin(), before.end());
}

PathPoint work_line_begin(const Pass& pass, double implement_x_B_m) {
  return axle_point(pass, arc_length_line(pass.points_W), -implement_x_B_m);
}

PathPoint work_line_end(const Pass& pass, double implement_x_B_m) {
  const ArcLengthLine line = arc_length_line(pass.points_W);
  return axle_point(pass, line, line.length_m() - implement_x_B_m);
}

}  // namespace headland
