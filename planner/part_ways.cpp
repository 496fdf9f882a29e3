#include "planner/part_ways.h"

namespace headland {

bool are_apart(const PartWays& ways, int from_part, int to_part) {
  const auto known = ways.failed.find({from_part, to_part});
  return known != ways.failed.end() && known->second >= kSearchesBetween;
}

void note_search(PartWays& ways, int from_part, int to_part, bool found) {
  if (from_part == kNoPart || to_part == kNoPart || from_part == to_part) return;
  int& failed = ways.failed[{from_part, to_part}];
  failed = found ? 0 : failed + 1;
}

}  // namespace headland
