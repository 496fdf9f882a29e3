// What a vehicle works with, mounted or trailed, as data.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "terrains/soil.h"

namespace headland {

// Where and on what a trailed implement runs: a drawbar free to turn on the vehicle's hitch pin,
// with one axle of two unbraked wheels. Its mass is spread evenly over a rectangle of working width
// and drawbar length.
struct Trailing {
  double hitch_x_B_m = 0.0;       // of the pin; negative: behind the rear axle
  double hitch_height_m = 0.4;    // of the pin above the ground
  double drawbar_length_m = 0.0;  // pin to implement axle
  double com_ahead_m = 0.0;       // of the axle; that share of the drawbar's weight is on the pin
  double track_m = 1.5;           // of the implement's wheels
  double wheel_radius_m = 0.3;    // loaded
  double wheel_width_m = 0.25;
  double wheel_inertia_kg_m2 = 2.0;           // one wheel about its axis
  double vertical_stiffness_n_per_m = 300e3;  // one tyre
  double vertical_damping_n_s_per_m = 4e3;    // one tyre
  double section_height_m = 0.15;             // of the tyre, rim to tread
  double rolling_resistance = 0.0;            // of its tyres; 0: the soil's
  double max_angle_rad = 1.2;                 // between drawbar and vehicle, where they touch
};

// Draft by ASABE D497.7, see draft.h for the law. The coefficients hold per metre of width, or per
// tool where `tools` > 0, and per centimetre of depth.
struct TillageDraft {
  double a = 0.0;
  double b = 0.0;  // per km/h
  double c = 0.0;  // per (km/h)^2
  int tools = 0;
  double depth_cm = 1.0;
  std::array<double, kSoilTextures> texture_factor{1.0, 1.0, 1.0};  // Fi: fine, medium, coarse
};

// What an implement takes up along the vehicle, half of it before its working line and half behind,
// and from top to bottom.
inline constexpr double kImplementDepth_m = 0.5;

// An implement, a bar across the direction of travel. Mounted: fixed to the vehicle at x_B_m
// (negative: behind the rear axle). Trailed: x_B_m is where the bar is when driving straight.
struct Implement {
  std::string name;
  double mass_kg = 0.0;
  double x_B_m = 0.0;  // of the working line
  double working_width_m = 0.0;
  double draft_n_per_m = 0.0;           // per metre of width, at any speed; without `tillage`
  std::optional<TillageDraft> tillage;  // draft by speed, depth and soil instead
  double draft_height_m = 0.3;          // height of the draft force's line of action
  double com_height_m = 0.5;            // of the implement's own mass
  double shaft_power_w = 0.0;           // mechanical, while down
  double shaft_power_w_per_m = 0.0;     // likewise, for each metre of width on top
  double shaft_efficiency = 1.0;        // battery to shaft
  double lift_time_s = 2.0;
  double lift_energy_j = 0.0;  // per raise
  std::optional<Trailing> trailing;
};

// Mechanical power [W] on the shaft at work.
inline double shaft_power_w(const Implement& implement) {
  return implement.shaft_power_w + implement.shaft_power_w_per_m * implement.working_width_m;
}

}  // namespace headland
