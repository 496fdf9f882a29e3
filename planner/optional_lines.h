// Optional lines, driven as far as turns lead to them.
#pragma once

#include <vector>

#include "planner/line_driving.h"
#include "planner/roomy_parts.h"

namespace headland {

// Appends lines, all optional, in their order to what is driven. Those that could not be come to
// wait until the vehicle has come on; one from which nothing leads on waits likewise, and is left
// out when it happens again. Where lines are left over, finishing each part before it is left is
// tried as well, and the longer of both kept. Where nothing is driven yet it is begun in the part
// that the field is entered in, that the first line which is not optional begins in, or that most
// is to be driven in. Names the others in Path::left_out. Throws Cancelled.
void drive_optional(LineDriving& driving, const RoomyParts& parts,
                    const std::vector<std::size_t>& lines);

// Appends a line that no turn leads to where one does once as few as possible of the last lines
// driven, all of them optional and no more than kMostTakenBack, are left out. False, and nothing
// changed, where that does not help. Throws Cancelled.
bool drive_leaving_out(LineDriving& driving, std::size_t next);
inline constexpr std::size_t kMostTakenBack = 6;

}  // namespace headland
