// Battery pack: open-circuit voltage over SOC, series resistance and one RC pair.
#pragma once

#include "vehicle_models/vehicle.h"

namespace headland {

struct BatteryState {
  double soc = 1.0;             // 0..1
  double polarisation_v = 0.0;  // over the RC pair
};

// One step of the pack. Discharge is positive.
struct BatteryFlow {
  double current_a = 0.0;
  double voltage_v = 0.0;    // at the terminals
  double chemistry_w = 0.0;  // open-circuit voltage times current
  double loss_w = 0.0;       // chemistry minus terminal power
};

// Rested voltage of the pack [V]. Lead-acid 2.15 - 0.15 DoD a cell (Larminie and Lowry); LFP by
// table, linear between its points, constant beyond them.
double open_circuit_voltage_v(const Battery& battery, double soc);

// Most power [W] the terminals can give in this state: E^2 / (4 R0).
double max_discharge_power_w(const Battery& battery, const BatteryState& state);

// Most power [W] >= 0 the pack takes in: the charge rate limit, nothing above kFullSoc.
double max_charge_power_w(const Battery& battery, const BatteryState& state);
inline constexpr double kFullSoc = 0.95;

// Draws `power_w` at the terminals for dt: I = (E - sqrt(E^2 - 4 R P)) / (2 R) with
// E = OCV - V1; power beyond the limit is cut to it. Lead-acid loses charge by Peukert's law
// against its 20 h rate. Advances `state`.
BatteryFlow draw(const Battery& battery, double power_w, double dt_s, BatteryState& state);

}  // namespace headland
