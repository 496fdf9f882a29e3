// Parts with every way to work them, and the problem they pose.
#pragma once

#include <optional>
#include <vector>

#include "planner/part_sweep.h"
#include "planner/region_parts.h"
#include "planner/region_plan.h"

namespace headland {

// The sweeps of a part, the one along its own direction first.
struct WorkedPart {
  Ring outline_W;
  std::vector<PartSweep> sweeps;
};

// Which directions a part may be swept in: its own, as in the paper, or also those of its other
// edges in which it is swept whole, the ones with the fewest lines, kMostSweeps in all.
enum class PartSweeps { kOwn, kAny };
inline constexpr int kMostSweeps = 6;
// Edges whose directions differ by less are tried once.
inline constexpr double kSameSweep_rad = 0.01;

std::vector<WorkedPart> worked_parts(const RegionParts& parts, double width_m, PartSweeps sweeps);

// Four variants a sweep, in the order of kSweepWays: variant v is way v % 4 of sweep v / 4.
RegionProblem region_problem(const std::vector<WorkedPart>& parts,
                             const std::optional<Eigen::Vector2d>& start_W,
                             const std::optional<Eigen::Vector2d>& end_W);

// The sweep of a visit's variant, and the line along which it works.
const PartSweep& sweep_of(const std::vector<WorkedPart>& parts, RegionVisit visit);
Polyline way_of(const std::vector<WorkedPart>& parts, RegionVisit visit);

}  // namespace headland
