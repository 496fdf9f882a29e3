#include "evaluate/path_check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrains/input_error.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

// Nearer than this the coordinates' rounding decides the direction.
constexpr double kDirectionStep_m = 1e-3;

// Where a complaint points to; both count from 0.
struct Place {
  const std::filesystem::path& file;
  std::size_t feature = 0;
  std::size_t point = 0;

  [[noreturn]] void refuse(const std::string& value, const std::string& allowed) const {
    // Tables count segments from 0.
    const std::string line = file.extension() == ".csv" ? fmt::format("segment {}", feature)
                                                        : fmt::format("feature {}", feature + 1);
    throw InputError(file.string(), fmt::format("{}, point {}", line, point + 1), value, allowed);
  }
};

double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

Eigen::AlignedBox2d neighbourhood(const Field& field) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : field.boundary) box.extend(p_W);
  return {box.min().array() - kMaxMargin_m, box.max().array() + kMaxMargin_m};
}

void check_point(const PathPoint& point, const Eigen::AlignedBox2d& near, const Field& field,
                 const Place& place) {
  if (!point.p_W.allFinite() || !near.contains(point.p_W)) {
    place.refuse(fmt::format("x {:.7g} m, y {:.7g} m", point.p_W.x(), point.p_W.y()),
                 fmt::format("a point within {} m of the field '{}'", kMaxMargin_m, field.name));
  }
  if (!(std::abs(point.heading_rad) <= kMaxHeading_rad)) {
    place.refuse(fmt::format("heading_rad {:g}", point.heading_rad),
                 fmt::format("a heading from {} to {} rad", -kMaxHeading_rad, kMaxHeading_rad));
  }
  if (!(std::abs(point.curvature_per_m) <= kMaxCurvature_per_m)) {
    place.refuse(
        fmt::format("curvature_per_m {:g}", point.curvature_per_m),
        fmt::format("a curvature from {} to {} per m", -kMaxCurvature_per_m, kMaxCurvature_per_m));
  }
}

// Turns along a segment so far [rad]: of the headings, and between what the lesser and the greater
// curvature at each step's ends make of the way.
struct Turned {
  double by_headings_rad = 0.0;
  double least_rad = 0.0;
  double most_rad = 0.0;
  double way_m = 0.0;
};

// Two neighbours, the second of which is at `place`. Errors too small to show in one step add up in
// `turned`.
void check_step(const PathPoint& from, const PathPoint& to, Gear gear, const Place& place,
                Turned& turned) {
  const Eigen::Vector2d step = to.p_W - from.p_W;
  if (step.norm() < kDirectionStep_m) return;
  const bool reverse = gear == Gear::kReverse;
  const double turn_rad = wrapped_rad(to.heading_rad - from.heading_rad);
  const double along_rad = std::atan2(step.y(), step.x()) + (reverse ? std::numbers::pi : 0.0);
  const double astray_rad = wrapped_rad(from.heading_rad + 0.5 * turn_rad - along_rad);
  if (std::abs(astray_rad) > kHeadingTolerance_rad) {
    place.refuse(fmt::format("heading_rad {:g}", to.heading_rad),
                 fmt::format("the line from the point before runs at {:.3g} rad: headings and "
                             "points must agree within {} rad",
                             wrapped_rad(along_rad), kHeadingTolerance_rad));
  }
  const double travel_m = reverse ? -step.norm() : step.norm();
  const auto [least_rad, most_rad] =
      std::minmax({travel_m * from.curvature_per_m, travel_m * to.curvature_per_m});
  turned.by_headings_rad += turn_rad;
  turned.least_rad += least_rad;
  turned.most_rad += most_rad;
  turned.way_m += step.norm();
  if (turned.by_headings_rad < turned.least_rad - kHeadingTolerance_rad ||
      turned.by_headings_rad > turned.most_rad + kHeadingTolerance_rad) {
    place.refuse(fmt::format("curvature_per_m {:g}", to.curvature_per_m),
                 fmt::format("the headings turn by {:.3g} rad over {:.3g} m: curvatures and "
                             "headings must agree within {} rad",
                             turned.by_headings_rad, turned.way_m, kHeadingTolerance_rad));
  }
}

void check_segment(const PathSegment& segment, const Eigen::AlignedBox2d& near, const Field& field,
                   Place place) {
  double longest_m = 0.0;
  Turned turned;
  for (std::size_t i = 0; i < segment.points.size(); ++i) {
    place.point = i;
    check_point(segment.points[i], near, field, place);
    if (i > 0) check_step(segment.points[i - 1], segment.points[i], segment.gear, place, turned);
    longest_m = std::max(longest_m, (segment.points[i].p_W - segment.points[0].p_W).norm());
  }
  if (longest_m == 0.0) {
    place.point = 0;
    place.refuse("", "all points of the line are the same; at least two different ones are needed");
  }
}

}  // namespace

void check_path(const Path& path, const Field& field, const std::filesystem::path& file) {
  const Eigen::AlignedBox2d near = neighbourhood(field);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    check_segment(path.segments[i], near, field, {file, i, 0});
    if (i == 0) continue;
    const double gap_m =
        (path.segments[i].points.front().p_W - path.segments[i - 1].points.back().p_W).norm();
    if (gap_m > kMaxSegmentGap_m) {
      Place{file, i, 0}.refuse(fmt::format("{:.3g} m away", gap_m),
                               "a line begins where the one before it ends");
    }
  }
}

}  // namespace headland
