#include "render/quantity_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace headland {
namespace {

std::string value_text(double value, double span) {
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 3);
  return fmt::format("{:.{}f}", value, decimals);
}

// Upright bar with round ticks.
void legend_scale(Legend& legend, const WayColours& colours, double units) {
  const Page& page = legend.page;
  const double low = colours.scale.low;
  const double high = colours.scale.high;
  legend_gap(legend, 12);
  const Box bar{page.column.x, std::round(legend.y_px), std::round(page.px(28)),
                std::round(page.px(units))};
  const int rows = static_cast<int>(bar.height);
  for (int row = 0; row < rows; ++row) {
    const double value = high - (high - low) * (row + 0.5) / rows;
    fill_box(legend.sheet, {bar.x, bar.y + row, bar.width, 1.0},
             quantity_colour(colours.scale, value));
  }
  const double line = std::max(1.0, std::round(page.px(1)));
  frame_box(legend.sheet, bar, line, colours::kInk);
  const double ticks = units > 150.0 ? 5.0 : 3.0;
  const double step = round_down_to_125(1.6 * (high - low) / ticks);
  const TextStyle style = page.text(14);
  // Whole steps, so that zero is exactly zero.
  for (auto k = static_cast<long>(std::ceil(low / step)); static_cast<double>(k) * step <= high;
       ++k) {
    const double value = static_cast<double>(k) * step;
    const double y = std::round(bar.y + bar.height * (high - value) / (high - low));
    fill_box(legend.sheet, {bar.right(), y, page.px(6), line}, colours::kInk);
    write_text(legend.sheet, legend.typeface, {bar.right() + page.px(12), y + page.px(5)},
               fmt::format("{:g}", value), style, colours::kInk);
  }
  if (colours.scale.below_zero && low < 0.0) {
    const double side = bar.right() + page.px(86);
    write_text(legend.sheet, legend.typeface, {side, bar.bottom() - page.px(4)}, "regenerated",
               page.text(13), colours::kInkSoft);
    write_text(legend.sheet, legend.typeface, {side, bar.y + page.px(14)}, "used", page.text(13),
               colours::kInkSoft);
  }
  legend.y_px = bar.bottom();
  legend_gap(legend, 16);
}

}  // namespace

WayColours way_colours(const RunRecord& run, PathQuantity quantity) {
  WayColours colours;
  colours.quantity = quantity;
  colours.values = quantity_along(run.samples, quantity);
  colours.scale = quantity_scale(run.samples, colours.values, quantity);
  return colours;
}

void draw_way(Sheet& sheet, const RunRecord& run, const WayColours& colours, double width_px,
              const std::function<std::optional<Eigen::Vector3d>(const RunSample&)>& place) {
  const double step_px = std::max(0.5, 0.4 * width_px);
  std::optional<Eigen::Vector3d> from;
  double value_from = 0.0;
  for (std::size_t i = 0; i < colours.values.size(); ++i) {
    const std::optional<Eigen::Vector3d> to = place(run.samples[i]);
    const bool near = from && to && (*to - *from).head<2>().norm() < step_px;
    if (near && i + 1 < colours.values.size()) continue;
    const double value = 0.5 * (value_from + colours.values[i]);
    if (from && to && std::isfinite(value)) {
      stroke(sheet, std::array{*from, *to}, width_px, quantity_colour(colours.scale, value));
    }
    from = to;
    value_from = colours.values[i];
  }
}

void legend_way(Legend& legend, const WayColours& colours, double scale_units) {
  const QuantityEntry& entry = quantity_entry(colours.quantity);
  legend_heading(legend, fmt::format("{} [{}]", entry.title, entry.unit));
  if (colours.values.empty()) {
    legend_note(legend, "Nothing was driven.");
    legend_gap(legend, 16);
    return;
  }
  legend_scale(legend, colours, scale_units);
  legend_heading(legend, fmt::format("Figures [{}]", entry.unit));
  const double span = colours.scale.high - colours.scale.low;
  const auto figure = [&](std::string_view label, double value) {
    legend_swatch(legend, quantity_colour(colours.scale, value), label, value_text(value, span));
  };
  figure("Largest", colours.scale.most);
  figure("Median", colours.scale.median);
  figure("Smallest", colours.scale.least);
  legend_note(legend, entry.note);
  if (colours.quantity != PathQuantity::kSoc) {
    legend_note(legend, "The scale ends where 2 % of the way lies beyond.");
  }
  legend_gap(legend, 10);
}

void draw_lying_scale(Sheet& sheet, Typeface& typeface, const Page& page, const WayColours& colours,
                      const Box& box_px) {
  const QuantityEntry& entry = quantity_entry(colours.quantity);
  const TextStyle style = page.text(14);
  const double line = std::max(1.0, std::round(page.px(1)));
  const Box bar{box_px.x, std::round(box_px.bottom() - page.px(41)), box_px.width,
                std::round(page.px(12))};
  write_text(sheet, typeface, {bar.x, bar.y - page.px(8)},
             fmt::format("{} [{}]", entry.title, entry.unit), style, colours::kPaper);
  const int columns = static_cast<int>(bar.width);
  const double low = colours.scale.low;
  const double high = colours.scale.high;
  for (int column = 0; column < columns; ++column) {
    const double value = low + (high - low) * (column + 0.5) / columns;
    fill_box(sheet, {bar.x + column, bar.y, 1.0, bar.height},
             quantity_colour(colours.scale, value));
  }
  frame_box(sheet, bar, line, colours::kPaper);
  const double base = bar.bottom() + page.px(16);
  write_text(sheet, typeface, {bar.x, base}, value_text(low, high - low), style, colours::kPaper);
  write_text(sheet, typeface, {bar.right(), base}, value_text(high, high - low), style,
             colours::kPaper, Align::kRight);
}

}  // namespace headland
