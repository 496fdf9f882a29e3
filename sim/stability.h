// Whether a vehicle's tyres can be stepped at a rate.
#pragma once

#include "vehicle_models/vehicle.h"

namespace headland {

// Must stay stable with its tyres this much stiffer and more damped: load moves to single wheels,
// and a tyre in the air does not pull.
inline constexpr double kStabilityMargin = 2.0;

// Largest growth of small heave, roll and pitch of vehicle and trailed implement on their tyres
// in one step (spectral radius; stable up to 1), tyres `harder` times as stiff and damped. With one
// mode of mass m, stiffness k and damping c it passes 1 where k dt^2 / m + 2 c dt / m = 4 (Jury's
// criterion for the step v += a dt, x += v dt). Pivoted axles count as rigid, as at their stops.
double growth_per_step(const Vehicle& vehicle, double rate_hz, double harder = 1.0);

// Throws InputError (the vehicle's key, and a rate that would do) for a vehicle that is unstable at
// `rate_hz` with kStabilityMargin: the numbers would throw it over, not the ground.
void require_stable(const Vehicle& vehicle, double rate_hz);

}  // namespace headland
