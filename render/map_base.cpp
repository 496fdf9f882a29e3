#include "render/map_base.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "render/field_view.h"
#include "render/obstacle_symbol.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

// Slopes up to here are seen well in the shading; gentler ground is stretched, at most so often.
constexpr double kWellSeenSlope = 0.30;
constexpr double kMaxShadingStretch = 6.0;
constexpr double kContours = 9.0;        // about so many between lowest and highest
constexpr double kLevelGround_m = 0.05;  // below this there is nothing to draw a contour of

struct Ends {
  Point2 start;
  Point2 end;
  double start_yaw_rad = 0.0;
};

std::optional<Ends> ends_of(const PictureScene& scene) {
  if (const RunSample* last = last_pose(scene.run)) {
    const RunSample& first = scene.run.samples.front();
    return Ends{first.p_WB.head<2>(), last->p_WB.head<2>(), first.yaw_rad};
  }
  const auto has_points = [](const PathSegment& segment) { return !segment.points.empty(); };
  const auto& segments = scene.path.segments;
  const auto first = std::find_if(segments.begin(), segments.end(), has_points);
  if (first == segments.end()) return std::nullopt;
  const auto last = std::find_if(segments.rbegin(), segments.rend(), has_points);
  return Ends{first->points.front().p_W, last->points.back().p_W,
              first->points.front().heading_rad};
}

void add_pointer(Sheet& sheet, const Page& page, const Point2& p_px, double yaw_rad, double size,
                 Rgba colour) {
  const Point2 ahead(std::cos(yaw_rad), -std::sin(yaw_rad));
  const Point2 side(-ahead.y(), ahead.x());
  const std::array<Point2, 3> corners = {p_px + size * ahead, p_px - 0.75 * size * (ahead + side),
                                         p_px - 0.75 * size * (ahead - side)};
  stroke(sheet, corners, page.px(5), colours::kPaper, true);
  fill_convex(sheet, corners, colour);
  stroke(sheet, corners, std::max(1.0, page.px(1.5)), colours::kInk, true);
}

void add_start(Sheet& sheet, const Page& page, const Point2& p_px, double yaw_rad) {
  add_pointer(sheet, page, p_px, yaw_rad, page.px(9.5), colours::kStart);
}

void add_end(Sheet& sheet, const Page& page, const Point2& p_px) {
  const double size = std::round(page.px(14));
  const Box box{std::round(p_px.x() - 0.5 * size), std::round(p_px.y() - 0.5 * size), size, size};
  const double rim = std::max(1.0, std::round(page.px(2)));
  fill_box(sheet, {box.x - rim, box.y - rim, size + 2 * rim, size + 2 * rim}, colours::kPaper);
  fill_box(sheet, box, colours::kEnd);
  frame_box(sheet, box, std::max(1.0, std::round(page.px(1.5))), colours::kInk);
}

double boundary_width_px(const Page& page) { return std::max(1.5, page.px(2.4)); }

}  // namespace

MapView map_view(const PictureScene& scene, const Page& page) {
  constexpr double kMarginShare = 0.035;
  constexpr double kMinMargin_m = 1.5;
  const Extent field = extent_of(scene.field.boundary);
  const double margin_m = std::max(kMinMargin_m, kMarginShare * field.size().maxCoeff());
  const Extent terrain = extent_of(scene.terrain);
  MapView view;
  view.camera = fit_map(grown(field, margin_m), terrain, page.main);
  view.heights = height_range(scene.terrain, overlap(field, terrain));
  const double relief_m = view.heights.high_m - view.heights.low_m;
  if (relief_m > kLevelGround_m) view.contour_m = round_down_to_125(1.6 * relief_m / kContours);
  // From a multiple of the step, so that contours lie at round heights.
  view.relief.base_m = view.contour_m > 0.0
                           ? std::floor(view.heights.low_m / view.contour_m) * view.contour_m
                           : view.heights.low_m;
  const double slope = steep_slope(scene.terrain, overlap(field, terrain));
  view.relief.exaggeration =
      slope > 0.0 ? std::clamp(std::floor(kWellSeenSlope / slope), 1.0, kMaxShadingStretch) : 1.0;
  return view;
}

namespace {

Mesh map_mesh(const PictureScene& scene, const MapView& view, Rgba colour, double spacing_px) {
  return relief_mesh(scene.terrain, view.relief,
                     grown(view.camera.window, 2.0 * scene.terrain.cell_m), colour,
                     spacing_px / view.camera.px_per_m);
}

SurfaceLook contoured(SurfaceLook look, const MapView& view) {
  look.contour_step_D = static_cast<float>(view.contour_m * view.relief.exaggeration);
  return look;
}

Eigen::Matrix4f map_clip(const PictureScene& scene, const MapView& view) {
  const HeightRange heights =
      height_range(scene.terrain, grown(view.camera.window, 2.0 * scene.terrain.cell_m));
  const auto in_D = [&](double height_m) {
    return (height_m - view.relief.base_m) * view.relief.exaggeration;
  };
  return clip_from_D(view.camera, in_D(heights.low_m), in_D(heights.high_m));
}

}  // namespace

