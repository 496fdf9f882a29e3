#include "render/path_quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/energy_profile.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::array<QuantityEntry, 7> kEntries = {
    {{PathQuantity::kPower, "power", "Battery power", "W",
      "At the battery's terminals; below zero it is charged."},
     {PathQuantity::kEnergyPerMetre, "energy_per_metre", "Battery energy per metre", "Wh/m",
      "Means over 4 m of travel at the battery's terminals."},
     {PathQuantity::kSlip, "slip", "Wheel slip", "%", "Of the driven wheel that slips most."},
     {PathQuantity::kLoadTransfer, "load_transfer", "Load transfer", "%",
      "Difference of left and right wheel loads over their sum, either side; at 100 % wheels "
      "lift."},
     {PathQuantity::kTracking, "tracking", "Tracking error", "cm",
      "Distance of the vehicle from the planned path, either side."},
     {PathQuantity::kSpeed, "speed", "Speed", "m/s", "Over the ground, in either gear."},
     {PathQuantity::kSoc, "soc", "State of charge", "%", "Of the battery."}}};

double value_of(const RunSample& sample, PathQuantity quantity) {
  constexpr double kPercent = 100.0;
  constexpr double kCentimetres = 100.0;
  switch (quantity) {
    case PathQuantity::kPower:
      return sample.battery_power_w;
    case PathQuantity::kSlip:
      return kPercent * sample.slip;
    case PathQuantity::kLoadTransfer:
      return kPercent * std::abs(sample.load_transfer_ratio);
    case PathQuantity::kTracking:
      return kCentimetres * std::abs(sample.cross_track_error_m);
    case PathQuantity::kSpeed:
      return std::abs(sample.speed_mps);
    case PathQuantity::kSoc:
      return kPercent * sample.soc;
    case PathQuantity::kEnergyPerMetre:
      break;
  }
  return 0.0;
}

}  // namespace

std::span<const QuantityEntry> path_quantities() { return kEntries; }

const QuantityEntry& quantity_entry(PathQuantity quantity) {
  return kEntries[static_cast<std::size_t>(quantity)];
}

PathQuantity quantity_named(const std::string& name) {
  std::vector<std::string> known;
  for (const QuantityEntry& entry : kEntries) {
    if (entry.name == name) return entry.quantity;
    known.emplace_back(entry.name);
  }
  throw InputError("--overlay", "", name, unknown_name("overlay", name, known));
}

std::vector<double> quantity_along(std::span<const RunSample> samples, PathQuantity quantity) {
  if (quantity == PathQuantity::kEnergyPerMetre) {
    return energy_per_metre_wh(samples, kEnergyWindow_m);
  }
  std::vector<double> values;
  values.reserve(samples.size());
  for (const RunSample& sample : samples) values.push_back(value_of(sample, quantity));
  return values;
}

QuantityScale quantity_scale(std::span<const RunSample> samples, std::span<const double> values,
                             PathQuantity quantity) {
  QuantityScale scale;
  if (values.empty()) return scale;
  const EnergyFigures figures = energy_figures(samples, values);
  scale.least = figures.min_wh_per_m;
  scale.median = figures.median_wh_per_m;
  scale.most = figures.max_wh_per_m;
  scale.low = figures.scale_low_wh_per_m;
  scale.high = figures.scale_high_wh_per_m;
  scale.below_zero = quantity == PathQuantity::kPower || quantity == PathQuantity::kEnergyPerMetre;
  // Charge only falls or rises a little: all of the scale for what it did.
  if (quantity == PathQuantity::kSoc) {
    scale.low = scale.least;
    scale.high = std::max(scale.most, scale.least + 1e-3);
  }
  return scale;
}

Rgba quantity_colour(const QuantityScale& scale, double value) {
  if (!scale.below_zero) return viridis((value - scale.low) / (scale.high - scale.low));
  return energy_colour(value < 0.0 ? value / std::max(std::abs(scale.low), 1e-9)
                                   : value / scale.high);
}

}  // namespace headland
