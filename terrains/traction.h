// Laws of traction: what one wheel finds on a soil under its load.
#pragma once

#include "terrains/soil.h"

namespace headland {

// A tyre as the soil meets it.
struct TyreSize {
  double width_m = 0.0;           // b, > 0
  double diameter_m = 0.0;        // d, unloaded, > 0
  double section_height_m = 0.0;  // h, from rim to tread, > 0
};

// All forces as fractions of the wheel load. The tyre pulls gross_pull(u) with
// u = slip_stiffness |s| along and |alpha| / gamma across; the soil and the tyre take the rest.
struct Traction {
  double full_pull = 0.0;                 // limit of gross_pull
  double slip_stiffness = 1.0;            // per unit of slip
  double tyre_resistance = 0.0;           // a torque on the wheel over load and rolling radius
  double soil_resistance = 0.0;           // a force against the motion, at no slip ...
  double soil_resistance_per_slip = 0.0;  // ... and what slip adds to it
  double pacejka_c = 0.0;                 // 0: exponential
  double pacejka_e = 0.0;
};

// Brixius (ASABE D497), deflection in m, W in kN:
//   Bn = (CI b d / W) (1 + 5 deflection/h) / (1 + 3 b/d)
//   gross traction 0.88 (1 - exp(-0.1 Bn)) (1 - exp(-7.5 s)) + 0.04
//   motion resistance 1/Bn + 0.04 + 0.5 s / sqrt(Bn)
// The 0.04 of both is the tyre's own resistance: a torque at the axle that never reaches the soil.
// `load_n` > 0; deflection in 0..h.
Traction traction_on(const Soil& soil, const TyreSize& tyre, double load_n, double deflection_m);

// Pull of the tyre's contact with the soil at the combined slip u >= 0, in 0..full_pull.
double gross_pull(const Traction& traction, double u);

// Steady straight pull on the hub [fraction of load] at slip s in 0..1: gross pull less the soil's
// resistance. Net traction of Brixius.
double net_pull(const Traction& traction, double slip);

// Largest net pull at any slip up to 1, and the slip where it lies.
struct BestPull {
  double net_pull = 0.0;
  double slip = 0.0;
};
BestPull best_pull(const Traction& traction);

// Resistance of a wheel rolling without slip: tyre and soil together.
inline double rolling_resistance(const Traction& traction) {
  return traction.tyre_resistance + traction.soil_resistance;
}

}  // namespace headland
