// Outlines with fewer points.
#pragma once

#include <vector>

#include "terrains/field.h"

namespace headland {

// Leaves out points of boundary and holes that they keep their shape without: what is left out lies
// within `tolerance_m` of the lines that remain (Douglas and Peucker 1973). Rings still neither
// cross nor touch: where they would, they keep more points.
void simplify_outline(Field& field, double tolerance_m);

// The same of a line, whose ends stay.
std::vector<Eigen::Vector2d> simplified_line(const std::vector<Eigen::Vector2d>& points_W,
                                             double tolerance_m);

}  // namespace headland
