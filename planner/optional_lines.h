// Optional lines, driven as far as turns lead to them.
#pragma once

#include <vector>

#include "planner/line_driving.h"
#include "planner/roomy_parts.h"

namespace headland {

// Appends lines, all optional, in their order to what is driven. Those that could not be come to
// wait until the vehicle has come on; one from which nothing leads on waits likewise, and is left
// out when it happens again. Where nothing is driven yet it is begun in the part that the field is
// entered in, or that most is to be driven in. Names the others in Path::left_out. Throws
// Cancelled.
void drive_optional(LineDriving& driving, const RoomyParts& parts,
                    const std::vector<std::size_t>& lines);

// Takes the last line driven back and names it in Path::left_out.
void leave_last_out(LineDriving& driving);

}  // namespace headland
