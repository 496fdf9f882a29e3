// What follows from a vehicle's numbers before it is driven: loads, speeds, forces, limits.
//
// Level ground, at rest, implement raised unless said otherwise; a mounted one's mass acts at
// implement.x_B_m and com_height_m, a trailed one stands on its own wheels and presses on the hitch
// pin. Tyres are rigid and do not slip.
#pragma once

#include "terrains/traction.h"
#include "vehicle_models/vehicle.h"

namespace headland {

inline constexpr double kGravity_mps2 = 9.80665;  // standard gravity

// Mass [kg] of the machine with what is mounted on it.
double carried_mass_kg(const Vehicle& vehicle);

// Weight [N] that a trailed implement puts on the hitch pin; 0 for a mounted one.
double hitch_load_n(const Vehicle& vehicle);

// Share of that mass's weight on the front axle, without the hitch load.
double front_load_share(const Vehicle& vehicle);

// Weight on each axle [N], hitch load included; negative when the axle would lift.
struct AxleLoads {
  double rear_n = 0.0;
  double front_n = 0.0;
};
AxleLoads static_axle_loads(const Vehicle& vehicle);

// How far [m] B's origin lies ahead of the axle that a skid-steered vehicle turns about on the spot
// and on tight curves: the tyres of both axles slide sideways with the same friction, so the axle
// that carries more stays where it is.
double ahead_of_pivot_m(const Vehicle& vehicle);

// Centre of mass of the machine with a mounted implement, in B [m].
Eigen::Vector3d total_com_B(const Vehicle& vehicle);

// Side slope [rad] on which the first uphill wheel lifts: with two rigid axles atan(t / 2h), t the
// track where the centre of mass is. A pivoted axle holds at its pivot only, at hub height.
double side_stability_angle_rad(const Vehicle& vehicle);

// Slope [rad] on which the front wheels (heading uphill) or the rear wheels (downhill) lift.
double nose_up_stability_angle_rad(const Vehicle& vehicle);
double nose_down_stability_angle_rad(const Vehicle& vehicle);

// Speed [m/s] at the motor's top speed without slip.
double top_speed_mps(const Vehicle& vehicle);

// Size of an axle's tyres, unloaded, when each carries `load_n` at radius_m.
TyreSize tyre_size(const Axle& axle, double load_n);

// What the wheels find on a soil under their static loads, as fractions of the load.
struct SoilFigures {
  double net_pull = 0.0;            // largest, of the driven wheels
  double rolling_resistance = 0.0;  // of all wheels
};
SoilFigures figures_on(const Vehicle& vehicle, const Soil& soil);

// Largest force [N] of the driven wheels at `speed_mps` by the motor's torque and power limits,
// whatever the soil can hold; 0 beyond the top speed.
double drive_force_n(const Vehicle& vehicle, double speed_mps);

// Steepest slope (rise over run) that the motor can start on with the implement raised and the
// given rolling resistance coefficient, whatever the soil can hold.
double max_grade(const Vehicle& vehicle, double rolling_resistance);

// Steepest slope (rise over run) that the driven wheels can climb steadily by their grip, whatever
// the motor can do; 0 when they cannot move on the flat. `net_pull` is the largest pull of a driven
// wheel over its load, `rolling_resistance` that of the others. The slope shifts weight backwards.
double max_grade_by_grip(const Vehicle& vehicle, double net_pull, double rolling_resistance);

// Pull [N] that a trailed implement's wheels need on the flat at a steady speed and, with the
// implement down, the draft of either kind.
double needed_pull_n(const Vehicle& vehicle, double rolling_resistance, SoilTexture texture,
                     double speed_mps, bool working);

// Largest steady pull [N] on the flat that motor and grip leave after rolling the vehicle itself.
struct HitchPull {
  double by_motor_n = 0.0;
  double by_grip_n = 0.0;
};
HitchPull hitch_pull(const Vehicle& vehicle, const SoilFigures& on_soil, double speed_mps);

// Steady driving on the flat until the battery is empty, without slip. With the implement down
// (`working`) draft and shaft power count too.
struct Endurance {
  double power_w = 0.0;  // from the battery's terminals
  double time_h = 0.0;   // 0 when motor or battery cannot hold this speed
  double distance_m = 0.0;
};
Endurance endurance(const Vehicle& vehicle, double speed_mps, double rolling_resistance,
                    bool working, SoilTexture texture = SoilTexture::kMedium);

// Electrical power [W] of one motor at full shaft power and full torque, by its loss model.
double motor_peak_input_w(const Motor& motor);

// Electrical power [W] of all motors together with their inverters, at full shaft power.
double drive_peak_input_w(const Vehicle& vehicle);

// Nominal voltage [V] (2.0 V a lead-acid cell, 3.2 V a LFP cell) and energy [Wh].
double nominal_voltage_v(const Battery& battery);
double nominal_energy_wh(const Battery& battery);

// Largest power [W] that the nearly empty pack can give for good: E^2 / (4 (R0 + R1)) with
// 2.0 V a lead-acid cell and 2.9 V a LFP cell.
double max_battery_power_w(const Battery& battery);

}  // namespace headland
