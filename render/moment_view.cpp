#include "render/moment_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "evaluate/duration_text.h"
#include "render/map_base.h"
#include "render/text_lines.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

constexpr Rgba kStrip{24, 28, 34, 255};
constexpr Rgba kStripInk{236, 238, 240};
constexpr Rgba kStripSoft{176, 184, 192};
constexpr Rgba kPlate{252, 252, 250, 232};
constexpr double kReach_m = 60.0;  // of lines on the ground around the machine

std::optional<Point3> pixel_on_ground(const PictureScene& scene, const FieldView& view,
                                      const Point2& p_W) {
  constexpr double kLift_m = 0.04;
  const Point3 p_D = on_ground(scene.terrain, view.relief, p_W) + Point3(0.0, 0.0, kLift_m);
  const Point3 pixel = pixel_of(view.camera, p_D);
  return pixel.z() > -1.0 && pixel.z() < 1.0 ? std::optional(pixel) : std::nullopt;
}

// Strokes and arrows of a line in W, broken where it is out of sight.
void draw_line(Sheet& lines, const PictureScene& scene, const FieldView& view,
               const std::vector<Point2>& line_W, double width_px, Rgba colour, double unit_px) {
  std::vector<Point3> run;
  const auto flush = [&] {
    stroke(lines, thinned(run, 1.0), width_px, colour);
    draw_arrows(lines, run, {90.0 * unit_px, 14.0 * unit_px, colour, colours::kInk});
    run.clear();
  };
  for (const Point2& p_W : line_W) {
    if (const auto pixel = pixel_on_ground(scene, view, p_W)) {
      run.push_back(*pixel);
    } else {
      flush();
    }
  }
  flush();
}

void draw_inset(Sheet& sheet, const PictureScene& scene, const Page& page, const RunSample& sample,
                const Box& box) {
  fill_box(sheet, box, kPlate);
  const double pad = page.px(12);
  const Box room{box.x + pad, box.y + pad, box.width - 2.0 * pad, box.height - 2.0 * pad};
  const Extent field = extent_of(scene.field.boundary);
  const double px_per_m = std::min(room.width / field.size().x(), room.height / field.size().y());
  const MapCamera camera{room,
                         {field.centre() - 0.5 * Point2(room.width, room.height) / px_per_m,
                          field.centre() + 0.5 * Point2(room.width, room.height) / px_per_m},
                         px_per_m};
  const auto ring = [&](const Ring& points_W, Rgba fill) {
    std::vector<Point2> line;
    for (const Point2& p_W : points_W) line.push_back(pixel_of(camera, p_W));
    if (fill.a > 0) hatch(sheet, std::span(&line, 1), page.px(5), page.px(1), fill);
    stroke(sheet, line, std::max(1.0, page.px(1.6)), colours::kBoundary, true);
  };
  std::vector<Point3> way;
  for (const RunSample& past : scene.run.samples) {
    if (!past.p_WB.allFinite()) continue;
    const Point2 p = pixel_of(camera, past.p_WB.head<2>());
    way.emplace_back(p.x(), p.y(), 0.0);
  }
  stroke(sheet, thinned(way, 1.0), std::max(1.0, page.px(1.4)), {112, 84, 60});
  ring(scene.field.boundary, {0, 0, 0, 0});
  for (const Ring& hole : scene.field.holes) ring(hole, colours::kInkSoft);
  const Point2 here = pixel_of(camera, sample.p_WB.head<2>());
  fill_disc(sheet, here, page.px(8), colours::kPaper);
  fill_disc(sheet, here, page.px(6), colours::kEnd);
  frame_box(sheet, box, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
}

std::string figures_text(const RunSample& sample) {
  std::string text =
      fmt::format("{}  ·  {:.2f} m/s  ·  {:.2f} kW  ·  battery {:.0f} %  ·  slip {:.0f} %",
                  duration_text(sample.time_s), sample.speed_mps, sample.battery_power_w / 1e3,
                  100.0 * sample.soc, 100.0 * sample.slip);
  return text + (sample.implement_down ? "  ·  implement down" : "  ·  implement up");
}

// The colours of the ground, one after the other, ending at the right edge.
void draw_ground_legend(Sheet& sheet, Typeface& typeface, const Page& page, double right_px,
                        double base_px) {
  const std::array<std::pair<Rgba, std::string_view>, 4> entries = {
      {{colours::kWorked, "worked once"},
       {colours::kWorkedTwice, "twice"},
       {colours::kWorkedThrice, "more"},
       {colours::kUnworked, "to be worked"}}};
  const TextStyle style = page.text(14);
  double x = right_px;
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    write_text(sheet, typeface, {x, base_px}, entry->second, style, kStripSoft, Align::kRight);
    x -= text_width_px(typeface, entry->second, style) + page.px(26);
    const Box swatch{std::round(x), std::round(base_px - page.px(12)), std::round(page.px(20)),
                     std::round(page.px(14))};
    fill_box(sheet, swatch, entry->first);
    frame_box(sheet, swatch, 1.0, kStripSoft);
    x -= page.px(16);
  }
}

}  // namespace

Eigen::Vector3f moment_sun() { return Eigen::Vector3f(-0.62F, -0.55F, 0.72F).normalized(); }

