// Plans on grid maps drawn cell by cell, as papers on coverage show them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"
#include "terrains/grid_map.h"

namespace headland {

struct GridFigure {
  std::string title;
  std::vector<std::string> lines;  // figures below the map; long ones are broken
  std::vector<GridCell> path;      // empty: no plan
};

// Free cells white, blocked ones black, those visited twice yellow and more often orange, the first
// cell green, the last red; the path from centre to centre with arrows. Steps
// that are taken more than once are drawn beside each other, each on its right. Moves to a cell
// that is no neighbour are thin straight lines. The lower border counts columns from 0 in the west,
// the left one rows from 0 in the south. Throws InputError for missing fonts (names the package).
Image draw_grid_plan(const GridMap& map, const GridFigure& figure);

// Plans on one map side by side at one scale, each with its title above and its figures below.
// `figures` is not empty.
Image draw_grid_sheet(const GridMap& map, std::string_view heading,
                      std::span<const GridFigure> figures);

}  // namespace headland
