#include "evaluate/compared_region.h"

#include <fmt/format.h>

#include "planner/region_energy.h"
#include "terrains/input_error.h"

namespace headland {

void divide(ComparedRegion& region, const std::string& source) {
  region.parts = region_parts(from_field(region.field), region.options);
  if (!region.parts.parts.empty()) return;
  throw InputError(source, "parts.least_area_m2", fmt::format("{}", region.options.least_m2),
                   "no part of the field is that large");
}

std::vector<WorkedPart> worked_parts(const ComparedRegion& region, PartSweeps sweeps) {
  return worked_parts(region.parts, region.options.width_m, sweeps);
}

RegionProblem region_problem(const ComparedRegion& region, PartSweeps sweeps) {
  const std::vector<WorkedPart> parts = worked_parts(region, sweeps);
  RegionProblem problem = region_problem(parts, region.start_W, region.end_W);
  if (region.cost) {
    price_by_energy(parts, *region.cost, region.terrain ? &*region.terrain : nullptr, problem);
  }
  return problem;
}

std::optional<double> least_cost(const ComparedRegion& region, PartSweeps sweeps) {
  return sweeps == PartSweeps::kOwn ? region.least_own : region.least_any;
}

}  // namespace headland