std::vector<Point2> planned_ahead(const PictureScene& scene, const RunSample& sample) {
  std::vector<Point2> line;
  const Point2 here = sample.p_WB.head<2>();
  const auto& samples = scene.run.samples;
  const auto entered = std::find_if(samples.begin(), samples.end(), [&](const RunSample& past) {
    return past.segment == sample.segment;
  });
  const double driven_m = entered == samples.end() ? 0.0 : sample.travel_m - entered->travel_m;
  double left_m = 0.6 * kReach_m;
  for (auto i = static_cast<std::size_t>(std::max(sample.segment, 0));
       i < scene.path.segments.size() && left_m > 0.0; ++i) {
    const auto& points = scene.path.segments[i].points;
    auto from = points.begin();
    if (line.empty()) {
      // A pass around the field comes back to where it began: how far the vehicle drove on it tells
      // the two ends apart.
      constexpr double kWeight = 0.2;
      double least = std::numeric_limits<double>::infinity();
      double along_m = 0.0;
      for (auto point = points.begin(); point != points.end(); ++point) {
        if (point != points.begin()) along_m += (point->p_W - std::prev(point)->p_W).norm();
        const double cost = (point->p_W - here).norm() + kWeight * std::abs(along_m - driven_m);
        if (cost < least) {
          least = cost;
          from = point;
        }
      }
    }
    for (; from != points.end() && left_m > 0.0; ++from) {
      if (!line.empty()) left_m -= (from->p_W - line.back()).norm();
      line.push_back(from->p_W);
    }
  }
  return line;
}

Sheet moment_lines(const PictureScene& scene, const FieldView& view, const RunSample& sample,
                   const WayColours* colours, double unit_px) {
  Sheet lines;
  draw_boundaries(lines, scene, view, std::max(1.0, 2.5 * unit_px));
  constexpr Rgba kAhead{255, 255, 255, 235};
  draw_line(lines, scene, view, planned_ahead(scene, sample), std::max(1.0, 2.2 * unit_px), kAhead,
            unit_px);
  if (colours != nullptr) {
    const Point2 here = sample.p_WB.head<2>();
    draw_way(lines, scene.run, *colours, 7.0 * unit_px, [&](const RunSample& past) {
      const Point2 p_W = past.p_WB.head<2>();
      return past.p_WB.allFinite() && (p_W - here).norm() < 2.0 * kReach_m
                 ? pixel_on_ground(scene, view, p_W)
                 : std::nullopt;
    });
  }
  return lines;
}

Image draw_moment(const PictureScene& scene, const PictureSize& size,
                  const MomentOptions& options) {
  Page page = page_of(size);
  const RunSample* sample = last_pose(scene.run);
  if (sample == nullptr) throw InputError("picture", "", "", "the run has no moment to be drawn");
  const double strip = std::round(page.px(options.overlay ? 92 : 76));
  page.main = {0.0, 0.0, static_cast<double>(size.width), size.height - strip};
  Typeface typeface(kFontFile, kBoldFontFile);
  const FieldView view =
      options.camera == MomentCamera::kChase
          ? chase_view(scene, *sample, trailing_heading_rad(scene.run, sample->time_s), page.main)
          : close_up(scene, *sample, page.main);

  std::optional<WayColours> colours;
  if (options.overlay) colours = way_colours(scene.run, *options.overlay);
  const Sheet lines =
      moment_lines(scene, view, *sample, colours ? &*colours : nullptr, page.unit_px);

  Sheet margin;
  const double pad = page.px(20);
  const Box inset{size.width - page.px(300) - pad, pad, page.px(300), page.px(220)};
  draw_inset(margin, scene, page, *sample, inset);
  // On a plate as the map is, whatever the ground is like there.
  const Box plate{pad, pad, page.px(80), page.px(80)};
  fill_box(margin, plate, kPlate);
  frame_box(margin, plate, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
  draw_north_arrow(margin, typeface, page,
                   {plate.x + 0.5 * plate.width, plate.y + 0.5 * plate.height},
                   {-std::cos(view.heading_rad), -std::sin(view.heading_rad)});
  fill_box(margin, {0.0, page.main.bottom(), page.main.width, strip}, kStrip);
  const TextStyle bold = page.text(20, true);
  const TextStyle plain = page.text(17);
  const std::string title = options.title.empty() ? scene.field.name : options.title;
  const double base = page.main.bottom() + page.px(31);
  const double right = size.width - pad;
  const double scale_px = colours && !colours->values.empty() ? page.px(380) : 0.0;
  const double room = right - pad - (scale_px > 0.0 ? scale_px + pad : 0.0);
  const std::string shown = fitted_text(typeface, title, bold, 0.5 * room);
  write_text(margin, typeface, {pad, base}, shown, bold, kStripInk);
  const double value_x = pad + text_width_px(typeface, shown, bold) + page.px(14);
  write_text(margin, typeface, {value_x, base},
             fitted_text(typeface, options.value, plain, room - value_x), plain, kStripInk);
  write_text(margin, typeface, {pad, base + page.px(28)},
             fitted_text(typeface, figures_text(*sample), page.text(16), room), page.text(16),
             kStripSoft);
  if (scale_px > 0.0) {
    draw_lying_scale(margin, typeface, page, *colours,
                     {right - scale_px, page.main.bottom(), scale_px, strip});
  } else {
    draw_ground_legend(margin, typeface, page, right, base + page.px(28));
  }

  const GlContext context;
  const World world(scene, view.relief, moment_sun());
  const Shot shot(world, view, Surroundings::kSky, sample);
  const SurfaceCoverage coverage(coverage_classes(scene.coverage, true));
  const GlFrame frame(size.width, size.height, colours::kPaper);
  return frame.draw([&](const Canvas& canvas) {
    paint_world(canvas, typeface, world, shot, coverage, lines);
    paint(margin, typeface, canvas);
  });
}

}  // namespace headland
