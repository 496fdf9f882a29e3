// draw_view: the field in perspective, with the vehicle where it ended.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/field_view.h"
#include "render/obstacle_mesh.h"
#include "render/pictures.h"
#include "render/terrain_surface.h"
#include "render/vehicle_mesh.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

SurfaceLook soil_look(const FieldView& view) {
  SurfaceLook look;
  look.to_sun = sun_for(view.heading_rad);
  look.once = colours::kWorked;
  look.twice = colours::kWorkedTwice;
  look.thrice = colours::kWorkedThrice;
  look.missed = colours::kUnworked;
  look.shading = 1.0F;
  return look;
}

std::vector<Point3> seen(const Camera& camera, const std::vector<Point3>& line_D) {
  std::vector<Point3> line;
  line.reserve(line_D.size());
  for (const Point3& p_D : line_D) {
    const Point3 pixel = pixel_of(camera, p_D);
    // Behind the camera there are no pixels.
    if (pixel.z() > -1.0 && pixel.z() < 1.0) line.push_back(pixel);
  }
  return thinned(line, 0.5);
}

// Lines along the strips at a share of the width from the left (0) to the right end (1), as wide
// as `width_m` of the ground there: with distance they fade of themselves.
void draw_strip_line(Sheet& sheet, const PictureScene& scene, const FieldView& view, double share,
                     double width_m, Rgba colour) {
  constexpr double kLift_m = 0.03;
  constexpr double kSpacing_px = 1.0;
  constexpr double kThinnest_px = 0.2;
  std::vector<Point3> line;
  std::vector<double> widths;
  const auto flush = [&] {
    stroke_tapered(sheet, line, widths, colour);
    line.clear();
    widths.clear();
  };
  for (const FootprintSample& footprint : scene.run.footprints) {
    if (footprint.starts_strip) flush();
    const Point2 p_W = footprint.left_W + share * (footprint.right_W - footprint.left_W);
    const bool in_block = (p_W.array() >= view.block.low.array()).all() &&
                          (p_W.array() <= view.block.high.array()).all();
    const Point3 p_D = on_ground(scene.terrain, view.relief, p_W) + Point3(0.0, 0.0, kLift_m);
    const Point3 pixel = pixel_of(view.camera, p_D);
    const double width_px = width_m * view.camera.focal_px / (p_D - view.camera.eye_D).norm();
    if (!in_block || !(pixel.z() > -1.0 && pixel.z() < 1.0) || width_px < kThinnest_px) {
      flush();
      continue;
    }
    if (!line.empty() && (pixel - line.back()).head<2>().norm() < kSpacing_px) continue;
    line.push_back(pixel);
    widths.push_back(width_px);
  }
  flush();
}

void draw_boundaries(Sheet& sheet, const PictureScene& scene, const FieldView& view,
                     double width_px) {
  const double lift_m = 0.001 * view.block.size().maxCoeff();
  const auto ring = [&](const Ring& points_W, Rgba colour) {
    const auto line =
        draped(scene.terrain, view.relief, points_W, true, scene.terrain.cell_m, lift_m);
    stroke(sheet, seen(view.camera, line), width_px, colour, true);
  };
  constexpr Rgba kDraped{250, 250, 246};
  ring(scene.field.boundary, kDraped);
  for (const Ring& hole : scene.field.holes) ring(hole, kDraped);
}

