// Ground that a vehicle's implement can be brought over at all, whatever the plan.
#pragma once

#include "evaluate/coverage.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// The raster with the cells taken out of `in_field` that the implement comes over in no pose in
// which the chassis keeps `clearance_m` from boundary, holes and obstacles, the implement from
// obstacles, and the implement works on the field alone. Forwards
// and backwards such poses are all joined by drivable paths where the free poses are connected,
// however wide the vehicle turns (Reeds and Shepp 1990), so that the turning radius does not count.
// Connected is what a disc as wide as the vehicle can roll through from the entry, or from the
// largest such ground without one, which is more rather than less. Poses are looked for in
// kReachHeadings directions, along and across nearby edges, with the cell kReachStep_m apart along
// the bar.
CoverageRaster reachable_part(CoverageRaster raster, const Field& field, const Vehicle& vehicle,
                              double clearance_m);

inline constexpr int kReachHeadings = 36;
inline constexpr double kReachStep_m = 0.25;

}  // namespace headland
