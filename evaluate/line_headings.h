// How a vehicle that follows a line of points is headed between and at them.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace headland {

// A corner stands for a curve over half of both its edges, chords of an arc for that arc, but for
// none wider than rounds it within this.
inline constexpr double kCornerTolerance_m = 0.1;
// A corner that turns by no more than this may be a curve's; a sharper one is a corner.
inline constexpr double kCurveCorner_rad = 0.35;

// The radius [m] of the curve that a corner stands for, infinite for none.
double corner_radius_m(double turn_rad, double edge_before_m, double edge_after_m);

// One edge of a line, and how much the curves at its ends turn the vehicle off its direction:
// most at the ends, no more from so far in.
struct EdgeHeading {
  double direction_rad = 0.0;
  double length_m = 0.0;
  double begin_off_rad = 0.0;
  double begin_reach_m = 0.0;
  double end_off_rad = 0.0;
  double end_reach_m = 0.0;
};

// Edge by edge of a line driven in one gear, its points apart. Where a corner is a curve's, and
// none tighter than `least_radius_m`, the vehicle is headed along the curve: of the circle through
// the corner and its neighbours, the curve before it run on and the curve after it run back the
// middle one, which is right within an arc and where arcs and straight lines meet. At any other
// corner each edge keeps its direction. Lines begin and end on the curve of their next corner.
std::vector<EdgeHeading> edge_headings(std::span<const Eigen::Vector2d> points_W,
                                       double least_radius_m);

double heading_on(const EdgeHeading& edge, double from_begin_m);

}  // namespace headland
