// Standard manoeuvres, whose costs are measured one by one.
#pragma once

#include <string_view>
#include <vector>

#include "planner/path.h"
#include "vehicle_models/vehicle.h"

namespace headland {

enum class ManoeuvreKind {
  kStraight,        // at constant speed
  kStopStart,       // from work speed to a stop and back
  kImplementCycle,  // implement up and down again while driving on
  kTurn90,          // a quarter circle
  kUTurn,           // two quarter circles and the line between them
  kOmegaTurn,       // the bulb of three arcs between rows closer than twice the radius
  kThreePointTurn,  // a quarter circle, back, a quarter circle
  kPivotTurn        // a quarter turn on the spot, the row spacing, a quarter turn on the spot
};

// "straight", "stop and start", "implement cycle", "90-degree turn", "U turn", "omega turn",
// "three-point turn", "pivot turn".
std::string_view manoeuvre_name(ManoeuvreKind kind);

struct Manoeuvre {
  ManoeuvreKind kind = ManoeuvreKind::kStraight;
  bool implement_down = false;  // before and after; turns between rows are driven with it raised
  double speed_mps = 0.0;       // on the straights
  double slope_along = 0.0;     // rise over run, uphill positive
  double slope_across = 0.0;    // rise over run to the left
  double row_spacing_m = 0.0;   // of turns between rows, else 0
};

// A manoeuvre as a path from the origin along +x, and which of its segments make its window. The
// window of a turn reaches from steady driving before it to steady driving after it, so that
// slowing down and speeding up are part of it.
struct Course {
  Path path;
  int first_segment = 0;
  int last_segment = 0;
  double down_m = 0.0;  // of straight driving within the window that is not the manoeuvre itself
  double raised_m = 0.0;
};
Course course_of(const Manoeuvre& manoeuvre, const Vehicle& vehicle);

// What `standard_manoeuvres` ranges over.
struct ManoeuvreRanges {
  std::vector<double> speed_shares = {0.5, 0.75, 1.0, 1.25};  // of the work speed
  std::vector<double> slopes = {-0.20, -0.15, -0.10, -0.05, 0.0, 0.05, 0.10, 0.15, 0.20};
  std::vector<double> side_slopes = {-0.20, -0.10, 0.10, 0.20};
  std::vector<double> spacings_m;  // empty: 1, 2, 3 working widths and 1, 2, 3 turning radii
};

// Straights with the implement down and raised: every speed along every slope that the motor can
// reach, and the work speed across every side slope; on the flat stop and start, the implement's
// cycle, 90-degree turns, and turns between rows of every kind that vehicle, spacing and
// a trailed implement allow.
std::vector<Manoeuvre> standard_manoeuvres(const Vehicle& vehicle, const ManoeuvreRanges& ranges);

}  // namespace headland
