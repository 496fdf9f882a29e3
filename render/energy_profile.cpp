#include "render/energy_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace headland {
namespace {

constexpr double kSmallestSpan_wh_per_m = 1e-3;

// Energy at a place on the track, by the samples around it.
double energy_at(std::span<const RunSample> samples, std::span<const double> energy_wh,
                 double travel_m) {
  const auto after = std::upper_bound(
      samples.begin(), samples.end(), travel_m,
      [](double travel, const RunSample& sample) { return travel < sample.travel_m; });
  if (after == samples.begin()) return energy_wh.front();
  if (after == samples.end()) return energy_wh.back();
  const auto i = static_cast<std::size_t>(after - samples.begin());
  const double step_m = samples[i].travel_m - samples[i - 1].travel_m;
  const double share = (travel_m - samples[i - 1].travel_m) / step_m;
  return energy_wh[i - 1] + share * (energy_wh[i] - energy_wh[i - 1]);
}

}  // namespace

std::vector<double> energy_per_metre_wh(std::span<const RunSample> samples, double window_m) {
  if (samples.size() < 2) return {};
  const double first_m = samples.front().travel_m;
  const double last_m = samples.back().travel_m;
  if (!(last_m > first_m)) return {};
  std::vector<double> energy_wh(samples.size(), 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double power_w = 0.5 * (samples[i].battery_power_w + samples[i - 1].battery_power_w);
    energy_wh[i] = energy_wh[i - 1] +
                   power_w * (samples[i].time_s - samples[i - 1].time_s) / kJoulePerWattHour;
  }
  std::vector<double> profile;
  profile.reserve(samples.size());
  for (const RunSample& sample : samples) {
    const double from_m = std::max(first_m, sample.travel_m - 0.5 * window_m);
    const double to_m = std::min(last_m, sample.travel_m + 0.5 * window_m);
    profile.push_back(
        (energy_at(samples, energy_wh, to_m) - energy_at(samples, energy_wh, from_m)) /
        (to_m - from_m));
  }
  return profile;
}

EnergyFigures energy_figures(std::span<const RunSample> samples, std::span<const double> profile) {
  assert(!profile.empty() && samples.size() == profile.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (std::isfinite(profile[i])) order.push_back(i);
  }
  EnergyFigures figures;
  figures.scale_high_wh_per_m = kSmallestSpan_wh_per_m;
  if (order.empty()) return figures;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return profile[a] < profile[b]; });
  const auto travel_of = [&](std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, samples.size() - 1);
    return 0.5 * (samples[after].travel_m - samples[before].travel_m);
  };
  double total_m = 0.0;
  for (const std::size_t i : order) total_m += travel_of(i);
  const auto quantile = [&](double share) {
    double passed_m = 0.0;
    for (const std::size_t i : order) {
      passed_m += travel_of(i);
      if (passed_m >= share * total_m) return profile[i];
    }
    return profile[order.back()];
  };
  figures.min_wh_per_m = profile[order.front()];
  figures.median_wh_per_m = quantile(0.5);
  figures.max_wh_per_m = profile[order.back()];
  figures.scale_low_wh_per_m = std::min(0.0, quantile(0.02));
  figures.scale_high_wh_per_m = quantile(0.98);
  figures.scale_high_wh_per_m =
      std::max(figures.scale_high_wh_per_m, figures.scale_low_wh_per_m + kSmallestSpan_wh_per_m);
  return figures;
}

}  // namespace headland
