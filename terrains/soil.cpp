#include "terrains/soil.h"

#include <array>

namespace headland {
namespace {

// The three field soils are ASABE D497 (Brixius) reduced to constants for a typical drive wheel:
// b/d = 1/6, deflection 0.2 of the section height, load W/(b d) = 30 kPa, so Bn = CI / 22.5 kPa.
//   Crr = 1/Bn + 0.04; mu = max over slip of gross traction less 0.5 s / sqrt(Bn);
//   slip stiffness = 7.5 * 0.88 (1 - exp(-0.1 Bn)) / mu.
constexpr std::array kSoils{
    Soil{"concrete", 1.0, 0.02, 19.0, 0.09,
         "dry pavement: Pacejka D = 1 and B C D = 19 (MAVS); Crr 0.015-0.02 assumed"},
    Soil{"firm", 0.865, 0.059, 7.6, 0.09,
         "ASABE D497 (Brixius), cone index 1200 kPa, Bn 53.3 at 30 kPa wheel load"},
    Soil{"tilled", 0.847, 0.065, 7.7, 0.09,
         "ASABE D497 (Brixius), cone index 900 kPa, Bn 40 at 30 kPa wheel load"},
    Soil{"soft", 0.727, 0.09, 7.9, 0.09,
         "ASABE D497 (Brixius), cone index 450 kPa, Bn 20 at 30 kPa wheel load"},
};

}  // namespace

std::span<const Soil> soils() { return kSoils; }

}  // namespace headland
