#include "apps/close_ups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "apps/render_view.h"
#include "apps/stages.h"
#include "evaluate/duration_text.h"
#include "render/moment_view.h"
#include "render/run_event.h"

namespace headland {
namespace {

constexpr PictureSize kCloseUp{800, 500};

// The event that a judged figure is about.
struct JudgedEvent {
  std::string_view figure;
  std::string_view event;
};
constexpr std::array<JudgedEvent, 7> kJudgedEvents = {
    {{"slip_max", "worst_slip"},
     {"load_transfer_max", "load_transfer"},
     {"track_error_m_max", "tracking"},
     {"track_rms_working_m_max", "tracking"},
     {"boundary_overrun_m_max", "boundary_overrun"},
     {"belly_contact_m_max", "belly_contact"},
     {"outcome", "end"}}};
constexpr std::array<std::string_view, 3> kAlwaysShown = {"worst_slip", "tightest_turn",
                                                          "load_transfer"};

std::vector<std::string> wanted_events(const nlohmann::ordered_json& metrics,
                                       const RunRecord& run) {
  std::vector<std::string> events;
  const auto add = [&](std::string_view event) {
    if (std::find(events.begin(), events.end(), event) == events.end()) {
      events.emplace_back(event);
    }
  };
  if (run.outcome == Outcome::kHitObstacle) add("collision");
  const auto reasons = nlohmann::ordered_json::json_pointer("/verdict/reasons");
  if (metrics.is_object() && metrics.contains(reasons) && metrics[reasons].is_array()) {
    for (const auto& reason : metrics[reasons]) {
      if (!reason.is_object() || !reason.contains("figure")) continue;
      for (const JudgedEvent& judged : kJudgedEvents) {
        if (reason["figure"] == judged.figure) add(judged.event);
      }
    }
  }
  for (const std::string_view event : kAlwaysShown) add(event);
  return events;
}

}  // namespace

std::vector<PagePicture> close_ups(const Job& job, const RecordedRun& recorded) {
  std::vector<PagePicture> pictures;
  std::vector<double> shown_s;
  for (const std::string& name : wanted_events(recorded.metrics, recorded.run)) {
    if (pictures.size() == kMostCloseUps) break;
    const std::optional<RunEvent> event = find_event(name, recorded.path, recorded.run);
    constexpr double kSameMoment_s = 1.0;
    if (!event || std::any_of(shown_s.begin(), shown_s.end(), [&](double time_s) {
          return std::abs(time_s - event->time_s) < kSameMoment_s;
        })) {
      continue;
    }
    const MomentScene until(job, recorded, event->time_s);
    if (last_pose(until.run) == nullptr) continue;
    shown_s.push_back(event->time_s);
    const std::string title =
        fmt::format("{} ({}), after {}", event->title, event->value, duration_text(event->time_s));
    const MomentOptions options{MomentCamera::kCloseUp, event->title, event->value, {}};
    pictures.push_back({fmt::format("close_up_{}.png", name), title,
                        title + ": the machine on the ground it has worked until then, and where "
                                "in the field that is",
                        draw_moment(until.scene, kCloseUp, options)});
  }
  return pictures;
}

}  // namespace headland
