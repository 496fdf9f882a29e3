#include "planner/planned_vehicle.h"

namespace headland {

void set_vehicle(PlanRequest& request, const Vehicle& vehicle) {
  request.working_width_m = vehicle.implement.working_width_m;
  request.turning_radius_m = planning_turning_radius_m(vehicle);
  request.vehicle_width_m = vehicle.body.width_m;
  request.vehicle_front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  request.vehicle_rear_m = vehicle.body.rear_overhang_m;
  request.implement_x_B_m = vehicle.implement.x_B_m;
  request.forward_only = vehicle.implement.trailing.has_value();
}

}  // namespace headland
