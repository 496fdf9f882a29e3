// draw_view: the field in perspective, with the machine in its place and from close by.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "evaluate/duration_text.h"
#include "render/pictures.h"
#include "render/quantity_legend.h"
#include "render/world.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

// Ring around the vehicle in the whole view and a line from there to the close-up.
void draw_pointer(Sheet& sheet, const Page& page, const FieldView& view, const Vehicle& vehicle,
                  const RunSample& sample, const Box& close_up_px) {
  const Body& body = vehicle.body;
  const Point3 middle =
      pose_in_D(sample, view.relief) *
      Point3(0.5 * body.length_m - body.rear_overhang_m, 0.0, 0.5 * body.height_m);
  const Point2 centre = pixel_of(view.camera, middle).head<2>();
  const double px_per_m = view.camera.focal_px / (middle - view.camera.eye_D).norm();
  const double radius = std::max(page.px(15), 0.75 * body.length_m * px_per_m);
  constexpr int kCorners = 40;
  std::vector<Point2> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    ring.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  const Point2 to(close_up_px.x, std::clamp(centre.y(), close_up_px.y, close_up_px.bottom()));
  const Point2 from = centre + radius * (to - centre).normalized();
  const std::array<Point2, 2> line = {from, to};
  stroke(sheet, ring, page.px(4.5), colours::kPaper, true);
  stroke(sheet, line, page.px(4.0), colours::kPaper);
  stroke(sheet, ring, std::max(1.0, page.px(2)), colours::kEnd, true);
  stroke(sheet, line, std::max(1.0, page.px(1.5)), colours::kEnd);
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

void legend_end(Legend& legend, const PictureScene& scene, const RunSample& sample) {
  legend_heading(legend, scene.moment_s ? "The vehicle after " + duration_text(sample.time_s)
                                        : std::string("The vehicle where it ended"));
  legend_note(
      legend,
      fmt::format("After {:.2f} km, battery at {:.0f} %, nose {:.1f}° {}, {:.1f}° "
                  "down to the {}, implement {}.",
                  sample.travel_m / 1000.0, 100.0 * sample.soc, std::abs(degrees(sample.pitch_rad)),
                  sample.pitch_rad < 0.0 ? "down" : "up", std::abs(degrees(sample.roll_rad)),
                  sample.roll_rad < 0.0 ? "left" : "right", sample.implement_down ? "down" : "up"));
  if (!scene.run.outcome_detail.empty() && !scene.moment_s) {
    legend_note(legend, scene.run.outcome_detail);
  }
  const std::string note = body_mesh(scene.vehicle).note;
  if (!note.empty()) legend_note(legend, "Body: " + note + ".");
  legend_gap(legend, 12);
}

void legend_ground(Legend& legend) {
  legend_heading(legend, "Ground");
  legend_swatch(legend, colours::kWorked, "Worked once", "");
  legend_swatch(legend, colours::kWorkedTwice, "Worked twice", "");
  legend_swatch(legend, colours::kWorkedThrice, "Worked three times or more", "");
  legend_swatch(legend, colours::kUnworked, "In the field, not worked", "");
  legend_swatch(legend, colours::kMeadow, "Outside the field, and holes", "");
  legend_gap(legend, 12);
}

void legend_scale(Legend& legend, const PictureScene& scene, const FieldView& view) {
  legend_heading(legend, "Scale");
  const Extent field = extent_of(scene.field.boundary);
  const HeightRange heights = height_range(scene.terrain, overlap(field, extent_of(scene.terrain)));
  legend_note(legend,
              fmt::format("The field reaches {:.0f} m from west to east and {:.0f} m from "
                          "south to north, over {:.1f} m of height.",
                          field.size().x(), field.size().y(), heights.high_m - heights.low_m));
  legend_note(legend, view.relief.exaggeration > 1.0
                          ? fmt::format("Heights of the ground are drawn {:g} times larger.",
                                        view.relief.exaggeration)
                          : "Heights are drawn to the same scale as lengths.");
}

void draw_north(Sheet& sheet, Typeface& typeface, const Page& page, const FieldView& view) {
  const Point2 middle = view.block.centre();
  const double step_m = 0.05 * view.block.size().maxCoeff();
  const Point3 here = pixel_of(view.camera, {middle.x(), middle.y(), 0.0});
  const Point3 north = pixel_of(view.camera, {middle.x(), middle.y() + step_m, 0.0});
  draw_north_arrow(sheet, typeface, page,
                   {page.column.right() - page.px(24), page.column.bottom() - page.px(34)},
                   (north - here).head<2>());
}

// The driven way, coloured, a little above the ground.
void draw_coloured_way(Sheet& lines, const PictureScene& scene, const FieldView& view,
                       const WayColours& colours, double width_px) {
  const double lift_m = 0.002 * view.block.size().maxCoeff();
  draw_way(
      lines, scene.run, colours, width_px, [&](const RunSample& sample) -> std::optional<Point3> {
        if (!sample.p_WB.allFinite()) return std::nullopt;
        const Point3 p_D =
            on_ground(scene.terrain, view.relief, sample.p_WB.head<2>()) + Point3(0.0, 0.0, lift_m);
        const Point3 pixel = pixel_of(view.camera, p_D);
        return pixel.z() > -1.0 && pixel.z() < 1.0 ? std::optional(pixel) : std::nullopt;
      });
}

}  // namespace

