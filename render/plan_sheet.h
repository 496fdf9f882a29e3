// Pages with one plan, or with several side by side: titles, captions, one legend.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"
#include "render/sheet.h"

namespace headland {

// One plan. All those of a sheet have a panel of the same size.
struct PlanPanel {
  std::string title;
  std::vector<std::string> lines;  // below; long ones are broken
  std::function<void(Sheet&, Typeface&, const Eigen::Vector2d& corner_px)> draw;
};

struct PlanLegendEntry {
  Rgba colour;
  std::string_view label;
};

// What a panel alone on a page may take, either way.
inline constexpr double kPanelAlone_px = 1200.0;

// The panel may draw beside and below itself too, within 3 and 2 letters of kPageText.
Image draw_plan_page(const PlanPanel& panel, const Eigen::Vector2d& panel_px,
                     std::span<const PlanLegendEntry> legend);
inline constexpr TextStyle kPageText{26, false};

// As near to a page as whole columns allow, for panels of that height / width, and what a panel may
// take.
struct SheetGrid {
  int columns = 1;
  int rows = 1;
  Eigen::Vector2d most_px = Eigen::Vector2d::Zero();
};
SheetGrid sheet_grid(int panels, double aspect);

// `panels` is not empty.
Image draw_plan_sheet(std::string_view heading, const SheetGrid& grid,
                      const Eigen::Vector2d& panel_px, std::span<const PlanPanel> panels,
                      std::span<const PlanLegendEntry> legend);

}  // namespace headland
