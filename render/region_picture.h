// Plans of the order of a field's parts: parts, order, sweeps and the ways between them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planner/polygon.h"
#include "render/image.h"

namespace headland {

// What all plans of a field have in common.
struct RegionGround {
  PolygonPart ground;
  std::vector<Ring> parts_W;
  std::vector<Ring> dropped_W;  // pieces that are not worked
  std::optional<Eigen::Vector2d> start_W;
  std::optional<Eigen::Vector2d> end_W;
};

// A part in the order it is worked, and the line along which.
struct DrawnVisit {
  int part = 0;
  Polyline way_W;
};

struct RegionFigure {
  std::string title;
  std::vector<std::string> lines;  // figures below; long ones are broken
  std::vector<DrawnVisit> visits;  // empty: no plan
};

// Parts in light colours with their number in the order, sweeps as lines, the ways between parts
// dashed, the first place green, the last red; pieces not worked hatched, with a scale bar when
// alone. Throws InputError for missing fonts (names the package).
Image draw_region_plan(const RegionGround& ground, const RegionFigure& figure);

// Plans of one field side by side at one scale. `figures` is not empty.
Image draw_region_sheet(const RegionGround& ground, std::string_view heading,
                        std::span<const RegionFigure> figures);

}  // namespace headland
