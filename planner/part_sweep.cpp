#include "planner/part_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/arcs.h"
#include "planner/decomposition.h"
#include "planner/indexed.h"
#include "planner/segment.h"

namespace headland {
namespace {

constexpr double kStraightCorner_m = 1e-5;
// Ground that reaches less than this beyond the last line needs none of its own [m].
constexpr double kSpareHeight_m = 1e-3;

struct Levels {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -std::numeric_limits<double>::infinity();
  double height_m() const { return highest_m - lowest_m; }
};

Levels levels_across(const Ring& outline, double direction_rad) {
  const Eigen::Vector2d across = left_of(direction_rad);
  Levels levels;
  for (const Eigen::Vector2d& p_W : outline) {
    levels.lowest_m = std::min(levels.lowest_m, across.dot(p_W));
    levels.highest_m = std::max(levels.highest_m, across.dot(p_W));
  }
  return levels;
}

// Where the slice at a level first enters and last leaves the outline.
SweepLine slice_at(const Ring& outline, double direction_rad, double level_m) {
  const Eigen::Vector2d along = direction_of(direction_rad);
  const Eigen::Vector2d across = left_of(direction_rad);
  double from_m = std::numeric_limits<double>::infinity();
  double to_m = -from_m;
  Eigen::Vector2d a_W = outline.back();
  for (const Eigen::Vector2d& b_W : outline) {
    const double a_m = across.dot(a_W) - level_m;
    const double b_m = across.dot(b_W) - level_m;
    if ((a_m > 0.0) != (b_m > 0.0)) {
      const double at_m = along.dot(a_W + a_m / (a_m - b_m) * (b_W - a_W));
      from_m = std::min(from_m, at_m);
      to_m = std::max(to_m, at_m);
    }
    a_W = b_W;
  }
  return {from_m * along + level_m * across, to_m * along + level_m * across};
}

// Whether an edge in the direction lies along the left side of the outline rather than the right.
bool lies_left(const Ring& outline, double direction_rad, const Levels& levels) {
  const Eigen::Vector2d along = direction_of(direction_rad);
  const Eigen::Vector2d across = left_of(direction_rad);
  double longest_m = 0.0;
  bool left = false;
  Eigen::Vector2d a_W = outline.back();
  for (const Eigen::Vector2d& b_W : outline) {
    const Eigen::Vector2d edge = b_W - a_W;
    const bool parallel = std::abs(across.dot(edge)) < kConvex_m;
    if (parallel && std::abs(along.dot(edge)) > longest_m) {
      longest_m = std::abs(along.dot(edge));
      left = 2.0 * across.dot(a_W) > levels.lowest_m + levels.highest_m;
    }
    a_W = b_W;
  }
  return left;
}

}  // namespace

Ring corners_of(const Ring& ring) {
  Ring corners = ring;
  for (std::size_t i = 0; i < corners.size() && corners.size() > 3;) {
    const Eigen::Vector2d& before_W = corners[(i + corners.size() - 1) % corners.size()];
    const Eigen::Vector2d& after_W = corners[(i + 1) % corners.size()];
    if (distance_to_segment(corners[i], before_W, after_W) < kStraightCorner_m) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return corners;
}

double longest_edge_rad(const Ring& outline) {
  const Ring corners = corners_of(outline);
  Eigen::Vector2d longest = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i];
    if (edge.norm() > longest.norm() + kStraightCorner_m) longest = edge;
  }
  return line_direction_rad(longest);
}

bool is_swept_whole(const Ring& outline, double direction_rad) {
  const Eigen::Vector2d across = left_of(direction_rad);
  const int count = static_cast<int>(outline.size());
  const auto level_m = [&](int i) { return across.dot(at(outline, i % count)); };
  int lowest = 0;
  for (int i = 1; i < count; ++i) {
    if (level_m(i) < level_m(lowest)) lowest = i;
  }
  // Up once and down once: from the lowest place on, no fall before the highest is reached and no
  // rise after it.
  const double top_m = levels_across(outline, direction_rad).highest_m;
  bool rises = true;
  double extreme_m = level_m(lowest);
  for (int i = lowest; i <= lowest + count; ++i) {
    const double now_m = level_m(i);
    if (rises && now_m < extreme_m - kConvex_m) {
      if (extreme_m < top_m - kConvex_m) return false;
      rises = false;
      extreme_m = now_m;
    }
    if (!rises && now_m > extreme_m + kConvex_m) return false;
    extreme_m = rises ? std::max(extreme_m, now_m) : std::min(extreme_m, now_m);
  }
  return true;
}

int sweep_line_count(const Ring& outline, double direction_rad, double width_m) {
  const double height_m = levels_across(outline, direction_rad).height_m();
  return std::max(1, static_cast<int>(std::ceil((height_m - kSpareHeight_m) / width_m)));
}

PartSweep sweep_of(const Ring& outline, double direction_rad, double width_m) {
  const Levels levels = levels_across(outline, direction_rad);
  const int count = sweep_line_count(outline, direction_rad, width_m);
  PartSweep sweep;
  sweep.direction_rad = direction_rad;
  for (int line = 0; line < count; ++line) {
    const double level_m = levels.lowest_m + (line + 0.5) * levels.height_m() / count;
    sweep.lines.push_back(slice_at(outline, direction_rad, level_m));
  }
  if (lies_left(outline, direction_rad, levels)) std::ranges::reverse(sweep.lines);
  return sweep;
}

Polyline points_of(const PartSweep& sweep, SweepWay way) {
  Polyline points;
  const std::size_t count = sweep.lines.size();
  for (std::size_t i = 0; i < count; ++i) {
    const SweepLine& line = sweep.lines[way.from_last_line ? count - 1 - i : i];
    const bool to_first =
        points.empty() ? way.from_far_end
                       : (line.to_W - points.back()).norm() < (line.from_W - points.back()).norm();
    points.push_back(to_first ? line.to_W : line.from_W);
    points.push_back(to_first ? line.from_W : line.to_W);
  }
  return points;
}

}  // namespace headland
