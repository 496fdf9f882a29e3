#include "render/grid_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/grid_panel.h"
#include "render/osmesa_context.h"
#include "render/text_lines.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kLongestSide_px = 1200.0;  // of a map alone
constexpr double kSheetWidth_px = 2100.0;   // of the maps on a sheet
constexpr double kSheetHeight_px = 2400.0;
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

struct LegendEntry {
  Rgba colour;
  const char* label = "";
};
constexpr std::array kEntries{
    LegendEntry{colours::kFirstCell, "start"}, LegendEntry{colours::kLastCell, "end"},
    LegendEntry{colours::kCellTwice, "visited twice"},
    LegendEntry{colours::kCellOften, "more often"}, LegendEntry{colours::kBlockedCell, "blocked"}};

// One line of swatches, from `p_px` on.
void write_legend(Sheet& sheet, Typeface& typeface, Point2 p_px, TextStyle style) {
  const double side = 0.9 * style.size_px;
  for (const LegendEntry& entry : kEntries) {
    const Box swatch{p_px.x(), p_px.y() - side, side, side};
    fill_box(sheet, swatch, entry.colour);
    frame_box(sheet, swatch, 1.0, colours::kInkSoft);
    p_px.x() += side + 0.4 * style.size_px;
    write_text(sheet, typeface, {p_px.x(), p_px.y() - 0.08 * style.size_px}, entry.label, style,
               colours::kInk);
    p_px.x() += text_width_px(typeface, entry.label, style) + 1.3 * style.size_px;
  }
}

double legend_width(Typeface& typeface, TextStyle style) {
  double width = 0.0;
  for (const LegendEntry& entry : kEntries) {
    width += 2.6 * style.size_px + text_width_px(typeface, entry.label, style);
  }
  return width;
}

// Whole pixels where cells have several: borders stay sharp.
double cell_size(double room_px, int cells) {
  const double size = std::min(kLargestCell_px, room_px / cells);
  return size >= 2.0 ? std::floor(size) : size;
}

}  // namespace

Image draw_grid_plan(const GridMap& map, const GridFigure& figure) {
  Typeface typeface(kFontFile, kBoldFontFile);
  const TextStyle body{26, false};
  const TextStyle title{30, true};
  const double line_px = 1.45 * body.size_px;
  const double cell_px = cell_size(kLongestSide_px, std::max(map.columns, map.rows));
  const double left = 3.2 * body.size_px;
  const double right = 1.2 * body.size_px;
  const double map_width = map.columns * cell_px;
  const double width = std::max({map_width, legend_width(typeface, body), 600.0}) + left + right;
  const Point2 corner(left, 2.2 * title.size_px);
  const GridPanel panel{map, corner, cell_px};

  Sheet sheet;
  const double room = width - left - right;
  write_text(sheet, typeface, {left, 1.35 * title.size_px},
             fitted_text(typeface, figure.title, title, room), title, colours::kInk);
  double y = corner.y() + map.rows * cell_px + 3.2 * body.size_px;
  for (const std::string& text : figure.lines) {
    for (const std::string& line : lines_within(typeface, text, body, room)) {
      write_text(sheet, typeface, {left, y}, line, body, colours::kInk);
      y += line_px;
    }
  }
  y += 0.3 * line_px;
  write_legend(sheet, typeface, {left, y}, body);

  const OsmesaContext context;
  const GlFrame frame(static_cast<int>(std::ceil(width)),
                      static_cast<int>(std::ceil(y + 0.8 * line_px)), colours::kFreeCell);
  draw_grid_panel(sheet, panel, figure.path);
  write_ticks(sheet, typeface, panel, body);
  paint(sheet, typeface,
        {static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(y + 0.8 * line_px))});
  return frame.read();
}

Image draw_grid_sheet(const GridMap& map, std::string_view heading,
                      std::span<const GridFigure> figures) {
  Typeface typeface(kFontFile, kBoldFontFile);
  const TextStyle big{32, true};
  const TextStyle title{24, true};
  const TextStyle body{20, false};
  const double line_px = 1.4 * body.size_px;
  const double gap = 40.0;
  // As near to a page as whole columns allow; captions are about so high beside a map's width.
  constexpr double kPageAspect = 1.4;
  constexpr double kCaptionAspect = 0.3;
  const double aspect = static_cast<double>(map.rows) / map.columns;
  const int count = static_cast<int>(figures.size());
  const int columns = std::clamp(
      static_cast<int>(std::lround(std::sqrt(kPageAspect * count * (aspect + kCaptionAspect)))), 1,
      count);
  const int rows = (count + columns - 1) / columns;
  const double cell_px =
      std::min(cell_size((kSheetWidth_px - gap * (columns - 1)) / columns, map.columns),
               cell_size(kSheetHeight_px / rows, map.rows));
  const double map_width = map.columns * cell_px;
  const double panel_width = std::max(map_width, 380.0);

  // Each row is as high as its longest captions.
  std::vector<std::vector<std::string>> captions;
  std::vector<std::size_t> most(static_cast<std::size_t>(rows), 0);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::vector<std::string>& own = captions.emplace_back();
    for (const std::string& text : figures[i].lines) {
      for (std::string& line : lines_within(typeface, text, body, panel_width)) {
        own.push_back(std::move(line));
      }
    }
    std::size_t& longest = most[i / static_cast<std::size_t>(columns)];
    longest = std::max(longest, own.size());
  }

  Sheet sheet;
  double y = gap + big.size_px;
  write_text(sheet, typeface, {gap, y}, heading, big, colours::kInk);
  for (int row = 0; row < rows; ++row) {
    const double top = y + 1.2 * gap + title.size_px;
    for (int column = 0; column < columns; ++column) {
      const auto i = static_cast<std::size_t>(row * columns + column);
      if (i >= figures.size()) break;
      const double x = gap + column * (panel_width + gap);
      write_text(sheet, typeface, {x, top - 0.5 * title.size_px},
                 fitted_text(typeface, figures[i].title, title, panel_width), title, colours::kInk);
      draw_grid_panel(sheet, {map, {x, top}, cell_px}, figures[i].path);
      double text_y = top + map.rows * cell_px + 1.5 * body.size_px;
      for (const std::string& line : captions[i]) {
        write_text(sheet, typeface, {x, text_y}, line, body, colours::kInk);
        text_y += line_px;
      }
    }
    y = top + map.rows * cell_px +
        static_cast<double>(most[static_cast<std::size_t>(row)]) * line_px + 0.5 * line_px;
  }
  y += 1.6 * line_px;
  write_legend(sheet, typeface, {gap, y}, body);

  const double panels_width = columns * (panel_width + gap) - gap;
  const int width = static_cast<int>(
      std::ceil(2.0 * gap + std::max({panels_width, legend_width(typeface, body),
                                      1.0 * text_width_px(typeface, heading, big)})));
  const int height = static_cast<int>(std::ceil(y + gap));
  const OsmesaContext context;
  const GlFrame frame(width, height, colours::kFreeCell);
  paint(sheet, typeface, {width, height});
  return frame.read();
}

}  // namespace headland
