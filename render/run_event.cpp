#include "render/run_event.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "terrains/input_error.h"

namespace headland {
namespace {

using Found = std::optional<RunEvent>;

struct Event {
  EventEntry entry;
  Found (*find)(const Path&, const RunRecord&) = nullptr;
};

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

// Where `value` of a sample is largest; none when it never is above `least`.
template <typename Value, typename Text>
Found largest(const RunRecord& run, double least, Value value, Text text) {
  const RunSample* most = nullptr;
  for (const RunSample& sample : run.samples) {
    if (!sample.p_WB.allFinite() || !(value(sample) > least)) continue;
    if (most == nullptr || value(sample) > value(*most)) most = &sample;
  }
  if (most == nullptr) return std::nullopt;
  return RunEvent{most->time_s, "", text(value(*most))};
}

Found of_peak(const Peak& peak, const std::string& text) {
  if (!(std::abs(peak.value) > 0.0)) return std::nullopt;
  return RunEvent{peak.time_s, "", text};
}

Found worst_slip(const Path&, const RunRecord& run) {
  return of_peak(run.peaks.slip,
                 fmt::format("{:.0f} % over half a second", 100.0 * run.peaks.slip.value));
}

Found load_transfer(const Path&, const RunRecord& run) {
  const Peak& peak = run.peaks.load_transfer_ratio;
  return of_peak(
      peak, fmt::format("{:.0f} % of the load shifted to one side{}", 100.0 * std::abs(peak.value),
                        run.peaks.load_transfer_of_trailer ? " of the implement" : ""));
}

// Driven, not planned: where the wheels were steered most on a turn.
Found tightest_turn(const Path& path, const RunRecord& run) {
  const auto turns = [&](const RunSample& sample) {
    const auto i = static_cast<std::size_t>(sample.segment);
    if (sample.segment < 0 || i >= path.segments.size()) return false;
    const PathKind kind = path.segments[i].kind;
    return kind == PathKind::kTurn || kind == PathKind::kUTurn;
  };
  return largest(
      run, 0.0,
      [&](const RunSample& sample) { return turns(sample) ? std::abs(sample.steer_rad) : 0.0; },
      [](double steer_rad) { return fmt::format("steered by {:.1f}°", degrees(steer_rad)); });
}

Found collision(const Path&, const RunRecord& run) {
  if (run.outcome != Outcome::kHitObstacle || run.samples.empty()) return std::nullopt;
  return RunEvent{run.samples.back().time_s, "", run.outcome_detail};
}

Found tracking(const Path&, const RunRecord& run) {
  const Peak& working = run.peaks.cross_track_working_m;
  const Peak& turning = run.peaks.cross_track_turning_m;
  const bool worked = std::abs(working.value) >= std::abs(turning.value);
  const Peak& peak = worked ? working : turning;
  return of_peak(peak, fmt::format("{:.0f} cm {} the path", 100.0 * std::abs(peak.value),
                                   peak.value < 0.0 ? "right of" : "left of"));
}

Found steepest(const Path&, const RunRecord& run) {
  return largest(
      run, 0.0,
      [](const RunSample& sample) {
        return std::hypot(std::tan(sample.pitch_rad), std::tan(sample.roll_rad));
      },
      [](double slope) { return fmt::format("{:.0f} % slope", 100.0 * slope); });
}

Found power(const Path&, const RunRecord& run) {
  return of_peak(run.peaks.battery_power_w,
                 fmt::format("{:.2f} kW from the battery", run.peaks.battery_power_w.value / 1e3));
}

Found boundary_overrun(const Path&, const RunRecord& run) {
  const Peak& peak = run.peaks.boundary_overrun_m;
  return of_peak(peak,
                 fmt::format("{:.2f} m {}", peak.value,
                             run.peaks.overrun_in_hole ? "into a hole" : "beyond the boundary"));
}

Found belly_contact(const Path&, const RunRecord& run) {
  const Peak& peak = run.peaks.belly_contact_m;
  return of_peak(peak, fmt::format("{:.0f} mm into the ground", 1e3 * peak.value));
}

Found end(const Path&, const RunRecord& run) {
  if (run.samples.empty()) return std::nullopt;
  return RunEvent{run.samples.back().time_s, "", std::string(outcome_name(run.outcome))};
}

constexpr std::array<Event, 10> kEvents = {{
    {{"worst_slip", "Worst wheel slip"}, worst_slip},
    {{"load_transfer", "Largest load transfer"}, load_transfer},
    {{"tightest_turn", "Tightest turn"}, tightest_turn},
    {{"tracking", "Largest tracking error"}, tracking},
    {{"steepest", "Steepest place"}, steepest},
    {{"power", "Largest power"}, power},
    {{"boundary_overrun", "Farthest over the boundary"}, boundary_overrun},
    {{"belly_contact", "Deepest contact of the belly"}, belly_contact},
    {{"collision", "Collision"}, collision},
    {{"end", "End of the run"}, end},
}};

}  // namespace

std::span<const EventEntry> run_events() {
  static const std::array<EventEntry, kEvents.size()> entries = [] {
    std::array<EventEntry, kEvents.size()> all;
    std::transform(kEvents.begin(), kEvents.end(), all.begin(),
                   [](const Event& event) { return event.entry; });
    return all;
  }();
  return entries;
}

std::optional<RunEvent> find_event(const std::string& name, const Path& path,
                                   const RunRecord& run) {
  std::vector<std::string> known;
  for (const Event& event : kEvents) {
    known.emplace_back(event.entry.name);
    if (event.entry.name != name) continue;
    Found found = event.find(path, run);
    if (found && !std::isfinite(found->time_s)) return std::nullopt;
    if (found) found->title = event.entry.title;
    return found;
  }
  throw InputError("--view", "event", name, unknown_name("event", name, known));
}

}  // namespace headland
