#include "render/grid_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

#include "render/grid_panel.h"
#include "render/plan_sheet.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kLargestCell_px = 60.0;

// Numbers of columns below and of rows left of the map.
void write_ticks(Sheet& sheet, Typeface& typeface, const GridPanel& panel, TextStyle style) {
  const double wanted_px = 4.0 * style.size_px;
  int every = 5;
  while (every * panel.cell_px < wanted_px) every *= 2;
  const double below = panel.corner_px.y() + panel.map.rows * panel.cell_px + 1.4 * style.size_px;
  for (int column = 0; column < panel.map.columns; column += every) {
    write_text(sheet, typeface, {cell_centre_px(panel, {column, 0}).x(), below},
               fmt::format("{}", column), style, colours::kInk, Align::kCentre);
  }
  for (int row = 0; row < panel.map.rows; row += every) {
    const double y = cell_centre_px(panel, {0, row}).y() + 0.36 * style.size_px;
    write_text(sheet, typeface, {panel.corner_px.x() - 0.5 * style.size_px, y},
               fmt::format("{}", row), style, colours::kInk, Align::kRight);
  }
}

// Jumps, which sound plans do not have, where there are any.
std::vector<PlanLegendEntry> legend_of(std::span<const GridFigure> figures) {
  std::vector<PlanLegendEntry> legend = {{colours::kFirstCell, "start"},
                                         {colours::kLastCell, "end"},
                                         {colours::kCellTwice, "visited twice"},
                                         {colours::kCellOften, "more often"},
                                         {colours::kBlockedCell, "blocked"}};
  const auto jumps = [](const GridCell& from, const GridCell& to) {
    return std::abs(from.column - to.column) + std::abs(from.row - to.row) > 1;
  };
  if (std::any_of(figures.begin(), figures.end(), [&](const GridFigure& figure) {
        return std::adjacent_find(figure.path.begin(), figure.path.end(), jumps) !=
               figure.path.end();
      })) {
    legend.push_back({colours::kGridJump, "jump, not to be driven"});
  }
  return legend;
}

// Whole pixels where cells have several: borders stay sharp.
double cell_size(double room_px, int cells) {
  const double size = std::min(kLargestCell_px, room_px / cells);
  return size >= 2.0 ? std::floor(size) : size;
}

}  // namespace

Image draw_grid_plan(const GridMap& map, const GridFigure& figure) {
  const double cell_px = cell_size(kPanelAlone_px, std::max(map.columns, map.rows));
  const auto draw = [&](Sheet& sheet, Typeface& typeface, const Point2& corner_px) {
    const GridPanel panel{map, corner_px, cell_px};
    draw_grid_panel(sheet, panel, figure.path);
    write_ticks(sheet, typeface, panel, kPageText);
  };
  return draw_plan_page({figure.title, figure.lines, draw},
                        {map.columns * cell_px, map.rows * cell_px},
                        legend_of(std::span(&figure, 1)));
}

Image draw_grid_sheet(const GridMap& map, std::string_view heading,
                      std::span<const GridFigure> figures) {
  const SheetGrid grid =
      sheet_grid(static_cast<int>(figures.size()), static_cast<double>(map.rows) / map.columns);
  const double cell_px =
      std::min(cell_size(grid.most_px.x(), map.columns), cell_size(grid.most_px.y(), map.rows));
  std::vector<PlanPanel> panels;
  for (const GridFigure& figure : figures) {
    panels.push_back(
        {figure.title, figure.lines, [&](Sheet& sheet, Typeface&, const Point2& corner_px) {
           draw_grid_panel(sheet, {map, corner_px, cell_px}, figure.path);
         }});
  }
  return draw_plan_sheet(heading, grid, {map.columns * cell_px, map.rows * cell_px}, panels,
                         legend_of(figures));
}

}  // namespace headland
