// What driving costs a vehicle on a soil, manoeuvre by manoeuvre, as measured in the physics.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/manoeuvre.h"
#include "sim/run_record.h"
#include "terrains/terrain_source.h"

namespace headland {

// Mean over the repeats with the half width of its 95 % confidence interval (Student's t), which
// one repeat alone does not have.
struct Estimate {
  double mean = 0.0;
  std::optional<double> ci95;
};
Estimate estimate_of(const std::vector<double>& values);

// Cost of one manoeuvre. A straight's is that of its measured length. A turn's is what its window
// took less what steady driving over the window's straight parts takes: slowing down before it and
// speeding up after it belong to it, so does lifting and lowering the implement.
struct MeasuredCost {
  Manoeuvre manoeuvre;
  Outcome outcome = Outcome::kFinished;  // of the first repeat that did not finish
  std::string outcome_detail;            // nothing below is known then
  Estimate energy_j;                     // from the cells
  Estimate time_s;
  Estimate distance_m;
  Estimate slip;        // mean over the distance, worst driven wheel, 0..1
  Estimate scuffed_m2;  // tread width times the way it slid
  Estimate peak_power_w;
  // Against steady driving of the same distance on the flat at the work speed: straights in the
  // same state, all else with the implement raised.
  Estimate marginal_energy_j;
  Estimate marginal_time_s;
  std::array<double, kEnergyCauses> cause_j{};  // mean; adds up to energy_j
  double formula_j = 0.0;                       // paper 000, see energy_formula.h; 0: says nothing
  double formula_as_printed_j = 0.0;
};

struct CostTable {
  std::string vehicle;
  std::string soil;
  double mass_kg = 0.0;  // with implement
  double working_width_m = 0.0;
  double turning_radius_m = 0.0;  // that the turns were driven with
  double work_speed_mps = 0.0;
  double rate_hz = 0.0;
  MicroRelief micro_relief;
  std::uint64_t seed = 1;
  int repeats = 0;
  double formula_mu = 0.0;
  double formula_turn_power_w = 0.0;
  std::vector<MeasuredCost> costs;
};

// The table as YAML, documented in docs/costs.md, and back. Reading throws InputError.
std::string cost_table_yaml(const CostTable& table);
CostTable read_cost_table(const std::filesystem::path& file);

// The same as CSV, one line a manoeuvre, for spreadsheets.
std::string cost_table_csv(const CostTable& table);

}  // namespace headland
