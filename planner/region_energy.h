// The order of parts by measured costs: the length of a plan's ways by what their metres take.
#pragma once

#include <vector>

#include "planner/drive_cost.h"
#include "planner/worked_parts.h"
#include "terrains/heightfield.h"

namespace headland {

// The parts of `problem`, which region_problem has made of `parts`, by measured costs: lines of a
// sweep are worked, and between them, between parts, from the start and to the end the vehicle is
// in transit with the implement raised, metre by metre by the slopes along and across the way
// (line_wh). Directed: uphill is dearer than downhill. `terrain` null: flat. Turns are not counted,
// as they are not in the paper's length. Throws InputError as price_links.
void price_by_energy(const std::vector<WorkedPart>& parts, const DriveCost& cost,
                     const Heightfield* terrain, RegionProblem& problem);

// Numbers the variants and fills RegionProblem::links alone. Throws InputError (kRegionPlanSource)
// for more than kMostPricedVariants, whose table would take 32 MB.
void price_links(const DriveCost& cost, const Heightfield* terrain, RegionProblem& problem);
inline constexpr std::size_t kMostPricedVariants = 2000;

}  // namespace headland
