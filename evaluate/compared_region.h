// A field of a comparison, divided into parts whose order planners choose.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "planner/drive_cost.h"
#include "planner/region_planners.h"
#include "planner/worked_parts.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"

namespace headland {

struct ComparedRegion {
  Field field;
  PartsOptions options;
  RegionParts parts;
  std::optional<Eigen::Vector2d> start_W;  // none: the planner chooses
  std::optional<Eigen::Vector2d> end_W;
  std::optional<Heightfield> terrain;  // none: flat
  std::optional<DriveCost> cost;       // measured ones, in W h; none: plans are reckoned in metres
  // Proven least costs with parts swept in their own direction, or in any; see prove_least_costs.
  // None: not looked for, or too large.
  std::optional<double> least_own;
  std::optional<double> least_any;
};

// Cut as the options say. Throws InputError (source) where no part is left, or GEOS refuses.
void divide(ComparedRegion& region, const std::string& source);

std::vector<WorkedPart> worked_parts(const ComparedRegion& region, PartSweeps sweeps);

// With measured costs by them. Throws InputError as price_by_energy.
RegionProblem region_problem(const ComparedRegion& region, PartSweeps sweeps);

std::optional<double> least_cost(const ComparedRegion& region, PartSweeps sweeps);

// What memory proofs may take, each.
inline constexpr double kMostProofBytes = 256.0 * 1024.0 * 1024.0;

}  // namespace headland
