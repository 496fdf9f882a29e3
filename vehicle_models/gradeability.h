// The steepest slope that motors and grip together climb.
#pragma once

#include "terrains/soil.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Steepest slope (rise over run) climbed steadily at walking pace with the implement raised; 0 when
// the vehicle cannot move on the flat. At most the slope on which the front wheels lift. The slope
// shifts weight from the front to the rear axle; each wheel pulls by the soil's law under the load
// it then has, at the slip that its motor's torque or its best pull sets. One motor turns its
// wheels through open differentials: none pulls more than the one with the least grip. A trailed
// implement rolls as the front wheels do.
double gradeability(const Vehicle& vehicle, const Soil& soil);

}  // namespace headland
