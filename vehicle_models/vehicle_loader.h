// Reads vehicles from their folders.
#pragma once

#include <string>
#include <vector>

#include "vehicle_models/vehicle.h"

namespace headland {

// The vehicle in folder `name_or_folder`, or of that name among the built-in ones
// (HEADLAND_VEHICLE_DIR in the environment replaces the built-in folder). Throws InputError for a
// missing or malformed file, an unknown or missing key (with the nearest known one), a number
// without a source, or a value out of its range.
Vehicle load_vehicle(const std::string& name_or_folder);

// Names of the built-in vehicles, sorted.
std::vector<std::string> vehicle_names();

}  // namespace headland
