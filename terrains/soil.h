// Soils as data: what the tyres can pull on and what rolling costs.
#pragma once

#include <span>
#include <string_view>

namespace headland {

// Constant-coefficient ground: Coulomb limit mu N and rolling resistance Crr N, reached over the
// slip below. `source` says where the numbers come from.
struct Soil {
  std::string_view name;
  double friction = 0.6;             // mu, peak traction over wheel load, any direction
  double rolling_resistance = 0.05;  // Crr, over wheel load
  double slip_stiffness = 8.0;       // initial slope of traction over N mu against slip ratio
  double lateral_gamma_rad = 0.09;   // slip angle scale of the lateral force (Crolla)
  std::string_view source;
};

// Every soil the program knows, in the order `headland list soils` prints them.
std::span<const Soil> soils();

}  // namespace headland
