// A field divided into parts with a plan on it, as one piece of a picture.
#pragma once

#include <Eigen/Geometry>

#include "render/region_picture.h"
#include "render/sheet.h"

namespace headland {

// Where a field stands on the page: its ground, start and end lie in the panel.
struct RegionPanel {
  const RegionGround& ground;
  Eigen::AlignedBox2d box_W;
  Eigen::Vector2d corner_px;  // upper left
  double px_per_m = 1.0;
};

// What is to be seen: the ground, start and end, with a margin.
Eigen::AlignedBox2d seen_box(const RegionGround& ground);

Eigen::Vector2d place_px(const RegionPanel& panel, const Eigen::Vector2d& p_W);

void draw_region_panel(Sheet& sheet, Typeface& typeface, const RegionPanel& panel,
                       const std::vector<DrawnVisit>& visits);

namespace colours {
inline constexpr Rgba kSweepLine{38, 70, 150};
inline constexpr Rgba kPartLink{190, 40, 140};
inline constexpr Rgba kHoleGround{150, 150, 146};
inline constexpr Rgba kDroppedPart{236, 236, 234};
inline constexpr Rgba kPlanStart{20, 140, 70};
inline constexpr Rgba kPlanEnd{206, 32, 38};
}  // namespace colours

}  // namespace headland
