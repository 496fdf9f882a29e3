// Charts of what a vehicle's numbers mean: traction, motor, battery, climbing.
#pragma once

#include <string>

#include "terrains/soil.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// A script for chart_of with four panels: net pull of a rear wheel under its static load over slip
// on every known soil and on `soil`; efficiency of one motor over its speed at shares of its
// largest torque, within its power limit; voltage of the battery over its charge, at rest and under
// load; electrical power of steady straight driving over the slope on `soil`, implement raised.
std::string vehicle_charts_script(const Vehicle& vehicle, const Soil& soil);

inline constexpr int kVehicleChartsWidth_px = 1300;
inline constexpr int kVehicleChartsHeight_px = 950;

}  // namespace headland
