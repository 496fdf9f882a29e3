// draw_elevation: the ground along the way, from the side.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluate/duration_text.h"
#include "render/map_base.h"
#include "render/pictures.h"
#include "render/quantity_legend.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

constexpr Rgba kEarth{196, 180, 156};
constexpr Rgba kTopsoil{140, 108, 78};
constexpr Rgba kPassBand{92, 132, 74};
constexpr Rgba kTurnBand{226, 120, 196};
constexpr Rgba kTransitBand{170, 176, 182};

struct ProfilePoint {
  double travel_m = 0.0;
  double height_m = 0.0;
  int segment = 0;
};

std::vector<ProfilePoint> profile_of(const PictureScene& scene) {
  std::vector<ProfilePoint> points;
  for (const RunSample& sample : scene.run.samples) {
    if (!sample.p_WB.allFinite()) continue;
    points.push_back({sample.travel_m,
                      surface_at(scene.terrain, sample.p_WB.x(), sample.p_WB.y()).height_m,
                      sample.segment});
  }
  if (!points.empty()) return points;
  double travel_m = 0.0;
  Point2 last = Point2::Zero();
  for (std::size_t i = 0; i < scene.path.segments.size(); ++i) {
    for (const PathPoint& point : scene.path.segments[i].points) {
      if (!points.empty()) travel_m += (point.p_W - last).norm();
      last = point.p_W;
      points.push_back(
          {travel_m, surface_at(scene.terrain, last.x(), last.y()).height_m, static_cast<int>(i)});
    }
  }
  return points;
}

// Where distances and heights are drawn.
struct Axes {
  Box box;
  double low_m = 0.0;  // height at the lower edge
  double px_per_m = 1.0;
  double exaggeration = 1.0;
  Point2 pixel(double travel_m, double height_m) const {
    return {box.x + px_per_m * travel_m,
            box.bottom() - px_per_m * exaggeration * (height_m - low_m)};
  }
};

Axes axes_for(const std::vector<ProfilePoint>& profile, const Page& page,
              std::optional<double> exaggeration) {
  Axes axes;
  const double left = std::round(page.px(46));
  const double below = std::round(page.px(78));
  axes.box = {page.main.x + left, page.main.y, page.main.width - left, page.main.height - below};
  if (profile.empty()) return axes;
  const auto [low, high] = std::minmax_element(
      profile.begin(), profile.end(),
      [](const ProfilePoint& a, const ProfilePoint& b) { return a.height_m < b.height_m; });
  constexpr double kLeastRelief_m = 0.1;
  constexpr double kFilled = 0.62;   // share of the box that the relief takes
  constexpr double kBeneath = 0.16;  // below the lowest ground
  const double relief_m = std::max(kLeastRelief_m, high->height_m - low->height_m);
  axes.px_per_m = axes.box.width / std::max(1.0, profile.back().travel_m);
  const double fitting = kFilled * axes.box.height / (axes.px_per_m * relief_m);
  axes.exaggeration = exaggeration.value_or(fitting >= 2.0 ? std::floor(fitting) : fitting);
  axes.low_m = low->height_m - kBeneath * axes.box.height / (axes.px_per_m * axes.exaggeration);
  return axes;
}

void draw_grid(Sheet& sheet, Typeface& typeface, const Page& page, const Axes& axes) {
  const TextStyle style = page.text(13);
  const double line = std::max(1.0, std::round(page.px(1)));
  const Box& box = axes.box;
  const double metre_px = axes.px_per_m * axes.exaggeration;
  const double step_m = round_down_to_125(page.px(90) / metre_px);
  const double high_m = axes.low_m + box.height / metre_px;
  for (auto k = static_cast<long>(std::ceil(axes.low_m / step_m));
       static_cast<double>(k) * step_m <= high_m; ++k) {
    const double height_m = static_cast<double>(k) * step_m;
    const double y = std::round(axes.pixel(0.0, height_m).y());
    fill_box(sheet, {box.x, y, box.width, line}, {225, 227, 228});
    write_text(sheet, typeface, {box.x - page.px(6), y + page.px(5)}, fmt::format("{:g}", height_m),
               style, colours::kInkSoft, Align::kRight);
  }
  const double along_m = round_down_to_125(page.px(170) / axes.px_per_m);
  for (double travel_m = 0.0; travel_m * axes.px_per_m <= box.width; travel_m += along_m) {
    const double x = std::round(axes.pixel(travel_m, 0.0).x());
    fill_box(sheet, {x, box.bottom(), line, page.px(6)}, colours::kInkSoft);
    write_text(sheet, typeface, {x, box.bottom() + page.px(22)}, fmt::format("{:g}", travel_m),
               style, colours::kInkSoft, Align::kCentre);
  }
  write_text(sheet, typeface, {box.x, box.y - page.px(8)}, "Height of the ground [m]", style,
             colours::kInkSoft);
  write_text(sheet, typeface, {box.right(), box.bottom() + page.px(40)}, "Distance driven [m]",
             style, colours::kInkSoft, Align::kRight);
}

