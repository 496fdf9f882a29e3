// A table of costs that are sums of a few known numbers.
#pragma once

#include "evaluate/cost_table.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {

// Wh of one joule.
inline constexpr double kPerJoule_wh = 1.0 / 3600.0;

inline MeasuredCost cost_of_one(ManoeuvreKind kind, bool down, double along, double across,
                                double spacing_m, double length_m, double wh, double extra_wh) {
  MeasuredCost cost;
  cost.manoeuvre = {kind, down, 1.0, along, across, spacing_m};
  cost.distance_m.mean = length_m;
  cost.energy_j.mean = wh / kPerJoule_wh;
  cost.marginal_energy_j.mean = extra_wh / kPerJoule_wh;
  return cost;
}

// 2 Wh a metre at work and 1 raised, 10 more or less for a slope of 1; a cycle takes 3, a quarter
// 2, a cusp 4 more: the turns between rows are made of these.
inline CostTable made_up_table() {
  CostTable table;
  table.repeats = 1;
  table.vehicle = "transplanter";
  table.soil = "firm";
  table.working_width_m = 2.0;
  table.turning_radius_m = planning_turning_radius_m(load_vehicle("transplanter"));
  table.work_speed_mps = 1.0;
  for (const bool down : {true, false}) {
    const double flat = down ? 2.0 : 1.0;
    for (const double along : {0.1, -0.1, 0.0}) {
      table.costs.push_back(cost_of_one(ManoeuvreKind::kStraight, down, along, 0.0, 0.0, 10.0,
                                        10.0 * (flat + 10.0 * along), 0.0));
    }
    table.costs.push_back(cost_of_one(ManoeuvreKind::kStraight, down, 0.0, 0.2, 0.0, 10.0,
                                      10.0 * (flat + 0.04 * 5.0), 0.0));
    table.costs.push_back(
        cost_of_one(ManoeuvreKind::kStopStart, down, 0.0, 0.0, 0.0, 1.0, flat + 0.5, 0.5));
    table.costs.push_back(
        cost_of_one(ManoeuvreKind::kTurn90, down, 0.0, 0.0, 0.0, 4.0, 4.0 * flat + 2.0, 2.0));
  }
  table.costs.push_back(
      cost_of_one(ManoeuvreKind::kImplementCycle, true, 0.0, 0.0, 0.0, 0.0, 3.0, 3.0));
  table.costs.push_back(cost_of_one(ManoeuvreKind::kUTurn, true, 0.0, 0.0, 6.0, 9.0, 16.0, 7.0));
  table.costs.push_back(
      cost_of_one(ManoeuvreKind::kThreePointTurn, true, 0.0, 0.0, 2.0, 10.0, 25.0, 15.0));
  return table;
}

}  // namespace headland