// What stands on the field, with its shadows.
void paint_obstacles(const PictureScene& scene, const FieldView& view) {
  const Eigen::Matrix4f clip = clip_from_D(view.camera);
  Mesh all;
  const auto stand = [&](const Mesh& mesh, const Point2& foot_W) {
    const Point2 slope =
        view.relief.exaggeration * surface_at(scene.terrain, foot_W.x(), foot_W.y()).gradient;
    paint_shadow(mesh, on_ground(scene.terrain, view.relief, foot_W), {-slope.x(), -slope.y(), 1.0},
                 clip, sun_for(view.heading_rad));
    append(all, mesh, Eigen::Isometry3d::Identity());
  };
  for (const Obstacle& obstacle : scene.field.obstacles) {
    if (!runs_along_line(obstacle.kind)) {
      const Point3 foot = on_ground(scene.terrain, view.relief, obstacle.p_W);
      Mesh mesh;
      append(mesh, obstacle_mesh(obstacle), Eigen::Isometry3d(Eigen::Translation3d(foot)));
      stand(mesh, obstacle.p_W);
      continue;
    }
    constexpr double kPiece_m = 2.5;  // between a fence's posts
    const std::vector<Point3> feet =
        draped(scene.terrain, view.relief, {obstacle.p_W, obstacle.p_W + obstacle.run_W}, false,
               kPiece_m, 0.0);
    for (std::size_t i = 1; i < feet.size(); ++i) {
      stand(barrier_mesh(obstacle, feet[i - 1], feet[i]),
            (0.5 * (feet[i - 1] + feet[i])).head<2>());
    }
  }
  if (!all.indices.empty())
    paint_solids(upload(all), clip, view.camera.eye_D, sun_for(view.heading_rad));
}

void paint_vehicle(const PictureScene& scene, const FieldView& view, const VehicleMesh& vehicle,
                   const RunSample& sample) {
  const Eigen::Isometry3d X_DB = pose_in_D(sample, view.relief);
  const Point2 slope = view.relief.exaggeration *
                       surface_at(scene.terrain, sample.p_WB.x(), sample.p_WB.y()).gradient;
  Mesh mesh;
  append(mesh, vehicle.mesh, X_DB);
  const Eigen::Matrix4f clip = clip_from_D(view.camera);
  paint_shadow(mesh, X_DB.translation(), {-slope.x(), -slope.y(), 1.0}, clip,
               sun_for(view.heading_rad));
  paint_solids(upload(mesh), clip, view.camera.eye_D, sun_for(view.heading_rad));
}

void paint_block(const PictureScene& scene, const FieldView& view, const SurfaceCoverage& coverage,
                 const SurfaceLook& look) {
  const Eigen::Matrix4f clip = clip_from_D(view.camera);
  const Mesh top = relief_mesh(scene.terrain, view.relief, view.block, colours::kMeadow);
  paint_surface(upload(top), clip, coverage, look);
  const Mesh sides =
      relief_sides(scene.terrain, view.relief, view.block, view.bottom_D, colours::kBlockSide);
  paint_solids(upload(sides), clip, view.camera.eye_D, sun_for(view.heading_rad));
}

// The whole field into the page's main box.
void paint_field(const PictureScene& scene, const Page& page, const FieldView& view,
                 const SurfaceCoverage& coverage, const Typeface& typeface) {
  look_through(view.camera.view_px, page.size_px.y());
  paint_block(scene, view, coverage, soil_look(view));
  Sheet lines;
  constexpr Rgba kStripEdge{70, 48, 30, 130};
  const double edge_m = 0.04 * scene.vehicle.implement.working_width_m;
  draw_strip_line(lines, scene, view, 0.0, edge_m, kStripEdge);
  draw_strip_line(lines, scene, view, 1.0, edge_m, kStripEdge);
  draw_boundaries(lines, scene, view, std::max(1.2, page.px(2.0)));
  paint(lines, typeface, page.size_px, true);
  look_through(view.camera.view_px, page.size_px.y());
  paint_obstacles(scene, view);
}