MapGround::MapGround(const PictureScene& scene, const MapView& view, const CoverageClasses& classes,
                     const SurfaceLook& wanted, Rgba ground, double spacing_px)
    : surface(upload(map_mesh(scene, view, ground, spacing_px))),
      coverage(classes),
      look(contoured(wanted, view)),
      clip(map_clip(scene, view)) {}

void paint_map_ground(const Canvas& canvas, const MapView& view, const MapGround& ground) {
  look_through(view.camera.view_px, canvas);
  paint_surface(canvas, ground.surface, ground.clip, ground.coverage, ground.look);
  look_at_page();
}

Image draw_map_page(const Page& page, const Typeface& typeface, const MapView& view,
                    const MapGround& ground, const MapSheets& sheets) {
  const GlFrame frame(page.size_px.x(), page.size_px.y(), colours::kPaper);
  return frame.draw([&](const Canvas& canvas) {
    paint_map_ground(canvas, view, ground);
    look_through(view.camera.view_px, canvas);
    paint(sheets.map, typeface, canvas);
    look_at_page();
    paint(sheets.margin, typeface, canvas);
  });
}

std::vector<Eigen::Vector3d> map_line(const MapView& view, const std::vector<Point2>& line_W) {
  std::vector<Eigen::Vector3d> line;
  line.reserve(line_W.size());
  for (const Point2& p_W : line_W) {
    const Point2 p = pixel_of(view.camera, p_W);
    line.emplace_back(p.x(), p.y(), 0.0);
  }
  return line;
}

std::vector<Eigen::Vector3d> track_line(const MapView& view, const PictureScene& scene) {
  std::vector<Point2> line;
  for (const RunSample& sample : scene.run.samples) {
    if (sample.p_WB.allFinite()) line.emplace_back(sample.p_WB.head<2>());
  }
  if (line.empty()) {
    for (const PathSegment& segment : scene.path.segments) {
      for (const PathPoint& point : segment.points) line.push_back(point.p_W);
    }
  }
  return map_line(view, line);
}

ArrowLook track_arrows(const Page& page, Rgba colour) {
  return {page.px(130), page.px(11), colour, colours::kPaper};
}

void draw_field_lines(Sheet& sheet, const PictureScene& scene, const Page& page,
                      const MapView& view) {
  const double width = boundary_width_px(page);
  for (const Ring& hole : scene.field.holes) {
    std::vector<Point2> ring;
    for (const Point2& p_W : hole) ring.push_back(pixel_of(view.camera, p_W));
    hatch(sheet, std::span(&ring, 1), page.px(8), std::max(1.0, page.px(1.6)), colours::kInkSoft);
    stroke(sheet, ring, 0.75 * width, colours::kBoundary, true);
  }
  stroke(sheet, map_line(view, scene.field.boundary), width, colours::kBoundary, true);
  for (const Obstacle& obstacle : scene.field.obstacles) {
    if (runs_along_line(obstacle.kind)) {
      draw_barrier_symbol(sheet, page, obstacle.kind, pixel_of(view.camera, obstacle.p_W),
                          pixel_of(view.camera, obstacle.p_W + obstacle.run_W),
                          2.0 * obstacle.radius_m * view.camera.px_per_m);
      continue;
    }
    const double radius = std::max(page.px(5.5), obstacle.radius_m * view.camera.px_per_m);
    draw_obstacle_symbol(sheet, page, obstacle.kind, pixel_of(view.camera, obstacle.p_W), radius);
  }
}

void mark_vehicle(Sheet& sheet, const Page& page, const Point2& p_px, double yaw_rad) {
  add_pointer(sheet, page, p_px, yaw_rad, page.px(14), colours::kEnd);
}

void draw_start_and_end(Sheet& sheet, const PictureScene& scene, const Page& page,
                        const MapView& view) {
  const std::optional<Ends> ends = ends_of(scene);
  if (!ends) return;
  if (const RunSample* here = scene.moment_s ? last_pose(scene.run) : nullptr) {
    mark_vehicle(sheet, page, pixel_of(view.camera, ends->end), here->yaw_rad);
  } else {
    add_end(sheet, page, pixel_of(view.camera, ends->end));
  }
  add_start(sheet, page, pixel_of(view.camera, ends->start), ends->start_yaw_rad);
}

