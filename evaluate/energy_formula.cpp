#include "evaluate/energy_formula.h"

#include <cmath>
#include <numbers>

#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

double rolling_j(const FormulaVehicle& vehicle, double slope, double length_m) {
  const double cosine = std::cos(std::atan(slope));
  return vehicle.mu * vehicle.mass_kg * kGravity_mps2 * cosine * cosine * length_m;
}

double lifting_j(const FormulaVehicle& vehicle, double slope, double length_m) {
  return vehicle.mass_kg * kGravity_mps2 * std::abs(slope) * length_m;
}

}  // namespace

double formula_straight_j(const FormulaVehicle& vehicle, double slope, double length_m) {
  return rolling_j(vehicle, slope, length_m) + lifting_j(vehicle, slope, length_m);
}

double formula_straight_as_printed_j(const FormulaVehicle& vehicle, double slope, double length_m) {
  return rolling_j(vehicle, slope, length_m) +
         std::sin(std::atan(std::abs(slope))) * lifting_j(vehicle, slope, length_m);
}

double formula_turn_j(const FormulaVehicle& vehicle, double cell_m, double speed_mps) {
  return vehicle.turn_power_w * std::numbers::pi * cell_m / (2.0 * speed_mps);
}

}  // namespace headland
