#include "sim/battery.h"

#include <gtest/gtest.h>

#include <cmath>

namespace headland {
namespace {

Battery lead_acid() {
  Battery battery;
  battery.chemistry = Chemistry::kLeadAcid;
  battery.cells_in_series = 24;
  battery.capacity_ah = 60.0;
  battery.resistance_ohm = 0.01;
  battery.polarisation_resistance_ohm = 0.02;
  battery.polarisation_time_constant_s = 30.0;
  battery.peukert = 1.12;
  battery.max_charge_c_rate = 0.2;
  return battery;
}

TEST(Battery, LeadAcidRestsAt36MillivoltsAPercent) {
  const Battery battery = lead_acid();
  const double drop_v =
      open_circuit_voltage_v(battery, 0.80) - open_circuit_voltage_v(battery, 0.79);
  EXPECT_NEAR(drop_v, 0.036, 1e-9);  // 24 cells x 0.15 V x 1 %
}

TEST(Battery, LfpTableIsMonotoneAndFlatInTheMiddle) {
  Battery battery;
  battery.cells_in_series = 16;
  for (double soc = 0.0; soc < 1.0; soc += 0.01) {
    EXPECT_LE(open_circuit_voltage_v(battery, soc), open_circuit_voltage_v(battery, soc + 0.01));
  }
  EXPECT_LT(open_circuit_voltage_v(battery, 0.7) - open_circuit_voltage_v(battery, 0.4), 1.0);
  EXPECT_NEAR(open_circuit_voltage_v(battery, 0.48), 16 * 3.269, 1e-9);
}

TEST(Battery, CurrentSolvesThePowerEquation) {
  const Battery battery = lead_acid();
  BatteryState state;
  const double ocv_v = open_circuit_voltage_v(battery, 1.0);
  const BatteryFlow flow = draw(battery, 2000.0, 0.01, state);
  EXPECT_NEAR(flow.voltage_v * flow.current_a, 2000.0, 1e-9);
  EXPECT_NEAR(flow.voltage_v, ocv_v - 0.01 * flow.current_a, 1e-12);
  EXPECT_NEAR(flow.loss_w, 0.01 * flow.current_a * flow.current_a, 1e-9);
}

TEST(Battery, PolarisationSettlesAtR1TimesCurrent) {
  Battery battery = lead_acid();
  battery.capacity_ah = 1e9;  // the charge stays as it is
  BatteryState state;
  BatteryFlow flow;
  for (int i = 0; i < 100 * 300; ++i) flow = draw(battery, 1000.0, 0.01, state);
  // After ten time constants exp(-10) of the step is left.
  EXPECT_NEAR(state.polarisation_v, 0.02 * flow.current_a, 0.02 * flow.current_a * 1e-4);
}

TEST(Battery, ConstantPowerDischargeDrainsWhatPeukertSays) {
  Battery battery = lead_acid();
  battery.polarisation_resistance_ohm = 0.0;
  BatteryState state;
  const BatteryFlow first = draw(battery, 1500.0, 1.0, state);
  const double rated_a = 60.0 / 20.0;
  const double factor = std::pow(first.current_a / rated_a, 0.12);
  EXPECT_NEAR(1.0 - state.soc, first.current_a * factor / (3600.0 * 60.0), 1e-12);
  EXPECT_GT(factor, 1.3);
}

// The closed form of the time from full to 30 %: dt = C dSOC / (I (I / I20)^(k - 1)), integrated
// over the charge by Simpson's rule, where draw() goes over time.
TEST(Battery, ConstantPowerLastsAsLongAsTheIntegralOverTheChargeSays) {
  Battery battery = lead_acid();
  battery.polarisation_resistance_ohm = 0.0;
  constexpr double kPower_w = 1500.0;
  constexpr double kEnd = 0.3;
  const double rated_a = battery.capacity_ah / 20.0;
  const auto seconds_per_charge = [&](double soc) {
    const double emf_v = open_circuit_voltage_v(battery, soc);
    const double current_a =
        (emf_v - std::sqrt(emf_v * emf_v - 4.0 * battery.resistance_ohm * kPower_w)) /
        (2.0 * battery.resistance_ohm);
    return 3600.0 * battery.capacity_ah /
           (current_a * std::pow(current_a / rated_a, battery.peukert - 1.0));
  };
  constexpr int kIntervals = 200;
  constexpr double kWidth = (1.0 - kEnd) / kIntervals;
  double expected_s = 0.0;
  for (int i = 0; i < kIntervals; ++i) {
    const double soc = kEnd + i * kWidth;
    expected_s += kWidth / 6.0 *
                  (seconds_per_charge(soc) + 4.0 * seconds_per_charge(soc + 0.5 * kWidth) +
                   seconds_per_charge(soc + kWidth));
  }
  BatteryState state;
  constexpr double kStep_s = 0.05;
  double lasted_s = 0.0;
  while (state.soc > kEnd) {
    draw(battery, kPower_w, kStep_s, state);
    lasted_s += kStep_s;
  }
  EXPECT_NEAR(lasted_s, expected_s, 2.0 * kStep_s);  // both ends fall within a step
}

TEST(Battery, AnHourAtConstantPowerLosesTheEnergyDrawn) {
  Battery battery;  // LFP, no Peukert
  battery.cells_in_series = 16;
  battery.capacity_ah = 100.0;
  battery.resistance_ohm = 1e-6;
  BatteryState state;
  state.soc = 0.74;
  double chemistry_j = 0.0;
  for (int i = 0; i < 36000; ++i)
    chemistry_j += 0.1 * draw(battery, 1000.0, 0.1, state).chemistry_w;
  EXPECT_NEAR(chemistry_j / 3600.0, 1000.0, 0.01);  // Wh; R0 loses 4e-6 of it
  // Charge from the mean voltage over the interval, 3.28 V a cell within its 0.03 V span.
  EXPECT_NEAR(0.74 - state.soc, 1000.0 / (16 * 3.28 * 100.0), 1e-3);
}

TEST(Battery, PowerBeyondTheLimitIsCutNotNaN) {
  const Battery battery = lead_acid();
  BatteryState state;
  const double limit_w = max_discharge_power_w(battery, state);
  const BatteryFlow flow = draw(battery, 10.0 * limit_w, 0.01, state);
  EXPECT_NEAR(flow.voltage_v * flow.current_a, limit_w, 1e-6 * limit_w);
}

TEST(Battery, ChargesWithinItsRateAndNotWhenFull) {
  const Battery battery = lead_acid();
  BatteryState state;
  EXPECT_EQ(max_charge_power_w(battery, state), 0.0);
  state.soc = 0.5;
  const double accepted_w = max_charge_power_w(battery, state);
  const BatteryFlow flow = draw(battery, -accepted_w, 0.01, state);
  EXPECT_NEAR(flow.current_a, -0.2 * 60.0, 1e-9);
  EXPECT_GT(state.soc, 0.5);
}

}  // namespace
}  // namespace headland
