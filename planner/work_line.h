// The line that B's origin follows so that the implement works along a pass.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/arcs.h"
#include "planner/path.h"
#include "planner/plan.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Rear-axle points of one pass, driven forward with the implement down, at most kPathSpacing_m
// apart.
struct WorkLine {
  PathKind kind = PathKind::kSwath;
  std::vector<PathPoint> points;
  std::size_t run_in = 0;  // edges at its begin that are driven with the implement up
  bool optional = false;   // as its pass
  // Of optional lines: the pass driven the other way, as far as the hull fits; may be empty.
  std::vector<PathPoint> other_way;
  std::size_t other_run_in = 0;  // as run_in, of the other way
  // A turn from its end to the begin of the next line, where one is known to fit; else empty.
  std::vector<Arc> turn_to_next;
};

// The pass's line moved on by -implement_x_B_m along itself: an implement behind B's origin
// then works from end to end. A closed ring runs on over its own beginning, other lines run on
// straight. Curved lines are averaged over kSmoothing_m to both sides, which evens out the corners
// of rings made of chords; on a radius R that moves the line inwards by kSmoothing_m^2 / (12 R).
// The pass has two points or more, none repeated.
WorkLine work_line(const Pass& pass, double implement_x_B_m);

// How far [m] before a swath's begin the vehicle must be on its line: a trailed implement comes in
// at an angle that fades by 1 / e on every drawbar length. As far before as the end is driven past,
// so that the turns between swaths lie level: the implement is 2 |x_B| long on the line by then.
double run_in_m(const Vehicle& vehicle);

// Lets a straight line begin that much earlier, or up to a point's spacing less.
void add_run_in(WorkLine& line, double length_m);

// Its first point alone.
PathPoint work_line_begin(const Pass& pass, double implement_x_B_m);

// Its last point alone; of an open line.
PathPoint work_line_end(const Pass& pass, double implement_x_B_m);

inline constexpr double kSmoothing_m = 0.75;

}  // namespace headland