void draw_ground(Sheet& sheet, const std::vector<ProfilePoint>& profile, const Axes& axes,
                 double line_px) {
  std::vector<Eigen::Vector3d> line;
  for (const ProfilePoint& point : profile) {
    const Point2 p = axes.pixel(point.travel_m, point.height_m);
    line.emplace_back(p.x(), p.y(), 0.0);
  }
  line = thinned(line, 0.5);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2 a = line[i - 1].head<2>();
    const Point2 b = line[i].head<2>();
    fill_convex(
        sheet, std::array{a, b, Point2(b.x(), axes.box.bottom()), Point2(a.x(), axes.box.bottom())},
        kEarth);
  }
  stroke(sheet, line, line_px, kTopsoil);
}

Rgba band_of(PathKind kind) {
  if (kind == PathKind::kSwath || kind == PathKind::kHeadlandPass) return kPassBand;
  return kind == PathKind::kTransit ? kTransitBand : kTurnBand;
}

// What was done where, along the lower edge.
void draw_movements(Sheet& sheet, const PictureScene& scene, const Page& page,
                    const std::vector<ProfilePoint>& profile, const Axes& axes) {
  const double height = std::round(page.px(10));
  for (std::size_t i = 0; i < profile.size();) {
    std::size_t end = i;
    while (end + 1 < profile.size() && profile[end + 1].segment == profile[i].segment) ++end;
    const auto segment = static_cast<std::size_t>(std::max(profile[i].segment, 0));
    if (segment < scene.path.segments.size()) {
      const double from = axes.pixel(profile[i].travel_m, 0.0).x();
      const double to =
          axes.pixel(profile[std::min(end + 1, profile.size() - 1)].travel_m, 0.0).x();
      fill_box(sheet, {from, axes.box.bottom() - height, to - from, height},
               band_of(scene.path.segments[segment].kind));
    }
    i = end + 1;
  }
}

void draw_here(Sheet& sheet, const Page& page, const Point2& p_px) {
  const double size = page.px(12);
  const std::array<Point2, 3> corners = {p_px - Point2(0.0, page.px(3)),
                                         p_px + Point2(-size, -1.6 * size),
                                         p_px + Point2(size, -1.6 * size)};
  fill_convex(sheet, corners, colours::kEnd);
  stroke(sheet, corners, std::max(1.0, page.px(1.5)), colours::kInk, true);
}

void legend_profile(Legend& legend, const PictureScene& scene,
                    const std::vector<ProfilePoint>& profile, const Axes& axes) {
  legend_heading(legend, "Movements");
  legend_swatch(legend, kPassBand, "Swath or headland pass", "");
  legend_swatch(legend, kTurnBand, "Turn", "");
  legend_swatch(legend, kTransitBand, "Transit", "");
  const Point2 here = legend_symbol(
      legend, scene.moment_s ? "After " + duration_text(*scene.moment_s) : std::string("End"));
  draw_here(legend.sheet, legend.page, here + Point2(0.0, legend.page.px(12)));
  legend_gap(legend, 14);
  legend_heading(legend, "Heights");
  double climbed_m = 0.0;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    climbed_m += std::max(0.0, profile[i].height_m - profile[i - 1].height_m);
  }
  if (profile.empty()) {
    legend_note(legend, "Nothing was driven, and there is no path.");
    return;
  }
  const auto [low, high] = std::minmax_element(
      profile.begin(), profile.end(),
      [](const ProfilePoint& a, const ProfilePoint& b) { return a.height_m < b.height_m; });
  legend_note(legend,
              fmt::format("From {:.2f} m to {:.2f} m; {:.1f} m climbed in all over {:.0f} m.",
                          low->height_m, high->height_m, climbed_m, profile.back().travel_m));
  legend_note(legend, axes.exaggeration == 1.0
                          ? std::string("Heights are drawn to the same scale as lengths.")
                          : fmt::format("Heights are drawn {:.0f} times larger than lengths.",
                                        axes.exaggeration));
}

}  // namespace

Image draw_elevation(const PictureScene& scene, const PictureSize& size,
                     const ViewOptions& options) {
  const Page page = page_of(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const std::vector<ProfilePoint> profile = profile_of(scene);
  const Axes axes = axes_for(profile, page, options.exaggeration);

  Sheet plot;
  draw_grid(plot, typeface, page, axes);
  draw_ground(plot, profile, axes, std::max(1.5, page.px(2.5)));
  draw_movements(plot, scene, page, profile, axes);
  Legend legend{plot, typeface, page, page.column.y - page.px(4)};
  if (options.overlay) {
    const WayColours colours = way_colours(scene.run, *options.overlay);
    draw_way(plot, scene.run, colours, std::max(2.5, page.px(6)),
             [&](const RunSample& sample) -> std::optional<Eigen::Vector3d> {
               if (!sample.p_WB.allFinite()) return std::nullopt;
               const Point2 p =
                   axes.pixel(sample.travel_m,
                              surface_at(scene.terrain, sample.p_WB.x(), sample.p_WB.y()).height_m);
               return Eigen::Vector3d(p.x(), p.y(), 0.0);
             });
    legend_way(legend, colours);
  }
  if (!profile.empty()) {
    draw_here(plot, page, axes.pixel(profile.back().travel_m, profile.back().height_m));
  }
  frame_box(plot, axes.box, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
  legend_profile(legend, scene, profile, axes);
  write_title(plot, typeface, page, scene, "Elevation");

  const GlContext context;
  const GlFrame frame(size.width, size.height, colours::kPaper);
  return frame.draw([&](const Canvas& canvas) { paint(plot, typeface, canvas); });
}

}  // namespace headland
