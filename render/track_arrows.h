// Which way a line on a picture is driven.
#pragma once

#include <span>

#include "render/sheet.h"

namespace headland {

struct ArrowLook {
  double spacing_px = 90.0;  // along the line
  double size_px = 9.0;      // length of a head
  Rgba colour;
  Rgba rim{255, 255, 255};
};

// Arrow heads along the line through the points, which may have depths (render/sheet.h).
void draw_arrows(Sheet& sheet, std::span<const Eigen::Vector3d> line_px, const ArrowLook& look);

}  // namespace headland
