// What driving costs one vehicle on one soil, as planners use it. Wh from the battery's cells.
#pragma once

#include <vector>

namespace headland {

// Wh per metre of level distance, straight on at one speed, by the slope along (rise over run,
// uphill positive): linear between the slopes given, and on by the line of the nearest two beyond
// them, up to kSteepest either way; beyond, and below 0, held. A side slope adds `across` times its
// square.
struct SlopeCost {
  std::vector<double> slope;     // ascending; at least one
  std::vector<double> wh_per_m;  // at them
  double across_wh_per_m = 0.0;  // at a side slope of 1
};
inline constexpr double kSteepest = 0.5;

double wh_per_m(const SlopeCost& cost, double slope_along, double slope_across = 0.0);

// What a turn from row to row takes beyond driving as far straight on with the implement raised,
// lifting, lowering, slowing down and speeding up included.
enum class RowTurn { kU, kOmega, kThreePoint, kPivot };
struct RowTurnCost {
  RowTurn kind = RowTurn::kU;
  double row_spacing_m = 0.0;
  double length_m = 0.0;
  double extra_wh = 0.0;
};

// What a movement with the implement raised takes beyond its length straight on. 0 or more each.
struct MovementCost {
  double cycle_wh = 0.0;    // the implement up before it and down after it
  double quarter_wh = 0.0;  // a quarter of a circle, in one or several bends
  double cusp_wh = 0.0;     // a change of gear
  double pivot_wh = 0.0;    // a quarter of a circle on the spot
};

struct DriveCost {
  SlopeCost working;             // implement down, at the work speed
  SlopeCost raised;              // implement up, at the work speed
  SlopeCost transit;             // implement up, at the transit speed
  double bend_wh = 0.0;          // a quarter of a circle with the implement down, beyond its length
  double stop_working_wh = 0.0;  // from the work speed to a stop and back, implement down
  double stop_raised_wh = 0.0;   // and up
  MovementCost movement;         // fits `row_turns` and the cycle and turn measured alone
  std::vector<RowTurnCost> row_turns;
  double turning_radius_m = 0.0;  // that turns were driven with
  double implement_x_m = 0.0;     // of where it works, ahead of B's origin; negative behind
  bool forward_only = false;      // cannot turn with reverse gear
};

// Of the row turns of this spacing the cheapest in all, and what it takes: its length straight on
// with the implement raised, and what it takes beyond. Between spacings of one kind linear, beyond
// them as the nearest one. `row_turns` is not empty.
RowTurnCost cheapest_row_turn(const DriveCost& cost, double row_spacing_m);
double energy_wh(const DriveCost& cost, const RowTurnCost& turn);

}  // namespace headland
