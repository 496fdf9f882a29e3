#include "render/vehicle_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/page.h"
#include "render/terrain_surface.h"
#include "render/text_lines.h"
#include "render/vehicle_mesh.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;

// One window of the page.
struct View {
  Camera camera;
  double heading_rad = 0.0;  // the camera looks along it
};

Eigen::AlignedBox3d bounds_of_mesh(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const MeshVertex& vertex : mesh.vertices) box.extend(vertex.p.cast<double>());
  return box;
}

std::vector<Point3> corners_of(const Eigen::AlignedBox3d& box) {
  std::vector<Point3> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i) {
    corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  }
  return corners;
}

View look_at(const Eigen::AlignedBox3d& box, double heading_rad, double down_rad,
             double field_of_view_rad, const Box& view_px) {
  return {fit_camera(corners_of(box), heading_rad, down_rad, field_of_view_rad, view_px),
          heading_rad};
}

// The ground as far as the window shows it, then the vehicle and its shadow.
void paint_window(const Canvas& canvas, const Mesh& mesh, const View& view,
                  const Typeface& typeface) {
  const Box& box = view.camera.view_px;
  look_through(box, canvas);
  Sheet sky;
  fill_box(sky, box, colours::kSky);
  paint(sky, typeface, canvas);
  look_through(box, canvas);
  glClear(GL_DEPTH_BUFFER_BIT);
  constexpr double kReach_m = 60.0;
  constexpr double kThickness_m = 0.05;
  const Mesh ground = box_mesh({-kReach_m, -kReach_m, -kThickness_m}, {kReach_m, kReach_m, 0.0},
                               colours::kUnworked);
  const Eigen::Matrix4f clip = clip_from_D(view.camera);
  const Eigen::Vector3f sun = sun_for(view.heading_rad);
  paint_solids(canvas, upload(ground), clip, view.camera.eye_D, sun);
  paint_shadows(canvas, upload(shadow_mesh(mesh, Point3::Zero(), Point3::UnitZ(), sun)), clip);
  paint_solids(canvas, upload(mesh), clip, view.camera.eye_D, sun);
}

// Marks the centre of mass and the line of gravity, and the tipping points with their lines to it.
void mark_stability(Sheet& sheet, const Page& page, const View& view, const Point3& com_B,
                    const std::array<Point3, 2>& feet_B) {
  const auto pixel = [&](const Point3& p_B) -> Point2 {
    return pixel_of(view.camera, p_B).head<2>();
  };
  const Point2 centre = pixel(com_B);
  const double width = std::max(1.0, page.px(1.6));
  for (const Point3& foot_B : feet_B) {
    const std::array<Point2, 2> line{pixel(foot_B), centre};
    stroke(sheet, line, width, colours::kEnd);
    fill_disc(sheet, line[0], page.px(4), colours::kEnd);
  }
  const std::array<Point2, 2> plumb{centre, pixel({com_B.x(), com_B.y(), 0.0})};
  stroke(sheet, plumb, width, colours::kInk);
  fill_disc(sheet, centre, page.px(8), colours::kInk);
  fill_disc(sheet, centre, page.px(5.5), colours::kPaper);
  fill_disc(sheet, centre, page.px(3), colours::kInk);
}

void draw_scale(Sheet& sheet, Typeface& typeface, const Page& page, const View& view,
                const Point3& middle_B) {
  const double px_per_m = view.camera.focal_px / (middle_B - view.camera.eye_D).norm();
  const Box& box = view.camera.view_px;
  draw_scale_bar(sheet, typeface, page, px_per_m, page.px(140),
                 {box.x + page.px(16), box.bottom() - page.px(34)});
}

