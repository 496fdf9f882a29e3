// What straight ways and turns take by measured costs, before there is a path.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/arcs.h"
#include "planner/drive_cost.h"
#include "terrains/heightfield.h"

namespace headland {

// W h straight from one place p_W to another: directed, by the slopes of the ground along and
// across the way, taken at most kEnergyStep_m apart (further on ways of more than kMostLineSteps of
// these). `terrain` null: flat.
double line_wh(const SlopeCost& cost, const Heightfield* terrain, const Eigen::Vector2d& from_W,
               const Eigen::Vector2d& to_W);
inline constexpr double kEnergyStep_m = 2.0;
inline constexpr int kMostLineSteps = 1000;

// W h of a turn with the implement raised, the cycle before and after it included, on ground that
// rises by `slope` along it.
double turn_wh(const DriveCost& cost, const std::vector<Arc>& arcs, double slope = 0.0);

// W h of the turn that takes least, from a pose to another, of those in closed form (turns.h) with
// the radius that costs were measured with; its slope is that from one end to the other, spread
// over its length. Infinite where there is no turn.
double least_turn_wh(const DriveCost& cost, const Heightfield* terrain, const Pose& from,
                     const Pose& to);

}  // namespace headland
