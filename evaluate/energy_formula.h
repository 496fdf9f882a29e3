// The energy that paper 000 (CCPP-TPLP) gives an electric tractor, to stand beside what was driven.
#pragma once

namespace headland {

// Eqs 12-15: rolling with friction mu, F = mu m g cos(alpha), over the flat length s:
// F cos(alpha) s. The paper writes alpha = arctan(h_i / d) with heights h_i where slopes are meant;
// alpha is read as the slope's angle.
struct FormulaVehicle {
  double mass_kg = 0.0;
  double mu = 0.25;           // the paper's
  double turn_power_w = 0.0;  // U I in a turn
};

// Energy [J] of a straight of `length_m` in the plane on a slope (rise over run): Eq 12 plus Eq 16,
// whose m g sin(alpha) times the height differences would count the slope twice and is read as
// m g |dh|. The paper's differences have no sign: downhill costs as much as uphill.
double formula_straight_j(const FormulaVehicle& vehicle, double slope, double length_m);

// The same with Eq 16 as it is printed: m g sin(|alpha|) |dh|.
double formula_straight_as_printed_j(const FormulaVehicle& vehicle, double slope, double length_m);

// Energy [J] of a 90-degree turn, Eqs 18 and 19: U I pi d / (2 v), d the side of a cell.
double formula_turn_j(const FormulaVehicle& vehicle, double cell_m, double speed_mps);

}  // namespace headland
