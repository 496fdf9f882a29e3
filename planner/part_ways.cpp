#include "planner/part_ways.h"

namespace headland {

bool are_apart(const PartWays& ways, const Pose& from, const Pose& to) {
  const auto known = ways.failed.find(std::pair(ways.parts.at(from), ways.parts.at(to)));
  return known != ways.failed.end() && known->second >= kSearchesBetween;
}

void note_search(PartWays& ways, const Pose& from, const Pose& to, bool found) {
  const std::pair parts(ways.parts.at(from), ways.parts.at(to));
  if (parts.first < 0 || parts.second < 0 || parts.first == parts.second) return;
  int& failed = ways.failed[parts];
  failed = found ? 0 : failed + 1;
}

}  // namespace headland
