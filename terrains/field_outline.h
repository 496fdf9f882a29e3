// Outlines with fewer points.
#pragma once

#include <vector>

#include "terrains/field.h"

namespace headland {

// Leaves out points of boundary and holes that they keep their shape without: what is left out lies
// within `tolerance_m` of the lines that remain (Douglas and Peucker 1973). Rings still neither
// cross nor touch: where they would, they keep more points.
void simplify_outline(Field& field, double tolerance_m);

// The same for rough outlines: what remains lies in the field, everywhere within 2 `tolerance_m` of
// its edge. False, and the field as it was, where that would cut it apart or change its holes'
// number.
bool simplify_outline_inside(Field& field, double tolerance_m);

// The same of a line, whose ends stay.
std::vector<Eigen::Vector2d> simplified_line(const std::vector<Eigen::Vector2d>& points_W,
                                             double tolerance_m);

}  // namespace headland
