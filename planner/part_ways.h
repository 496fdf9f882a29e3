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
  std::map<std::pair<int, int>, int> failed{};  // searches in a row, from one part to another
};

bool are_apart(const PartWays& ways, int from_part, int to_part);

// Within a part, and of kNoPart, nothing is learned.
void note_search(PartWays& ways, int from_part, int to_part, bool found);

}  // namespace headland
