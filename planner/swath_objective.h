// What the direction of swaths is chosen by.
#pragma once

#include "planner/drive_cost.h"
#include "planner/headland_edges.h"
#include "planner/line_energy.h"
#include "planner/swaths.h"
#include "terrains/heightfield.h"

namespace headland {

// Metres: all swaths, and turn_m from each to the next.
SwathGridCost length_and_turns(double turn_m);

// The fewest swaths, and so the fewest turns; of equally many the shortest together.
SwathGridCost fewest_turns();

// The shortest swaths together: the least ground worked twice.
SwathGridCost least_length();

// Wh from measured costs: along every swath by the slopes of the ground along and across it, the
// mean of both ways as neighbours are driven in turn, and from each swath to the next the cheapest
// turn between rows of that spacing. Slopes are taken kEnergyStep_m apart, further on grids longer
// than kMostEnergySteps of these. `terrain` (null: flat) and `cost` must outlive the result; `cost`
// has row turns. The ways to and from far swaths are not counted.
SwathGridCost least_energy(const DriveCost& cost, const Heightfield* terrain);
inline constexpr double kMostEnergySteps = 2e4;

// `cost`, and kNoRoomCost for every end of a swath that runs into an edge that is too narrow for
// turning, not further than a width from its headland, and kUnworkedCost for every metre of swath
// that is not kept_within the ground.
SwathGridCost with_room_to_turn(SwathGridCost cost, std::vector<NarrowEdge> narrow, double width_m,
                                const SwathGround& ground);
inline constexpr double kNoRoomCost = 1e6;
inline constexpr double kUnworkedCost = 10.0;

}  // namespace headland