void write_column(Sheet& sheet, Typeface& typeface, const Page& page,
                  std::span<const SheetFigure> figures, const std::string& note) {
  Legend legend{sheet, typeface, page, page.column.y - page.px(4)};
  legend_heading(legend, "Figures");
  const TextStyle style = page.text(14);
  for (const SheetFigure& figure : figures) {
    legend.y_px += page.px(21);
    write_text(sheet, typeface, {page.column.x, std::round(legend.y_px)}, figure.label, style,
               colours::kInkSoft);
    const double room_px =
        page.column.width - text_width_px(typeface, figure.label, style) - page.px(14);
    double y_px = legend.y_px;
    for (const std::string& line : lines_within(typeface, figure.value, style, room_px)) {
      legend.y_px = y_px;
      write_text(sheet, typeface, {page.column.right(), std::round(y_px)},
                 fitted_text(typeface, line, style, room_px), style, colours::kInk, Align::kRight);
      y_px += page.px(19);
    }
  }
  legend_gap(legend, 18);
  legend_heading(legend, "In the views");
  legend_note(legend,
              "Ring: centre of mass with what is mounted. Red: the ground points about which it "
              "would tip.");
  if (!note.empty()) legend_note(legend, "Body: " + note + ".");
}

// The wheels' ground points on which the vehicle would tip sideways, abreast of its centre of mass.
std::array<Point3, 2> side_feet(const Vehicle& vehicle, const Point3& com_B) {
  const double reach_m = com_B.z() * std::tan(side_stability_angle_rad(vehicle));
  return {Point3(com_B.x(), reach_m, 0.0), Point3(com_B.x(), -reach_m, 0.0)};
}

}  // namespace

Image draw_vehicle_sheet(const Vehicle& vehicle, std::span<const SheetFigure> figures,
                         const PictureSize& size) {
  constexpr double kColumn = 430.0;
  constexpr double kNearlyParallel_rad = 6.0 * kDegree;
  const Page page = page_of(size, kColumn);
  Typeface typeface(kFontFile, kBoldFontFile);
  const GlContext context;
  const GlFrame frame(size.width, size.height, colours::kPaper);
  RunSample standing;
  standing.implement_down = true;
  const VehicleMesh body = vehicle_mesh(vehicle, standing);
  Eigen::AlignedBox3d box = bounds_of_mesh(body.mesh);
  const double air_m = 0.06 * box.sizes().maxCoeff();
  box.extend(Point3(box.min().array() - air_m));
  box.extend(Point3(box.max().array() + air_m));

  const double gap = std::round(page.px(12));
  const double upper = std::round(0.56 * page.main.height);
  const double lower = page.main.height - upper - gap;
  const double half = std::round(0.5 * (page.main.width - gap));
  const Box top{page.main.x, page.main.y, page.main.width, upper};
  const Box left{page.main.x, page.main.y + upper + gap, half, lower};
  const Box right{page.main.x + half + gap, left.y, page.main.width - half - gap, lower};
  constexpr double kFromAhead_rad = std::numbers::pi - 0.62;
  const View perspective = look_at(box, kFromAhead_rad, 18.0 * kDegree, 30.0 * kDegree, top);
  const View side = look_at(box, 0.5 * std::numbers::pi, 2.0 * kDegree, kNearlyParallel_rad, left);
  const View rear = look_at(box, 0.0, 2.0 * kDegree, kNearlyParallel_rad, right);
  Sheet sheet;
  const Point3 com_B = total_com_B(vehicle);
  mark_stability(sheet, page, side, com_B,
                 {Point3(vehicle.rear.x_B_m, 0.0, 0.0), Point3(vehicle.front.x_B_m, 0.0, 0.0)});
  mark_stability(sheet, page, rear, com_B, side_feet(vehicle, com_B));
  draw_scale(sheet, typeface, page, side, com_B);
  draw_scale(sheet, typeface, page, rear, com_B);
  for (const View* view : {&perspective, &side, &rear}) {
    frame_box(sheet, view->camera.view_px, std::max(1.0, std::round(page.px(1))),
              colours::kInkSoft);
  }
  write_text(sheet, typeface, {page.main.x, page.px(46)}, vehicle.name, page.text(28, true),
             colours::kInk);
  write_text(sheet, typeface, {page.main.x, page.px(74)}, vehicle.description, page.text(15),
             colours::kInkSoft);
  write_column(sheet, typeface, page, figures, body.note);
  return frame.draw([&](const Canvas& canvas) {
    for (const View* view : {&perspective, &side, &rear}) {
      paint_window(canvas, body.mesh, *view, typeface);
    }
    look_at_page();
    paint(sheet, typeface, canvas);
  });
}

}  // namespace headland
