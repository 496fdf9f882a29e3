// The order of all swaths of a field together, by what the turns between them cost.
#pragma once

#include <optional>
#include <vector>

#include "planner/arcs.h"
#include "planner/plan.h"

namespace headland {

// What an order is reckoned in: metres, or with measured costs W h.
struct TurnCosts {
  double turning_radius_m = 0.0;
  Gears gears = Gears::kBoth;
  const DriveCost* measured = nullptr;   // not owned; null: metres
  const Heightfield* terrain = nullptr;  // for measured ones alone, not owned; null: flat
};

// From the end of one swath to the begin of another: the cheapest turn in closed form (cost_m of
// turns.h, with what reversing and changing gear take; least_turn_wh of line_energy.h) where they
// are at most kNearTurns turning radii apart, else the way as the crow flies and half a circle.
// What lies between is not looked at.
double link_cost(const Pass& from, const Pass& to, const TurnCosts& costs);
inline constexpr double kNearTurns = 8.0;

// From the start as the crow flies, and all links; by measured costs also the swaths themselves,
// which up a slope take more than down.
double order_cost(const std::vector<Pass>& swaths, const std::optional<Eigen::Vector2d>& from_W,
                  const TurnCosts& costs);

// The swaths in an order, and each in a direction, of small order_cost: begun with the order
// given, stretches are driven backwards (2-opt) and up to three swaths moved elsewhere, either way
// round (Or-opt), until none of it helps. Only links between the kNeighbours nearest swaths are
// looked for. Never worse than what is given. Throws Cancelled.
std::vector<Pass> optimised_order(std::vector<Pass> swaths,
                                  const std::optional<Eigen::Vector2d>& from_W,
                                  const TurnCosts& costs, const CancelAsked& cancelled = {});
inline constexpr std::size_t kNeighbours = 12;

}  // namespace headland
