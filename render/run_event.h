// Moments of a run worth a picture: the worst slip, the tightest turn, a collision.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {

struct RunEvent {
  double time_s = 0.0;
  std::string title;  // "Worst wheel slip"
  std::string value;  // with unit
};

struct EventEntry {
  std::string_view name;  // as options and files spell it
  std::string_view title;
};
std::span<const EventEntry> run_events();

// None when it did not happen: a run without a collision, a path without turns, no record. Throws
// InputError naming the known events for a name that is none.
std::optional<RunEvent> find_event(const std::string& name, const Path& path, const RunRecord& run);

}  // namespace headland
