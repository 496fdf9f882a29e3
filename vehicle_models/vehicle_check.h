// Whether a vehicle's numbers make sense together.
#pragma once

#include <string>

#include "vehicle_models/vehicle.h"

namespace headland {

// Throws InputError(source, key, value, what would do) for a vehicle that could not stand, steer,
// drive at its own speeds, brake, pull its implement or feed its motor. Ranges of single numbers
// are the loader's business; call this again after changing a loaded vehicle.
void check_vehicle(const Vehicle& vehicle, const std::string& source);

// A parked machine must hold on this slope (rise over run) by its brakes.
inline constexpr double kParkingGrade = 0.20;

// Share of the weight that the front axle must carry to steer, at rest.
inline constexpr double kMinFrontLoadShare = 0.10;

inline constexpr double kMaxTurningRadius_m = 100.0;

// Largest sag of a tyre under the static load, over its radius.
inline constexpr double kMaxStaticDeflection = 0.2;

}  // namespace headland