Image draw_view(const PictureScene& scene, const PictureSize& size, const ViewOptions& options) {
  const Page page = view_page(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const FieldView view = field_view(scene, page, options.exaggeration);
  const RunSample* sample = last_pose(scene.run);
  // The scale of an overlay needs more of the column than the colours of the ground.
  const double inset_aspect = options.overlay ? 0.52 : 0.72;
  const Box inset{page.column.x, page.column.y, page.column.width,
                  std::round(inset_aspect * page.column.width)};

  Sheet margin;
  write_title(margin, typeface, page, scene, "View");
  Legend legend{margin, typeface, page, page.column.y - page.px(4)};
  Sheet lines;
  draw_boundaries(lines, scene, view, std::max(1.2, page.px(2.0)));
  if (sample != nullptr) {
    draw_pointer(margin, page, view, scene.vehicle, *sample, inset);
    frame_box(margin, inset, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
    legend.y_px = inset.bottom() + page.px(6);
    legend_end(legend, scene, *sample);
  }
  if (options.overlay) {
    const WayColours colours = way_colours(scene.run, *options.overlay);
    draw_coloured_way(lines, scene, view, colours, std::max(1.5, page.px(3.0)));
    constexpr double kShortScale = 110.0;
    legend_way(legend, colours, kShortScale);
  } else {
    legend_ground(legend);
  }
  legend_scale(legend, scene, view);
  draw_north(margin, typeface, page, view);

  const GlContext context;
  const SurfaceCoverage coverage(coverage_classes(scene.coverage, true));
  const World field(scene, view.relief, sun_for(view.heading_rad));
  const Shot whole(field, view, Surroundings::kBlock, sample);
  std::optional<World> around;
  std::optional<Shot> near;
  Sheet near_lines;
  if (sample != nullptr) {
    const FieldView close = close_up(scene, *sample, inset);
    around.emplace(scene, close.relief, sun_for(close.heading_rad));
    near.emplace(*around, close, Surroundings::kSky, sample);
    draw_boundaries(near_lines, scene, close, page.px(2.0));
  }
  const GlFrame frame(size.width, size.height, colours::kPaper);
  return frame.draw([&](const Canvas& canvas) {
    paint_world(canvas, typeface, field, whole, coverage, lines);
    if (near) paint_world(canvas, typeface, *around, *near, coverage, near_lines);
    paint(margin, typeface, canvas);
  });
}

}  // namespace headland
