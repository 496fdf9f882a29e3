// What searches have shown of ways between the roomy parts of a field.
#pragma once

#include <map>
#include <utility>

#include "planner/roomy_parts.h"

namespace headland {

// So many searches for a way from one part to another in a row are made in vain before they are
// taken to be apart.
inline constexpr int kSearchesBetween = 6;

struct PartWays {
  RoomyParts parts;
  std::map<std::pair<int, int>, int> failed{};  // searches in a row
};

bool are_apart(const PartWays& ways, const Pose& from, const Pose& to);

// Within a part, and where it is not known in which one a pose is, nothing is learned.
void note_search(PartWays& ways, const Pose& from, const Pose& to, bool found);

}  // namespace headland
