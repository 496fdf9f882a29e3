#include "render/run_moment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

bool is_placed(const RunSample& sample) { return sample.p_WB.allFinite(); }

// The short way round.
double turned(double from_rad, double to_rad, double share) {
  return from_rad + share * std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

RunSample between(const RunSample& a, const RunSample& b, double share) {
  const auto mixed = [share](double from, double to) { return from + share * (to - from); };
  RunSample sample = share < 0.5 ? a : b;
  sample.time_s = mixed(a.time_s, b.time_s);
  sample.travel_m = mixed(a.travel_m, b.travel_m);
  sample.p_WB = a.p_WB + share * (b.p_WB - a.p_WB);
  sample.yaw_rad = turned(a.yaw_rad, b.yaw_rad, share);
  sample.pitch_rad = mixed(a.pitch_rad, b.pitch_rad);
  sample.roll_rad = mixed(a.roll_rad, b.roll_rad);
  sample.speed_mps = mixed(a.speed_mps, b.speed_mps);
  sample.steer_rad = mixed(a.steer_rad, b.steer_rad);
  sample.battery_power_w = mixed(a.battery_power_w, b.battery_power_w);
  sample.soc = mixed(a.soc, b.soc);
  sample.hitch_angle_rad = turned(a.hitch_angle_rad, b.hitch_angle_rad, share);
  for (std::size_t i = 0; i < sample.wheel_angle_rad.size(); ++i) {
    sample.wheel_angle_rad[i] = mixed(a.wheel_angle_rad[i], b.wheel_angle_rad[i]);
  }
  return sample;
}

}  // namespace

std::optional<RunSample> sample_at(const RunRecord& run, double time_s) {
  const RunSample* before = nullptr;
  const auto& samples = run.samples;
  const auto after =
      std::upper_bound(samples.begin(), samples.end(), time_s,
                       [](double time, const RunSample& sample) { return time < sample.time_s; });
  for (auto i = after; i != samples.begin() && before == nullptr;) {
    --i;
    if (is_placed(*i)) before = &*i;
  }
  const auto next = std::find_if(after, samples.end(), is_placed);
  if (next == samples.end()) return before == nullptr ? std::nullopt : std::optional(*before);
  if (before == nullptr) return *next;
  return between(*before, *next, (time_s - before->time_s) / (next->time_s - before->time_s));
}

RunRecord run_until(const RunRecord& run, double time_s) {
  RunRecord until = run;
  std::erase_if(until.samples, [&](const RunSample& sample) { return sample.time_s > time_s; });
  std::erase_if(until.footprints,
                [&](const FootprintSample& footprint) { return footprint.time_s > time_s; });
  if (const std::optional<RunSample> now = sample_at(run, time_s)) {
    if (until.samples.empty() || now->time_s > until.samples.back().time_s) {
      until.samples.push_back(*now);
    }
    until.distance_m = now->travel_m;
    until.duration_s = now->time_s;
    until.soc_end = now->soc;
  }
  return until;
}

}  // namespace headland
