// Outlines with no more points than planning needs.
#pragma once

#include "planner/polygon.h"
#include "terrains/field.h"

namespace headland {

// Planned ground reaches at most this far [m] beyond the field's real boundary and holes, or stays
// as far inside.
inline constexpr double kOutlineTolerance_m = 0.01;

// The field with the points of boundary and holes left out that it keeps its shape without, to
// within kOutlineTolerance_m: surveyed boundaries have points every few centimetres, and their
// number tells in everything that follows. Rings still neither cross nor touch. Throws InputError
// where GEOS cannot work with the rings.
Field simplified(const Field& field);

}  // namespace headland
