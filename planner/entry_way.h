// The way from a field's entry to the line that is driven first.
#pragma once

#include <optional>
#include <vector>

#include "planner/line_joining.h"

namespace headland {

struct EntryWay {
  Pose from;  // near the entry, where the hull fits
  std::vector<Arc> arcs;
};

// From the heading that makes it cheapest; none where none fits, with at most `most_nodes` of the
// node budget for a route. The field has an entry, and no rows are worked yet. Throws Cancelled.
std::optional<EntryWay> way_from_entry(LineJoining& joining, std::size_t line, int most_nodes);

// One that need not fit.
EntryWay overrunning_way_from_entry(const LineJoining& joining, std::size_t line);

// Throws PlanInfeasible: no way from the entry leads to the line.
[[noreturn]] void refuse_entry(const LineJoining& joining, std::size_t line);

}  // namespace headland
