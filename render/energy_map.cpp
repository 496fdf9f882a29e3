// draw_energy_map: where the battery's energy goes, from above.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/energy_profile.h"
#include "render/map_base.h"
#include "render/pictures.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kWindow_m = 4.0;

Rgba colour_of(double wh_per_m, const EnergyFigures& figures) {
  return energy_colour(wh_per_m < 0.0 ? wh_per_m / std::abs(figures.scale_low_wh_per_m)
                                      : wh_per_m / figures.scale_high_wh_per_m);
}

void draw_track(Sheet& sheet, const PictureScene& scene, const Page& page, const MapView& view,
                const std::vector<double>& profile, const EnergyFigures& figures) {
  const double spacing_px = scene.vehicle.implement.working_width_m * view.camera.px_per_m;
  const double width_px = std::clamp(0.45 * spacing_px, 1.2, std::max(1.5, page.px(6)));
  const auto& samples = scene.run.samples;
  const double step_px = std::max(0.5, 0.4 * width_px);
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Point2 a = pixel_of(view.camera, samples[from].p_WB.head<2>());
    const Point2 b = pixel_of(view.camera, samples[i].p_WB.head<2>());
    if ((b - a).norm() < step_px && i + 1 < samples.size()) continue;
    const double wh_per_m = 0.5 * (profile[from] + profile[i]);
    if (std::isfinite(wh_per_m)) {
      stroke(sheet, std::array{a, b}, width_px, colour_of(wh_per_m, figures));
    }
    from = i;
  }
}

// Upright bar with round ticks.
void legend_scale(Legend& legend, const EnergyFigures& figures) {
  const Page& page = legend.page;
  const double low = figures.scale_low_wh_per_m;
  const double high = figures.scale_high_wh_per_m;
  legend_gap(legend, 12);
  const Box bar{page.column.x, std::round(legend.y_px), std::round(page.px(28)),
                std::round(page.px(230))};
  const int rows = static_cast<int>(bar.height);
  for (int row = 0; row < rows; ++row) {
    const double value = high - (high - low) * (row + 0.5) / rows;
    fill_box(legend.sheet, {bar.x, bar.y + row, bar.width, 1.0}, colour_of(value, figures));
  }
  const double line = std::max(1.0, std::round(page.px(1)));
  frame_box(legend.sheet, bar, line, colours::kInk);
  constexpr double kTicks = 5.0;
  const double step = round_down_to_125(1.6 * (high - low) / kTicks);
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
  const double side = bar.right() + page.px(86);
  if (low < 0.0) {
    write_text(legend.sheet, legend.typeface, {side, bar.bottom() - page.px(4)}, "regenerated",
               page.text(13), colours::kInkSoft);
    write_text(legend.sheet, legend.typeface, {side, bar.y + page.px(14)}, "used", page.text(13),
               colours::kInkSoft);
  }
  legend.y_px = bar.bottom();
  legend_gap(legend, 16);
}

void legend_energy(Legend& legend, const std::vector<double>& profile,
                   const EnergyFigures& figures) {
  legend_heading(legend, "Battery energy per metre [Wh/m]");
  if (profile.empty()) {
    legend_note(legend, "Nothing was driven.");
    legend_gap(legend, 16);
    return;
  }
  legend_scale(legend, figures);
  legend_heading(legend, "Figures [Wh/m]");
  const auto figure = [&](std::string_view label, double value) {
    legend_swatch(legend, colour_of(value, figures), label, fmt::format("{:.3f}", value));
  };
  figure("Largest", figures.max_wh_per_m);
  figure("Median", figures.median_wh_per_m);
  figure("Smallest", figures.min_wh_per_m);
  legend_note(legend, fmt::format("Means over {:g} m of travel at the battery's terminals. The "
                                  "scale ends where 2 % of the way lies beyond.",
                                  kWindow_m));
  legend_gap(legend, 10);
}

}  // namespace

Image draw_energy_map(const PictureScene& scene, const PictureSize& size) {
  const Page page = page_of(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const OsmesaContext context;
  const GlFrame frame(size.width, size.height, colours::kPaper);
  const MapView view = map_view(scene, page);
  paint_map_ground(scene, page, view, {}, {}, colours::kGreyGround);

  const std::vector<double> profile = energy_per_metre_wh(scene.run.samples, kWindow_m);
  const EnergyFigures figures =
      profile.empty() ? EnergyFigures{} : energy_figures(scene.run.samples, profile);
  Sheet map;
  if (!profile.empty()) draw_track(map, scene, page, view, profile, figures);
  draw_field_lines(map, scene, page, view);
  draw_start_and_end(map, scene, page, view);
  look_through(view.camera.view_px, size.height);
  paint(map, typeface, page.size_px);
  look_at_page();

  Sheet margin;
  write_title(margin, typeface, page, scene, "Energy");
  Legend legend{margin, typeface, page, page.column.y - page.px(4)};
  legend_energy(legend, profile, figures);
  legend_field(legend, scene);
  legend_start_and_end(legend, scene);
  legend_gap(legend, 10);
  legend_relief(legend, view);
  draw_map_frame(margin, typeface, page, view);
  paint(margin, typeface, page.size_px);
  return frame.read();
}

}  // namespace headland
