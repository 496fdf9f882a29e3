// Flat drawing in pixels: areas, lines of constant width, letters.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "render/gl_objects.h"
#include "render/palette.h"
#include "render/typeface.h"

namespace headland {

// x right and y down from the picture's upper left corner [px]; z is the depth of OpenGL's
// normalised device coordinates (-1 near, 1 far), used only when drawn against the depth buffer.
struct SheetVertex {
  Eigen::Vector3f p_px = Eigen::Vector3f::Zero();
  Eigen::Vector2f texel = Eigen::Vector2f(0.5F, 0.5F);
  Rgba colour;
};

// Triangles in the order they are to be painted.
struct Sheet {
  std::vector<SheetVertex> vertices;
};

struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

void fill_box(Sheet& sheet, const Box& box, Rgba colour);
void frame_box(Sheet& sheet, const Box& box, double width_px, Rgba colour);
void fill_convex(Sheet& sheet, std::span<const Eigen::Vector2d> points_px, Rgba colour);
void fill_disc(Sheet& sheet, const Eigen::Vector2d& centre_px, double radius_px, Rgba colour);

// A line through the points, round at its joints and ends. `closed` joins the last to the first.
void stroke(Sheet& sheet, std::span<const Eigen::Vector3d> points_px, double width_px, Rgba colour,
            bool closed = false);
void stroke(Sheet& sheet, std::span<const Eigen::Vector2d> points_px, double width_px, Rgba colour,
            bool closed = false);

// A line whose width changes along it, with one width for each point and butt joints.
void stroke_tapered(Sheet& sheet, std::span<const Eigen::Vector3d> points_px,
                    std::span<const double> widths_px, Rgba colour);

// Parallel lines rising to the right inside a polygon of one or more rings (even-odd).
void hatch(Sheet& sheet, std::span<const std::vector<Eigen::Vector2d>> rings_px, double spacing_px,
           double width_px, Rgba colour);

enum class Align { kLeft, kCentre, kRight };

// A line of UTF-8 text whose base line is at y.
void write_text(Sheet& sheet, Typeface& typeface, const Eigen::Vector2d& p_px,
                std::string_view utf8, TextStyle style, Rgba colour, Align align = Align::kLeft);

// Points so thinned that no dropped point is farther than `tolerance_px` from a kept neighbour;
// the ends stay.
std::vector<Eigen::Vector3d> thinned(std::span<const Eigen::Vector3d> points_px,
                                     double tolerance_px);

// The line on the page with only the points that bend it: no dropped point is farther than
// `tolerance_px` from it (Douglas and Peucker; of points on a page, z is 0).
std::vector<Eigen::Vector3d> simplified(std::span<const Eigen::Vector3d> points_px,
                                        double tolerance_px);

// Paints the sheet in the picture's coordinates; `test_depth`: hidden behind what is nearer.
void paint(const Sheet& sheet, const Typeface& typeface, const Canvas& canvas,
           bool test_depth = false);

}  // namespace headland
