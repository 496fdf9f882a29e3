#include "render/video_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "evaluate/duration_text.h"
#include "render/map_base.h"
#include "render/moment_view.h"
#include "render/run_moment.h"
#include "render/world.h"
#include "terrains/input_error.h"

namespace headland {

// Where things stand on a frame.
struct VideoLayout {
  Page page;
  Box chase;
  Box map;
  Box legend;  // of the map, below it
  Box strip;
};

namespace {

using Point2 = Eigen::Vector2d;

constexpr Rgba kStripGround{24, 28, 34};
constexpr Rgba kStripText{236, 238, 240};
constexpr Rgba kStripLabel{166, 176, 186};
constexpr Rgba kStripRail{66, 74, 84};
constexpr Rgba kGauge{86, 180, 233};
constexpr Rgba kCharging{230, 110, 190};

VideoLayout layout_of(const PictureSize& size) {
  constexpr double kChaseShare = 0.62;
  VideoLayout layout;
  Page& page = layout.page;
  page = page_of(size);
  // The strip's letters are to be read on a small video too.
  page.unit_px = std::min(size.width / 1180.0, size.height / 700.0);
  const double strip = std::round(page.px(84));
  const double chase = std::round(kChaseShare * size.width);
  layout.chase = {0.0, 0.0, chase, size.height - strip};
  const double legend = std::round(page.px(34));
  layout.map = {chase, 0.0, size.width - chase, size.height - strip - legend};
  layout.legend = {chase, layout.map.bottom(), layout.map.width, legend};
  layout.strip = {0.0, size.height - strip, static_cast<double>(size.width), strip};
  const double pad = std::round(page.px(10));
  page.main = {layout.map.x + pad, layout.map.y + pad, layout.map.width - 2.0 * pad,
               layout.map.height - 2.0 * pad};
  return layout;
}

double area_m2(const Extent& extent) { return extent.size().prod(); }

// A value with its name above and a bar below, filled by `share`.
struct Gauge {
  std::string_view label;
  std::string value;
  double share = 0.0;
  Rgba colour = kGauge;
};

void draw_gauge(Sheet& sheet, Typeface& typeface, const Page& page, const Box& box,
                const Gauge& gauge) {
  write_text(sheet, typeface, {box.x, box.y + page.px(24)}, gauge.label, page.text(15),
             kStripLabel);
  write_text(sheet, typeface, {box.x, box.y + page.px(52)}, gauge.value, page.text(23, true),
             kStripText);
  const Box rail{box.x, std::round(box.y + page.px(63)), box.width, std::round(page.px(7))};
  fill_box(sheet, rail, kStripRail);
  fill_box(sheet, {rail.x, rail.y, rail.width * std::clamp(gauge.share, 0.0, 1.0), rail.height},
           gauge.colour);
}

// What the map's colours say, side by side.
void draw_coverage_key(Sheet& sheet, Typeface& typeface, const Page& page, const Box& box) {
  constexpr std::array<std::pair<const char*, Rgba>, 4> kClasses = {
      {{"once", colours::kOnce},
       {"twice", colours::kTwice},
       {"3+ times", colours::kThrice},
       {"not yet", colours::kUnworked}}};
  fill_box(sheet, box, colours::kPaper);
  const double side = std::round(page.px(15));
  const double step = box.width / kClasses.size();
  for (std::size_t i = 0; i < kClasses.size(); ++i) {
    const Box swatch{std::round(box.x + page.px(12) + static_cast<double>(i) * step),
                     std::round(box.y + 0.5 * (box.height - side)), side, side};
    fill_box(sheet, swatch, kClasses[i].second);
    frame_box(sheet, swatch, std::max(1.0, page.px(1)), colours::kInkSoft);
    write_text(sheet, typeface, {swatch.right() + page.px(6), swatch.bottom() - page.px(2)},
               kClasses[i].first, page.text(16), colours::kInk);
  }
}

}  // namespace

struct VideoPainter::State {
  State(const PictureScene& whole, const VideoFrameOptions& wanted)
      : scene(whole),
        options(wanted),
        layout(layout_of(wanted.size)),
        typeface(kFontFile, kBoldFontFile),
        map(map_view(whole, layout.page)),
        ground(whole, map, {}, map_look(), colours::kGround, kMovingGround_px),
        // Frame D of all frames, wherever the machine is.
        world(whole, {last_pose(whole.run)->p_WB.z(), 1.0}, moment_sun()),
        frame(wanted.size.width, wanted.size.height, colours::kPaper) {
    const Extent field = extent_of(whole.field.boundary);
    constexpr double kMostCells = 6e5;
    const double cell_m = std::max(wanted.cell_m, std::sqrt(area_m2(field) / kMostCells));
    worked = start_coverage(whole.field, whole.run.footprints, wanted.working_width_m, cell_m);
    shown.emplace(coverage_classes(worked.raster, true));
    for (const RunSample& sample : whole.run.samples) {
      most_mps = std::max(most_mps, std::abs(sample.speed_mps));
      most_w = std::max(most_w, sample.battery_power_w);
    }
    draw_field_lines(lines, whole, layout.page, map);
    draw_scale_bar(
        lines, typeface, layout.page, map.camera.px_per_m, layout.page.px(110),
        {layout.page.main.x + layout.page.px(4), layout.map.bottom() - layout.page.px(36)});
    draw_north_arrow(lines, typeface, layout.page,
                     {layout.map.right() - layout.page.px(26), layout.page.px(44)}, {0.0, -1.0});
  }

