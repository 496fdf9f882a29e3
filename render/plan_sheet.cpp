#include "render/plan_sheet.h"

#include <algorithm>
#include <cmath>

#include "render/gl_context.h"
#include "render/text_lines.h"

namespace headland {
namespace {

constexpr double kSheetWidth_px = 2100.0;  // of the panels on a sheet
constexpr double kSheetHeight_px = 2400.0;
constexpr double kGap_px = 40.0;
constexpr Rgba kSheetPaper{255, 255, 255};

// One line of swatches, from `p_px` on.
void write_plan_legend(Sheet& sheet, Typeface& typeface, Eigen::Vector2d p_px, TextStyle style,
                       std::span<const PlanLegendEntry> legend) {
  const double side = 0.9 * style.size_px;
  for (const PlanLegendEntry& entry : legend) {
    const Box swatch{p_px.x(), p_px.y() - side, side, side};
    fill_box(sheet, swatch, entry.colour);
    frame_box(sheet, swatch, 1.0, colours::kInkSoft);
    p_px.x() += side + 0.4 * style.size_px;
    write_text(sheet, typeface, {p_px.x(), p_px.y() - 0.08 * style.size_px}, entry.label, style,
               colours::kInk);
    p_px.x() += text_width_px(typeface, entry.label, style) + 1.3 * style.size_px;
  }
}

double plan_legend_width(Typeface& typeface, TextStyle style,
                         std::span<const PlanLegendEntry> legend) {
  double width = 0.0;
  for (const PlanLegendEntry& entry : legend) {
    width += 2.6 * style.size_px + text_width_px(typeface, entry.label, style);
  }
  return width;
}

Image painted_sheet(const Sheet& sheet, const Typeface& typeface, double width, double height) {
  const Eigen::Vector2i size_px(static_cast<int>(std::ceil(width)),
                                static_cast<int>(std::ceil(height)));
  const GlContext context;
  const GlFrame frame(size_px.x(), size_px.y(), kSheetPaper);
  return frame.draw([&](const Canvas& canvas) { paint(sheet, typeface, canvas); });
}

}  // namespace

Image draw_plan_page(const PlanPanel& panel, const Eigen::Vector2d& panel_px,
                     std::span<const PlanLegendEntry> legend) {
  Typeface typeface(kFontFile, kBoldFontFile);
  const TextStyle body = kPageText;
  const TextStyle title{30, true};
  const double line_px = 1.45 * body.size_px;
  const double left = 3.2 * body.size_px;
  const double right = 1.2 * body.size_px;
  const double width =
      std::max({panel_px.x(), plan_legend_width(typeface, body, legend), 600.0}) + left + right;
  const Eigen::Vector2d corner(left, 2.2 * title.size_px);
  const double room = width - left - right;
  Sheet sheet;
  write_text(sheet, typeface, {left, 1.35 * title.size_px},
             fitted_text(typeface, panel.title, title, room), title, colours::kInk);
  double y = corner.y() + panel_px.y() + 3.2 * body.size_px;
  for (const std::string& text : panel.lines) {
    for (const std::string& line : lines_within(typeface, text, body, room)) {
      write_text(sheet, typeface, {left, y}, line, body, colours::kInk);
      y += line_px;
    }
  }
  y += 0.3 * line_px;
  write_plan_legend(sheet, typeface, {left, y}, body, legend);
  panel.draw(sheet, typeface, corner);
  return painted_sheet(sheet, typeface, width, y + 0.8 * line_px);
}

SheetGrid sheet_grid(int panels, double aspect) {
  // Captions are about so high beside a panel's width.
  constexpr double kPageAspect = 1.4;
  constexpr double kCaptionAspect = 0.3;
  SheetGrid grid;
  grid.columns = std::clamp(
      static_cast<int>(std::lround(std::sqrt(kPageAspect * panels * (aspect + kCaptionAspect)))), 1,
      panels);
  grid.rows = (panels + grid.columns - 1) / grid.columns;
  grid.most_px = {(kSheetWidth_px - kGap_px * (grid.columns - 1)) / grid.columns,
                  kSheetHeight_px / grid.rows};
  return grid;
}

Image draw_plan_sheet(std::string_view heading, const SheetGrid& grid,
                      const Eigen::Vector2d& panel_px, std::span<const PlanPanel> panels,
                      std::span<const PlanLegendEntry> legend) {
  Typeface typeface(kFontFile, kBoldFontFile);
  const TextStyle big{32, true};
  const TextStyle title{24, true};
  const TextStyle body{20, false};
  const double line_px = 1.4 * body.size_px;
  const double panel_width = std::max(panel_px.x(), 380.0);

  // Each row is as high as its longest captions.
  std::vector<std::vector<std::string>> captions;
  std::vector<std::size_t> most(static_cast<std::size_t>(grid.rows), 0);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    std::vector<std::string>& own = captions.emplace_back();
    for (const std::string& text : panels[i].lines) {
      for (std::string& line : lines_within(typeface, text, body, panel_width)) {
        own.push_back(std::move(line));
      }
    }
    std::size_t& longest = most[i / static_cast<std::size_t>(grid.columns)];
    longest = std::max(longest, own.size());
  }

  Sheet sheet;
  double y = kGap_px + big.size_px;
  write_text(sheet, typeface, {kGap_px, y}, heading, big, colours::kInk);
  for (int row = 0; row < grid.rows; ++row) {
    const double top = y + 1.2 * kGap_px + title.size_px;
    for (int column = 0; column < grid.columns; ++column) {
      const auto i = static_cast<std::size_t>(row * grid.columns + column);
      if (i >= panels.size()) break;
      const double x = kGap_px + column * (panel_width + kGap_px);
      write_text(sheet, typeface, {x, top - 0.5 * title.size_px},
                 fitted_text(typeface, panels[i].title, title, panel_width), title, colours::kInk);
      panels[i].draw(sheet, typeface, {x, top});
      double text_y = top + panel_px.y() + 1.5 * body.size_px;
      for (const std::string& line : captions[i]) {
        write_text(sheet, typeface, {x, text_y}, line, body, colours::kInk);
        text_y += line_px;
      }
    }
    y = top + panel_px.y() + static_cast<double>(most[static_cast<std::size_t>(row)]) * line_px +
        0.5 * line_px;
  }
  y += 1.6 * line_px;
  write_plan_legend(sheet, typeface, {kGap_px, y}, body, legend);
  const double panels_width = grid.columns * (panel_width + kGap_px) - kGap_px;
  const double width =
      2.0 * kGap_px + std::max({panels_width, plan_legend_width(typeface, body, legend),
                                1.0 * text_width_px(typeface, heading, big)});
  return painted_sheet(sheet, typeface, width, y + kGap_px);
}

}  // namespace headland
