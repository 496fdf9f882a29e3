// Heights for the part of a grid that has none.
#pragma once

#include <vector>

#include "terrains/heightfield.h"

namespace headland {

// Gives every node that is not `known` (1 or 0 a node) the height of about the nearest known node:
// two sweeps of vector propagation (Danielsson 1980), whose distance errs by less than a cell.
// Asserts that at least one node is known.
void carry_heights_outwards(const std::vector<unsigned char>& known, Heightfield& terrain);

}  // namespace headland
