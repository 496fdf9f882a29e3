#include "planner/driven_lines.h"

#include <algorithm>
#include <utility>

#include "planner/entry_way.h"
#include "planner/line_driving.h"
#include "planner/optional_lines.h"
#include "planner/roomy_parts.h"

namespace headland {

std::vector<DrivenLine> lines_to_drive(LineJoining& joining) {
  std::optional<RoomyParts> parts;
  if (std::ranges::any_of(joining.lines, &WorkLine::optional)) {
    parts = roomy_parts(joining.space, joining.options.clearance_m);
  }
  LineDriving driving = begin_driving(joining, parts ? &*parts : nullptr);
  std::vector<DrivenLine>& driven = driving.driven;
  for (std::size_t next = 0; next < joining.lines.size();) {
    stop_if(joining.cancelled);
    std::vector<std::size_t> optional;
    for (; next < joining.lines.size() && joining.lines[next].optional; ++next) {
      optional.push_back(next);
    }
    if (!optional.empty()) drive_optional(driving, *parts, optional);
    if (next == joining.lines.size()) break;
    if (!drive_next(driving, next) && !drive_leaving_out(driving, next)) {
      if (!joining.options.allow_overrun) {
        if (driven.empty()) refuse_entry(joining, next);
        refuse_connection(joining, driven.back().line, next);
      }
      drive_regardless(driving, next);
    }
    ++next;
  }
  if (driven.empty()) refuse_entry(joining, 0);
  return std::move(driven);
}

}  // namespace headland