  static SurfaceLook map_look() {
    SurfaceLook look;
    look.once = colours::kOnce;
    look.twice = colours::kTwice;
    look.thrice = colours::kThrice;
    look.missed = colours::kUnworked;
    return look;
  }

  // Takes what happened until then from the run.
  void go_to(double time_s) {
    const RunRecord& run = scene.run;
    for (; samples < run.samples.size() && run.samples[samples].time_s <= time_s; ++samples) {
      if (!run.samples[samples].p_WB.allFinite()) continue;
      const Point2 p = pixel_of(map.camera, run.samples[samples].p_WB.head<2>());
      if (way.empty() || (p - way.back()).norm() > 0.7) way.push_back(p);
    }
    std::size_t past = worked.added;
    while (past < run.footprints.size() && run.footprints[past].time_s <= time_s) ++past;
    if (past == worked.added) return;
    grow_coverage(worked, run.footprints, past);
    shown.emplace(coverage_classes(worked.raster, true));
  }

  void draw_strip(Sheet& sheet, const RunSample& now) {
    const Page& page = layout.page;
    const Box& strip = layout.strip;
    fill_box(sheet, strip, kStripGround);
    const double duration_s = std::max(scene.run.samples.back().time_s, 1e-9);
    const double power_kw = now.battery_power_w / 1e3;
    const std::array<Gauge, 4> gauges = {
        {{"Time", duration_text(now.time_s), now.time_s / duration_s, {180, 186, 192}},
         {"Speed", fmt::format("{:.2f} m/s", now.speed_mps),
          std::abs(now.speed_mps) / std::max(most_mps, 1e-9)},
         {power_kw < 0.0 ? "Charging" : "Power", fmt::format("{:.2f} kW", std::abs(power_kw)),
          std::abs(now.battery_power_w) / std::max(most_w, 1e-9),
          power_kw < 0.0 ? kCharging : Rgba{230, 159, 0}},
         {"Battery", fmt::format("{:.1f} %", 100.0 * now.soc), now.soc, {0, 158, 115}}}};
    const double gap = page.px(30);
    const double width = (strip.width - page.px(150) - gap * 5.0) / 4.0;
    for (std::size_t i = 0; i < gauges.size(); ++i) {
      draw_gauge(
          sheet, typeface, page,
          {std::round(gap + static_cast<double>(i) * (width + gap)), strip.y, width, strip.height},
          gauges[i]);
    }
    const double right = strip.right() - gap;
    write_text(sheet, typeface, {right, strip.y + page.px(24)}, "Shown", page.text(15), kStripLabel,
               Align::kRight);
    write_text(sheet, typeface, {right, strip.y + page.px(52)},
               fmt::format("{:.3g}x", options.speed), page.text(23, true), kStripText,
               Align::kRight);
    write_text(sheet, typeface, {right, strip.y + page.px(72)},
               now.implement_down ? "implement down" : "implement up", page.text(14), kStripLabel,
               Align::kRight);
  }

  Image draw(double time_s) {
    go_to(time_s);
    const RunSample now = sample_at(scene.run, time_s).value();
    const FieldView view =
        chase_view(scene, now, trailing_heading_rad(scene.run, time_s), layout.chase, world.relief);
    const Shot shot(world, view, Surroundings::kSky, &now);
    const Sheet world_lines = moment_lines(scene, view, now, nullptr, 0.7 * layout.page.unit_px);

    Sheet map_lines;
    stroke(map_lines, way, std::max(1.0, layout.page.px(1.4)), colours::kDriven);
    map_lines.vertices.insert(map_lines.vertices.end(), lines.vertices.begin(),
                              lines.vertices.end());
    mark_vehicle(map_lines, layout.page, pixel_of(map.camera, now.p_WB.head<2>()), now.yaw_rad);
    Sheet strip;
    draw_strip(strip, now);
    draw_coverage_key(strip, typeface, layout.page, layout.legend);
    fill_box(strip, {layout.map.x - 1.0, 0.0, 2.0, layout.strip.y}, kStripGround);
    return frame.draw([&](const Canvas& canvas) {
      paint_world(canvas, typeface, world, shot, *shown, world_lines);
      look_through(map.camera.view_px, canvas);
      paint_surface(canvas, ground.surface, ground.clip, *shown, ground.look);
      look_through(layout.map, canvas);
      paint(map_lines, typeface, canvas);
      look_at_page();
      paint(strip, typeface, canvas);
    });
  }

  const PictureScene& scene;
  VideoFrameOptions options;
  VideoLayout layout;
  Typeface typeface;
  GlContext context;
  MapView map;
  MapGround ground;
  World world;
  GlFrame frame;
  Sheet lines;  // of the map, the same in every frame
  double most_mps = 0.0;
  double most_w = 0.0;
  std::size_t samples = 0;  // that are past
  std::vector<Point2> way;
  GrowingCoverage worked;                // by footprints that are past
  std::optional<SurfaceCoverage> shown;  // the same on the graphics side
};

VideoPainter::VideoPainter(const PictureScene& scene, const VideoFrameOptions& options) {
  if (last_pose(scene.run) == nullptr) {
    throw InputError("video", "", "", "the run has no samples to be shown");
  }
  state_ = std::make_unique<State>(scene, options);
}
VideoPainter::~VideoPainter() = default;

Image VideoPainter::draw(double time_s) { return state_->draw(time_s); }

}  // namespace headland
