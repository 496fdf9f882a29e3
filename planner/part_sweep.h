// A part of a region worked up and down.
#pragma once

#include <array>
#include <vector>

#include "planner/polygon.h"

namespace headland {

// Lines of a sweep in the order of their distance from the baseline; `from_W` is the end behind,
// `to_W` the one ahead along the sweep's direction.
struct SweepLine {
  Eigen::Vector2d from_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_W = Eigen::Vector2d::Zero();
};

struct PartSweep {
  double direction_rad = 0.0;    // 0 to pi
  std::vector<SweepLine> lines;  // at least one
};

// One of the four ways to work a sweep (IGA-CPP, Figure 2).
struct SweepWay {
  bool from_last_line = false;
  bool from_far_end = false;  // begins at to_W of its first line
};
inline constexpr std::array<SweepWay, 4> kSweepWays = {
    SweepWay{false, false}, SweepWay{false, true}, SweepWay{true, false}, SweepWay{true, true}};

// A ring without the points that lie straight between others, to within 1e-5 m.
Ring corners_of(const Ring& ring);

// The longest edge, of equal ones the first: where its direction leads, and that direction from 0
// to pi.
double longest_edge_rad(const Ring& outline);

// Whether every line in this direction meets the outline's inside in one piece. Back and forth by
// less than kConvex_m counts as straight.
bool is_swept_whole(const Ring& outline, double direction_rad);

// What a sweep needs so that lines are at most width_m apart: height / width, rounded up.
int sweep_line_count(const Ring& outline, double direction_rad, double width_m);

// Lines along direction_rad, spread evenly: the first and the last are half a spacing from the
// outline. The paper takes lines between the longest edge and the farthest corner and does not say
// where they begin. Ends are where the line meets the outline, which is_swept_whole. Line 0 is
// nearest to the edge along the direction, or to the right of it where there is none.
PartSweep sweep_of(const Ring& outline, double direction_rad, double width_m);

// All points of a way, two a line. Each line is entered at its end that is nearer to where the last
// one was left, of equal ones at from_W.
Polyline points_of(const PartSweep& sweep, SweepWay way);

}  // namespace headland
