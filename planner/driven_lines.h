// Which work lines are driven one after the other, and by which turns.
#pragma once

#include <optional>
#include <vector>

#include "planner/line_joining.h"

namespace headland {

// A line that is driven, and how it is come to from the one before, or, as the first one, from the
// field's entry if there is one; without arcs no turn fits.
struct DrivenLine {
  std::size_t line = 0;
  std::optional<std::vector<Arc>> arcs{};
  std::optional<Pose> entry{};  // where the arcs of the first one begin
};

// Lines in their order, at least one; optional ones as far as turns lead to them, the others named
// in Path::left_out. Lines that are driven the other way round are turned. Throws PlanInfeasible
// where no turn leads to a line that is not optional, or from the entry to none that may be begun
// with, and overruns are not allowed; Cancelled.
std::vector<DrivenLine> lines_to_drive(LineJoining& joining);

}  // namespace headland
