// draw_quantity_map: the way of the run from above, coloured by what it cost or how it went.
#include <algorithm>

#include "render/map_base.h"
#include "render/pictures.h"
#include "render/quantity_legend.h"

namespace headland {

Image draw_quantity_map(const PictureScene& scene, const PictureSize& size, PathQuantity quantity) {
  const Page page = page_of(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const MapView view = map_view(scene, page);
  const WayColours colours = way_colours(scene.run, quantity);

  MapSheets sheets;
  const double spacing_px = scene.vehicle.implement.working_width_m * view.camera.px_per_m;
  const double width_px = std::clamp(0.45 * spacing_px, 1.2, std::max(1.5, page.px(6)));
  draw_way(sheets.map, scene.run, colours, width_px,
           [&](const RunSample& sample) -> std::optional<Eigen::Vector3d> {
             if (!sample.p_WB.allFinite()) return std::nullopt;
             const Eigen::Vector2d p = pixel_of(view.camera, sample.p_WB.head<2>());
             return Eigen::Vector3d(p.x(), p.y(), 0.0);
           });
  draw_arrows(sheets.map, track_line(view, scene), track_arrows(page, colours::kInk));
  draw_field_lines(sheets.map, scene, page, view);
  draw_start_and_end(sheets.map, scene, page, view);

  write_title(
      sheets.margin, typeface, page, scene,
      quantity == PathQuantity::kEnergyPerMetre ? "Energy" : quantity_entry(quantity).title);
  Legend legend{sheets.margin, typeface, page, page.column.y - page.px(4)};
  legend_way(legend, colours);
  legend_field(legend, scene);
  legend_start_and_end(legend, scene);
  legend_relief(legend, scene, view);
  draw_map_frame(sheets.margin, typeface, page, view);

  const GlContext context;
  const MapGround ground(scene, view, {}, {}, colours::kGreyGround);
  return draw_map_page(page, typeface, view, ground, sheets);
}

Image draw_energy_map(const PictureScene& scene, const PictureSize& size) {
  return draw_quantity_map(scene, size, PathQuantity::kEnergyPerMetre);
}

}  // namespace headland
