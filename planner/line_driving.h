// Lines driven one after the other, as far as turns lead.
#pragma once

#include <cstddef>
#include <vector>

#include "planner/driven_lines.h"
#include "planner/part_ways.h"

namespace headland {

// The roomy parts that a line begins and ends in.
struct LineParts {
  int begin = kNoPart;
  int end = kNoPart;
};

struct LineDriving {
  LineJoining& joining;
  std::vector<DrivenLine> driven{};
  // Of every line, as it lies and the other way round, where there are optional lines.
  std::vector<LineParts> parts{};
  std::vector<LineParts> other_parts{};
  PartWays ways{};
  std::vector<char> turned{};  // lines that lie the other way round by now
};

// Nothing driven yet.
LineDriving begin_driving(LineJoining& joining, const RoomyParts* parts);

void turn_round(LineDriving& driving, std::size_t line);

// Appends a line if a turn leads to it, the other way round if that helps; the first one if there
// is no entry or a way leads from there. Throws Cancelled.
bool drive_next(LineDriving& driving, std::size_t next);

// Appends a line that no turn leads to.
void drive_regardless(LineDriving& driving, std::size_t next);

// Whether what is known rules a line out as the next, either way round.
bool is_apart(const LineDriving& driving, int from_part, std::size_t next);

}  // namespace headland
