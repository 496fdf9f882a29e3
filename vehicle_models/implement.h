// What a vehicle works with, mounted or trailed, as data.
#pragma once

#include <optional>
#include <string>

namespace headland {

// Where and on what a trailed implement runs: a drawbar free to turn on the vehicle's hitch pin,
// with one axle of two wheels under the implement's centre of mass.
struct Trailing {
  double hitch_x_B_m = 0.0;       // of the pin; negative: behind the rear axle
  double hitch_height_m = 0.4;    // of the pin above the ground
  double drawbar_length_m = 0.0;  // pin to implement axle
  double track_m = 1.5;           // of the implement's wheels
  double wheel_radius_m = 0.3;
  double rolling_resistance = 0.0;  // of its tyres; 0: the soil's
  double max_angle_rad = 1.2;       // between drawbar and vehicle, where they touch
};

// An implement, a bar across the direction of travel. Mounted: fixed to the vehicle at x_B_m
// (negative: behind the rear axle). Trailed: x_B_m is where the bar is when driving straight.
struct Implement {
  std::string name;
  double mass_kg = 0.0;
  double x_B_m = 0.0;  // of the working line
  double working_width_m = 0.0;
  double draft_n_per_m = 0.0;     // per metre of width, at any speed
  double draft_height_m = 0.3;    // height of the draft force's line of action
  double com_height_m = 0.5;      // of the implement's own mass
  double shaft_power_w = 0.0;     // mechanical, while down
  double shaft_efficiency = 1.0;  // battery to shaft
  double lift_time_s = 2.0;
  double lift_energy_j = 0.0;  // per raise
  std::optional<Trailing> trailing;
};

}  // namespace headland
