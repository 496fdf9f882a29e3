// Reads a drive.yaml: what a robot description does not tell about a vehicle.
#pragma once

#include <filesystem>

#include "vehicle_models/vehicle.h"

namespace headland {

// Fills steering, tyres, drivetrain, motor, battery, implement with its draft and trailing gear,
// driver and description of `vehicle`. Throws InputError for a missing or malformed file, an
// unknown or missing key (with the nearest known one), a number without a source, or a value out of
// its range.
void read_drive(const std::filesystem::path& file, Vehicle& vehicle);

}  // namespace headland
