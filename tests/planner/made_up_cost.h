// Costs with numbers that are easy to reckon with.
#pragma once

#include "planner/drive_cost.h"

namespace headland {

// Uphill dearer than downhill brings back, a side slope a little dearer than none.
inline DriveCost made_up_cost() {
  DriveCost cost;
  cost.working = {{-0.2, -0.1, 0.0, 0.1, 0.2}, {0.2, 0.4, 1.0, 1.8, 2.6}, 2.0};
  cost.raised = {{-0.2, -0.1, 0.0, 0.1, 0.2}, {0.1, 0.1, 0.4, 1.1, 1.8}, 1.0};
  cost.transit = {{0.0}, {0.3}, 0.0};
  cost.bend_wh = 0.5;
  cost.stop_working_wh = 0.8;
  cost.stop_raised_wh = 0.2;
  cost.movement = {0.25, 0.125, 0.5, 2.0};
  cost.row_turns = {{RowTurn::kU, 6.0, 10.0, 0.5},
                    {RowTurn::kU, 10.0, 14.0, 0.9},
                    {RowTurn::kOmega, 2.0, 12.0, 1.0},
                    {RowTurn::kThreePoint, 2.0, 8.0, 1.2}};
  cost.turning_radius_m = 2.5;
  return cost;
}

}  // namespace headland
