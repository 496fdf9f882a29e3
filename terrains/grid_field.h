// The field that a grid map stands for.
#pragma once

#include <vector>

#include "terrains/field.h"
#include "terrains/grid_map.h"

namespace headland {

// Free ground of `margin_m` around the map, on which vehicles may drive and nothing is worked; 0:
// the map's edge is the field's.
inline constexpr double kMaxGridMargin_m = 1000.0;

// The ground that can be reached from the map's first free cell. Blocked cells are holes or, at the
// edge of a map without a margin, beyond the boundary; what is to be worked (Field::to_work) are
// the free cells. Where two of them touch at a corner alone, rings are drawn kCornerGap_m apart
// there. The map has a free cell; throws InputError(source, "margin_m") for a margin out of range.
Field field_of_grid(const GridMap& map, double margin_m, const std::string& source);

// Outlines of the free cells in W as they are: outer rings counter-clockwise, rings around what is
// blocked clockwise.
std::vector<Ring> free_outlines(const GridMap& map);

inline constexpr double kCornerGap_m = 0.004;

}  // namespace headland
