#include "render/region_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/page.h"
#include "render/plan_sheet.h"
#include "render/region_panel.h"

namespace headland {
namespace {

constexpr std::array kRegionEntries{PlanLegendEntry{colours::kPlanStart, "start"},
                                    PlanLegendEntry{colours::kPlanEnd, "end"},
                                    PlanLegendEntry{colours::kSweepLine, "sweeps"},
                                    PlanLegendEntry{colours::kPartLink, "between parts"},
                                    PlanLegendEntry{colours::kDroppedPart, "not worked"},
                                    PlanLegendEntry{colours::kHoleGround, "hole"}};

// Below the panel, with its length.
void draw_scale(Sheet& sheet, Typeface& typeface, const RegionPanel& panel) {
  constexpr double kWanted_px = 200.0;
  const double length_m = round_down_to_125(kWanted_px / panel.px_per_m);
  const Eigen::Vector2d left =
      panel.corner_px +
      Eigen::Vector2d(0.0, panel.px_per_m * panel.box_W.sizes().y() + 0.9 * kPageText.size_px);
  const double width = length_m * panel.px_per_m;
  fill_box(sheet, {left.x(), left.y(), width, 4.0}, colours::kInk);
  write_text(sheet, typeface, {left.x() + width + 0.5 * kPageText.size_px, left.y() + 10.0},
             fmt::format("{:g} m", length_m), kPageText, colours::kInk);
}

}  // namespace

Image draw_region_plan(const RegionGround& ground, const RegionFigure& figure) {
  const Eigen::AlignedBox2d box_W = seen_box(ground);
  const double px_per_m = kPanelAlone_px / box_W.sizes().maxCoeff();
  const auto draw = [&](Sheet& sheet, Typeface& typeface, const Eigen::Vector2d& corner_px) {
    const RegionPanel panel{ground, box_W, corner_px, px_per_m};
    draw_region_panel(sheet, typeface, panel, figure.visits);
    draw_scale(sheet, typeface, panel);
  };
  return draw_plan_page({figure.title, figure.lines, draw}, px_per_m * box_W.sizes(),
                        kRegionEntries);
}

Image draw_region_sheet(const RegionGround& ground, std::string_view heading,
                        std::span<const RegionFigure> figures) {
  const Eigen::AlignedBox2d box_W = seen_box(ground);
  const Eigen::Vector2d size_m = box_W.sizes();
  const SheetGrid grid = sheet_grid(static_cast<int>(figures.size()), size_m.y() / size_m.x());
  const double px_per_m = std::min({grid.most_px.x() / size_m.x(), grid.most_px.y() / size_m.y(),
                                    kPanelAlone_px / size_m.maxCoeff()});
  std::vector<PlanPanel> panels;
  for (const RegionFigure& figure : figures) {
    panels.push_back(
        {figure.title, figure.lines,
         [&](Sheet& sheet, Typeface& typeface, const Eigen::Vector2d& corner_px) {
           draw_region_panel(sheet, typeface, {ground, box_W, corner_px, px_per_m}, figure.visits);
         }});
  }
  return draw_plan_sheet(heading, grid, px_per_m * size_m, panels, kRegionEntries);
}

}  // namespace headland
