// What follows from a vehicle's numbers before it is driven: loads, speeds, forces, limits.
//
// Level ground, at rest, implement raised unless said otherwise; its mass acts at
// implement.x_B_m.
#pragma once

#include "vehicle_models/vehicle.h"

namespace headland {

inline constexpr double kGravity_mps2 = 9.80665;  // standard gravity

// Weight on each axle [N]; negative when the axle would lift.
struct AxleLoads {
  double rear_n = 0.0;
  double front_n = 0.0;
};
AxleLoads static_axle_loads(const Vehicle& vehicle);

// Side slope [rad] on which the uphill wheels lift, at rest: atan(t / 2h) with the wider track.
double side_stability_angle_rad(const Vehicle& vehicle);

// Slope [rad] up which the front wheels lift, at rest: atan(d / h) with the distance d of the mass
// ahead of the rear axle.
double nose_up_stability_angle_rad(const Vehicle& vehicle);

// Speed [m/s] at the motor's top speed without slip.
double top_speed_mps(const Vehicle& vehicle);

// Largest force [N] of the driven wheels at `speed_mps` by the motor's torque and power limits,
// whatever the soil can hold; 0 beyond the top speed.
double drive_force_n(const Vehicle& vehicle, double speed_mps);

// Steepest slope (rise over run) that the motor can start on with the implement raised and the
// given rolling resistance coefficient, whatever the soil can hold.
double max_grade(const Vehicle& vehicle, double rolling_resistance);

// Electrical power [W] of the motor at full shaft power and full torque, by its loss model.
double motor_peak_input_w(const Motor& motor);

// Nominal voltage [V] (2.0 V a lead-acid cell, 3.2 V a LFP cell) and energy [Wh].
double nominal_voltage_v(const Battery& battery);
double nominal_energy_wh(const Battery& battery);

// Largest power [W] that the nearly empty pack can give for good: E^2 / (4 (R0 + R1)) with
// 2.0 V a lead-acid cell and 2.9 V a LFP cell.
double max_battery_power_w(const Battery& battery);

}  // namespace headland