void legend_field(Legend& legend, const PictureScene& scene) {
  const Page& page = legend.page;
  legend_heading(legend, "Field");
  const Point2 boundary = legend_symbol(legend, "Boundary");
  const Point2 half(page.px(13), 0.0);
  stroke(legend.sheet, std::array{Point2(boundary - half), Point2(boundary + half)},
         boundary_width_px(page), colours::kBoundary);
  if (!scene.field.holes.empty()) {
    const Point2 centre = legend_symbol(legend, "Hole, not to be entered");
    const Point2 size(page.px(13), page.px(7.5));
    const std::vector<Point2> ring = {centre - size,
                                      {centre.x() + size.x(), centre.y() - size.y()},
                                      centre + size,
                                      {centre.x() - size.x(), centre.y() + size.y()}};
    hatch(legend.sheet, std::span(&ring, 1), page.px(6), std::max(1.0, page.px(1.6)),
          colours::kInkSoft);
    stroke(legend.sheet, ring, std::max(1.0, page.px(1.5)), colours::kBoundary, true);
  }
  for (const ObstacleKind kind : kEveryObstacleKind) {
    const auto count =
        std::count_if(scene.field.obstacles.begin(), scene.field.obstacles.end(),
                      [kind](const Obstacle& obstacle) { return obstacle.kind == kind; });
    if (count == 0) continue;
    constexpr std::array<std::string_view, 5> kLabels = {"Tree", "Pole", "Rock", "Wall", "Fence"};
    const std::string_view label = kLabels[static_cast<std::size_t>(kind)];
    if (runs_along_line(kind)) {
      const Point2 middle = legend_symbol(legend, label);
      const Point2 reach(page.px(13), 0.0);
      draw_barrier_symbol(legend.sheet, page, kind, middle - reach, middle + reach, 0.0);
      continue;
    }
    const Point2 centre =
        legend_symbol(legend, label, count > 1 ? fmt::format("{}", count) : std::string());
    draw_obstacle_symbol(legend.sheet, page, kind, centre, page.px(5.5));
  }
}

void legend_relief(Legend& legend, const PictureScene& scene, const MapView& view) {
  if (!scene.terrain_known) return;
  legend_gap(legend, 10);
  legend_heading(legend, "Relief");
  const double relief_m = view.heights.high_m - view.heights.low_m;
  if (view.contour_m <= 0.0) {
    legend_note(legend, "Level ground.");
    return;
  }
  legend_note(legend,
              fmt::format("{:.1f} m from lowest to highest ({:.1f} m to {:.1f} m). Contours "
                          "every {:g} m.",
                          relief_m, view.heights.low_m, view.heights.high_m, view.contour_m));
  if (view.relief.exaggeration > 1.0) {
    legend_note(legend,
                fmt::format("Shading shows slopes {:g} times steeper.", view.relief.exaggeration));
  }
}

void legend_start_and_end(Legend& legend, const PictureScene& scene) {
  if (!ends_of(scene)) return;
  add_start(legend.sheet, legend.page, legend_symbol(legend, "Start"), 0.0);
  if (scene.moment_s) {
    mark_vehicle(legend.sheet, legend.page, legend_symbol(legend, "The vehicle"), 0.0);
  } else {
    add_end(legend.sheet, legend.page, legend_symbol(legend, "End"));
  }
}

namespace {

// Coordinates in metres along the lower and the left edge, where places in texts are looked up.
void draw_ticks(Sheet& sheet, Typeface& typeface, const Page& page, const MapView& view) {
  const Box box = view.camera.view_px;
  const double step_m = round_down_to_125(page.px(260) / view.camera.px_per_m);
  const TextStyle style = page.text(12);
  const double line = std::max(1.0, std::round(page.px(1)));
  const Point2 low_W = view.camera.window.low;
  const Point2 high_W = view.camera.window.high;
  const auto first = [step_m](double low_m) {
    return static_cast<long>(std::ceil(low_m / step_m));
  };
  const auto last = [step_m](double high_m) {
    return static_cast<long>(std::floor(high_m / step_m));
  };
  for (long i = first(low_W.x()); i <= last(high_W.x()); ++i) {
    const double x_m = static_cast<double>(i) * step_m;
    const double x = std::round(pixel_of(view.camera, {x_m, low_W.y()}).x());
    fill_box(sheet, {x, box.bottom() - page.px(6), line, page.px(6)}, colours::kInkSoft);
    write_text(sheet, typeface, {x, box.bottom() + page.px(16)}, fmt::format("{:g}", x_m), style,
               colours::kInkSoft, Align::kCentre);
  }
  for (long i = first(low_W.y()); i <= last(high_W.y()); ++i) {
    const double y_m = static_cast<double>(i) * step_m;
    const double y = std::round(pixel_of(view.camera, {low_W.x(), y_m}).y());
    fill_box(sheet, {box.x, y, page.px(6), line}, colours::kInkSoft);
    write_text(sheet, typeface, {box.x - page.px(4), y + page.px(4)}, fmt::format("{:g}", y_m),
               style, colours::kInkSoft, Align::kRight);
  }
  write_text(sheet, typeface, {box.right(), box.bottom() + page.px(30)}, "x, y in m", style,
             colours::kInkSoft, Align::kRight);
}

}  // namespace

void draw_map_frame(Sheet& sheet, Typeface& typeface, const Page& page, const MapView& view) {
  frame_box(sheet, view.camera.view_px, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
  draw_ticks(sheet, typeface, page, view);
  const double foot = page.column.bottom();
  draw_scale_bar(sheet, typeface, page, view.camera.px_per_m, page.px(230),
                 {page.column.x, foot - page.px(24)});
  draw_north_arrow(sheet, typeface, page, {page.column.right() - page.px(18), foot - page.px(22)},
                   {0.0, -1.0});
}

}  // namespace headland
