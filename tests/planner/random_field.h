// Fields of any shape from a seed.
#pragma once

#include <cstdint>

#include "terrains/field.h"

namespace headland {

// Three to fourteen corners, convex or with deep bays, 0.1 to 20 ha, up to eight holes and six
// trees. Checked by check_field, which may throw InputError: holes may touch.
Field random_field(std::uint64_t seed);

}  // namespace headland
