// What a run is coloured by along its way: power, energy per metre, slip and the like.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/palette.h"
#include "sim/run_record.h"

namespace headland {

enum class PathQuantity { kPower, kEnergyPerMetre, kSlip, kLoadTransfer, kTracking, kSpeed, kSoc };

struct QuantityEntry {
  PathQuantity quantity = PathQuantity::kPower;
  std::string_view name;   // as options and files spell it
  std::string_view title;  // "Battery power"
  std::string_view unit;
  std::string_view note;  // what exactly is shown
};
std::span<const QuantityEntry> path_quantities();
const QuantityEntry& quantity_entry(PathQuantity quantity);
// Throws InputError naming the known ones.
PathQuantity quantity_named(const std::string& name);

inline constexpr double kEnergyWindow_m = 4.0;  // of travel that energy per metre is a mean over

// A value for every sample, in the entry's unit; empty for a run without samples, and for energy
// per metre without travel.
std::vector<double> quantity_along(std::span<const RunSample> samples, PathQuantity quantity);

// Colours run from `low` to `high`; values beyond have the colours of the ends. Power and energy
// below zero, that is regenerated, are magenta.
struct QuantityScale {
  double low = 0.0;
  double high = 1.0;
  double least = 0.0;
  double median = 0.0;
  double most = 0.0;
  bool below_zero = false;  // values below zero have colours of their own
};
QuantityScale quantity_scale(std::span<const RunSample> samples, std::span<const double> values,
                             PathQuantity quantity);
Rgba quantity_colour(const QuantityScale& scale, double value);

}  // namespace headland
