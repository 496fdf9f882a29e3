// What planners know of a vehicle.
#pragma once

#include "planner/plan.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Fills in the request's working width, turning radius, hull, working line, and whether the vehicle
// drives forward only.
void set_vehicle(PlanRequest& request, const Vehicle& vehicle);

}  // namespace headland