// The vehicle from close by, under a sky.
void paint_close_up(const PictureScene& scene, const Page& page, const FieldView& view,
                    const SurfaceCoverage& coverage, const VehicleMesh& vehicle,
                    const RunSample& sample, const Typeface& typeface) {
  const Box& box = view.camera.view_px;
  look_through(box, page.size_px.y());
  Sheet sky;
  fill_box(sky, box, colours::kSky);
  paint(sky, typeface, page.size_px);
  glClear(GL_DEPTH_BUFFER_BIT);
  look_through(box, page.size_px.y());
  SurfaceLook look = soil_look(view);
  look.fade_centre_W = sample.p_WB.head<2>().cast<float>();
  look.fade_from_m = 40.0F;
  look.fade_to_m = 150.0F;
  look.fade = colours::kSky;
  const Mesh ground = relief_mesh(scene.terrain, view.relief, view.block, colours::kMeadow);
  paint_surface(upload(ground), clip_from_D(view.camera), coverage, look);

  Sheet lines;
  constexpr Rgba kFurrow{70, 48, 30, 70};
  constexpr double kFurrowSpacing_m = 0.5;
  constexpr double kFurrowWidth_m = 0.06;
  const int furrows =
      std::max(1, static_cast<int>(scene.vehicle.implement.working_width_m / kFurrowSpacing_m));
  for (int i = 0; i <= furrows; ++i) {
    draw_strip_line(lines, scene, view, static_cast<double>(i) / furrows, kFurrowWidth_m, kFurrow);
  }
  draw_boundaries(lines, scene, view, page.px(2.0));
  paint(lines, typeface, page.size_px, true);
  look_through(box, page.size_px.y());
  paint_obstacles(scene, view);
  paint_vehicle(scene, view, vehicle, sample);
}

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

void legend_end(Legend& legend, const PictureScene& scene, const VehicleMesh& vehicle,
                const RunSample& sample) {
  legend_heading(legend, "The vehicle where it ended");
  legend_note(
      legend,
      fmt::format("After {:.2f} km, battery at {:.0f} %, nose {:.1f}° {}, {:.1f}° "
                  "down to the {}, implement {}.",
                  sample.travel_m / 1000.0, 100.0 * sample.soc, std::abs(degrees(sample.pitch_rad)),
                  sample.pitch_rad < 0.0 ? "down" : "up", std::abs(degrees(sample.roll_rad)),
                  sample.roll_rad < 0.0 ? "left" : "right", sample.implement_down ? "down" : "up"));
  if (!scene.run.outcome_detail.empty()) legend_note(legend, scene.run.outcome_detail);
  if (!vehicle.note.empty()) legend_note(legend, "Body: " + vehicle.note + ".");
  legend_gap(legend, 12);
}

void legend_ground(Legend& legend, const PictureScene& scene, const FieldView& view) {
  legend_heading(legend, "Ground");
  legend_swatch(legend, colours::kWorked, "Worked once", "");
  legend_swatch(legend, colours::kWorkedTwice, "Worked twice", "");
  legend_swatch(legend, colours::kWorkedThrice, "Worked three times or more", "");
  legend_swatch(legend, colours::kUnworked, "In the field, not worked", "");
  legend_swatch(legend, colours::kMeadow, "Outside the field, and holes", "");
  legend_gap(legend, 12);
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

}  // namespace

Image draw_view(const PictureScene& scene, const PictureSize& size) {
  const Page page = view_page(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const OsmesaContext context;
  const GlFrame frame(size.width, size.height, colours::kPaper);
  const SurfaceCoverage coverage(coverage_classes(scene.coverage, true));
  const FieldView view = field_view(scene, page);
  paint_field(scene, page, view, coverage, typeface);

  Sheet margin;
  write_title(margin, typeface, page, scene, "View");
  Legend legend{margin, typeface, page, page.column.y - page.px(4)};
  if (const RunSample* sample = last_pose(scene.run)) {
    const VehicleMesh vehicle = vehicle_mesh(scene.vehicle, *sample);
    paint_vehicle(scene, view, vehicle, *sample);
    const Box box{page.column.x, page.column.y, page.column.width,
                  std::round(0.72 * page.column.width)};
    paint_close_up(scene, page, close_up(scene, *sample, box), coverage, vehicle, *sample,
                   typeface);
    draw_pointer(margin, page, view, scene.vehicle, *sample, box);
    frame_box(margin, box, std::max(1.0, std::round(page.px(1))), colours::kInkSoft);
    legend.y_px = box.bottom() + page.px(6);
    legend_end(legend, scene, vehicle, *sample);
  }
  legend_ground(legend, scene, view);
  draw_north(margin, typeface, page, view);
  look_at_page();
  paint(margin, typeface, page.size_px);
  return frame.read();
}

}  // namespace headland
