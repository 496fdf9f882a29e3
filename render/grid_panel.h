// A grid map with a plan on it, as one part of a picture.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/sheet.h"
#include "terrains/grid_map.h"

namespace headland {

// Where a map stands on the page.
struct GridPanel {
  const GridMap& map;
  Eigen::Vector2d corner_px;  // upper left
  double cell_px = 1.0;
};

Box cell_box(const GridPanel& panel, const GridCell& cell, int cells = 1);
Eigen::Vector2d cell_centre_px(const GridPanel& panel, const GridCell& cell);

// The map with the path on it, which may be empty; see grid_picture.h.
void draw_grid_panel(Sheet& sheet, const GridPanel& panel, const std::vector<GridCell>& path);

namespace colours {
inline constexpr Rgba kFreeCell{255, 255, 255};
inline constexpr Rgba kBlockedCell{24, 24, 24};
inline constexpr Rgba kCellTwice{255, 222, 74};
inline constexpr Rgba kCellOften{245, 150, 40};
inline constexpr Rgba kFirstCell{46, 160, 67};
inline constexpr Rgba kLastCell{214, 39, 40};
inline constexpr Rgba kCellLine{214, 216, 218};
inline constexpr Rgba kGridPath{22, 60, 132};
inline constexpr Rgba kGridJump{190, 40, 160, 150};
}  // namespace colours

}  // namespace headland
