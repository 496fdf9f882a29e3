#include "sim/battery.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace headland {
namespace {

struct OcvPoint {
  double soc;
  double cell_v;
};

constexpr std::array<OcvPoint, 11> kLfpCell{{{0.010, 2.90},
                                             {0.054, 3.12},
                                             {0.096, 3.17},
                                             {0.180, 3.20},
                                             {0.270, 3.23},
                                             {0.356, 3.25},
                                             {0.480, 3.269},
                                             {0.610, 3.276},
                                             {0.740, 3.29},
                                             {0.870, 3.313},
                                             {0.957, 3.32}}};

double lfp_cell_v(double soc) {
  if (soc <= kLfpCell.front().soc) return kLfpCell.front().cell_v;
  for (std::size_t i = 1; i < kLfpCell.size(); ++i) {
    const OcvPoint& low = kLfpCell[i - 1];
    const OcvPoint& high = kLfpCell[i];
    if (soc <= high.soc) {
      return low.cell_v + (high.cell_v - low.cell_v) * (soc - low.soc) / (high.soc - low.soc);
    }
  }
  return kLfpCell.back().cell_v;
}

double electromotive_v(const Battery& battery, const BatteryState& state) {
  return open_circuit_voltage_v(battery, state.soc) - state.polarisation_v;
}

// Charge taken from a lead-acid pack per ampere second delivered.
double peukert_factor(const Battery& battery, double current_a) {
  constexpr double kRatedHours = 20.0;
  const double rated_a = battery.capacity_ah / kRatedHours;
  return current_a > rated_a ? std::pow(current_a / rated_a, battery.peukert - 1.0) : 1.0;
}

}  // namespace

double open_circuit_voltage_v(const Battery& battery, double soc) {
  const double cell_v = battery.chemistry == Chemistry::kLeadAcid
                            ? 2.15 - 0.15 * (1.0 - std::clamp(soc, 0.0, 1.0))
                            : lfp_cell_v(soc);
  return battery.cells_in_series * cell_v;
}

double max_discharge_power_w(const Battery& battery, const BatteryState& state) {
  const double e_v = electromotive_v(battery, state);
  return e_v * e_v / (4.0 * battery.resistance_ohm);
}

double max_charge_power_w(const Battery& battery, const BatteryState& state) {
  if (state.soc >= kFullSoc) return 0.0;
  const double current_a = battery.max_charge_c_rate * battery.capacity_ah;
  return current_a * (electromotive_v(battery, state) + current_a * battery.resistance_ohm);
}

BatteryFlow draw(const Battery& battery, double power_w, double dt_s, BatteryState& state) {
  const double ocv_v = open_circuit_voltage_v(battery, state.soc);
  const double e_v = ocv_v - state.polarisation_v;
  const double r_ohm = battery.resistance_ohm;
  const double given_w = std::min(power_w, max_discharge_power_w(battery, state));
  const double discriminant = std::max(0.0, e_v * e_v - 4.0 * r_ohm * given_w);

  BatteryFlow flow;
  // The root (E - sqrt(..)) / (2 R), written so that it keeps its digits as R goes to zero.
  flow.current_a = 2.0 * given_w / (e_v + std::sqrt(discriminant));
  flow.voltage_v = e_v - flow.current_a * r_ohm;
  flow.chemistry_w = ocv_v * flow.current_a;
  flow.loss_w = flow.chemistry_w - flow.voltage_v * flow.current_a;

  // dV1/dt = I / C1 - V1 / (R1 C1) with tau = R1 C1, stepped implicitly: stable for any tau.
  const double tau_s = battery.polarisation_time_constant_s;
  state.polarisation_v =
      (state.polarisation_v + dt_s * flow.current_a * battery.polarisation_resistance_ohm / tau_s) /
      (1.0 + dt_s / tau_s);
  state.soc -= dt_s * flow.current_a * peukert_factor(battery, flow.current_a) /
               (3600.0 * battery.capacity_ah);
  return flow;
}

}  // namespace headland
