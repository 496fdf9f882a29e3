#include "terrains/traction.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace headland {
namespace {

// 1 - exp(-x) for x >= 0, in a fraction of the time of expm1: every wheel asks several times a
// step.
double risen(double x) {
  constexpr double kSeries = 1e-3;  // below it four terms are exact to rounding
  if (x < kSeries) return x * (1.0 - x * (1.0 / 2.0 - x * (1.0 / 6.0 - x / 24.0)));
  return 1.0 - std::exp(-x);
}

constexpr double kTyreResistance = 0.04;  // Brixius, both in gross traction and motion resistance

Traction traction_by(const BrixiusSoil& soil, const TyreSize& tyre, double load_n,
                     double deflection_m) {
  const double load_kn = 1e-3 * load_n;
  const double mobility = soil.cone_index_kpa * tyre.width_m * tyre.diameter_m / load_kn *
                          (1.0 + 5.0 * std::min(deflection_m / tyre.section_height_m, 1.0)) /
                          (1.0 + 3.0 * tyre.width_m / tyre.diameter_m);
  Traction traction;
  traction.full_pull = 0.88 * risen(0.1 * mobility);
  traction.slip_stiffness = 7.5;
  traction.tyre_resistance = kTyreResistance;
  traction.soil_resistance = 1.0 / mobility;
  traction.soil_resistance_per_slip = 0.5 / std::sqrt(mobility);
  return traction;
}

Traction traction_by(const Pavement& pavement, const TyreSize&, double, double) {
  Traction traction;
  traction.full_pull = pavement.d;
  traction.slip_stiffness = pavement.b * pavement.c;
  traction.tyre_resistance = pavement.rolling_resistance;
  traction.pacejka_c = pavement.c;
  traction.pacejka_e = pavement.e;
  return traction;
}

Traction traction_by(const ConstantGround& ground, const TyreSize&, double, double) {
  Traction traction;
  traction.full_pull = ground.friction;
  traction.slip_stiffness = ground.slip_stiffness;
  traction.tyre_resistance = ground.rolling_resistance;
  return traction;
}

}  // namespace

Traction traction_on(const Soil& soil, const TyreSize& tyre, double load_n, double deflection_m) {
  return std::visit([&](const auto& law) { return traction_by(law, tyre, load_n, deflection_m); },
                    soil.law);
}

double gross_pull(const Traction& traction, double u) {
  if (traction.pacejka_c == 0.0) return traction.full_pull * risen(u);
  const double x = u / traction.pacejka_c;  // B s, for u = B C s
  const double bent = x - traction.pacejka_e * (x - std::atan(x));
  return traction.full_pull * std::sin(traction.pacejka_c * std::atan(bent));
}

double net_pull(const Traction& traction, double slip) {
  return gross_pull(traction, traction.slip_stiffness * slip) - traction.soil_resistance -
         traction.soil_resistance_per_slip * slip;
}

BestPull best_pull(const Traction& traction) {
  constexpr int kBits = 26;  // half of a double's: the flat top of the curve holds no more
  const auto [slip, loss] = boost::math::tools::brent_find_minima(
      [&](double s) { return -net_pull(traction, s); }, 0.0, 1.0, kBits);
  return {-loss, slip};
}

}  // namespace headland
