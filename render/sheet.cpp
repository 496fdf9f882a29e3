#include "render/sheet.h"

#include <algorithm>
#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

void add_triangle(Sheet& sheet, const Point3& a, const Point3& b, const Point3& c, Rgba colour) {
  for (const Point3* p : {&a, &b, &c}) {
    sheet.vertices.push_back({p->cast<float>(), Eigen::Vector2f(0.5F, 0.5F), colour});
  }
}

Point3 flat(const Point2& p) { return {p.x(), p.y(), 0.0}; }

// Sector of a disc, `turn_rad` from `from_rad` on. The fewer corners, the narrower the line.
void add_sector(Sheet& sheet, const Point3& p, double radius_px, double from_rad, double turn_rad,
                Rgba colour) {
  const double whole = std::clamp(std::floor(4.0 + 4.0 * radius_px), 6.0, 48.0);
  const int corners = std::max(
      1, static_cast<int>(std::ceil(whole * std::abs(turn_rad) / (2.0 * std::numbers::pi) - 1e-9)));
  const auto rim = [&](int i) {
    const double angle = from_rad + turn_rad * i / corners;
    return Point3(p + radius_px * Point3(std::cos(angle), std::sin(angle), 0.0));
  };
  for (int i = 0; i < corners; ++i) add_triangle(sheet, p, rim(i), rim(i + 1), colour);
}

void add_disc(Sheet& sheet, const Point3& p, double radius_px, Rgba colour) {
  add_sector(sheet, p, radius_px, 0.0, 2.0 * std::numbers::pi, colour);
}

// What two legs of a line leave open on the outer side of the bend between them.
void add_joint(Sheet& sheet, const Point3& p, const Point2& before, const Point2& after,
               double radius_px, Rgba colour) {
  const double turn_rad =
      std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
  // A gap that nobody sees.
  constexpr double kLeastRim_px = 0.02;
  if (radius_px * std::abs(turn_rad) < kLeastRim_px) return;
  const double quarter = std::copysign(0.5 * std::numbers::pi, -turn_rad);
  add_sector(sheet, p, radius_px, std::atan2(before.y(), before.x()) + quarter, turn_rad, colour);
}

// Half a disc ahead of a line that ends at p.
void add_end(Sheet& sheet, const Point3& p, const Point2& outwards, double radius_px, Rgba colour) {
  add_sector(sheet, p, radius_px, std::atan2(outwards.y(), outwards.x()) - 0.5 * std::numbers::pi,
             std::numbers::pi, colour);
}

void add_segment(Sheet& sheet, const Point3& a, const Point3& b, double width_px, Rgba colour) {
  const Point2 along = (b - a).head<2>();
  const double length = along.norm();
  if (!(length > 0.0)) return;
  const Point3 side(-along.y() * 0.5 * width_px / length, along.x() * 0.5 * width_px / length, 0.0);
  add_triangle(sheet, a - side, a + side, b + side, colour);
  add_triangle(sheet, a - side, b + side, b - side, colour);
}

// Points that lie on one another in the picture have no direction between them.
std::vector<Point3> without_repeats(std::span<const Point3> points_px, bool closed) {
  std::vector<Point3> points;
  points.reserve(points_px.size());
  const auto apart = [](const Point3& a, const Point3& b) {
    return a.x() != b.x() || a.y() != b.y();
  };
  for (const Point3& p : points_px) {
    if (points.empty() || apart(p, points.back())) points.push_back(p);
  }
  while (closed && points.size() > 1 && !apart(points.front(), points.back())) points.pop_back();
  return points;
}

}  // namespace

void fill_box(Sheet& sheet, const Box& box, Rgba colour) {
  const Point3 a(box.x, box.y, 0.0);
  const Point3 c(box.right(), box.bottom(), 0.0);
  add_triangle(sheet, a, {c.x(), a.y(), 0.0}, c, colour);
  add_triangle(sheet, a, c, {a.x(), c.y(), 0.0}, colour);
}

void frame_box(Sheet& sheet, const Box& box, double width_px, Rgba colour) {
  fill_box(sheet, {box.x, box.y, box.width, width_px}, colour);
  fill_box(sheet, {box.x, box.bottom() - width_px, box.width, width_px}, colour);
  fill_box(sheet, {box.x, box.y, width_px, box.height}, colour);
  fill_box(sheet, {box.right() - width_px, box.y, width_px, box.height}, colour);
}

void fill_convex(Sheet& sheet, std::span<const Point2> points_px, Rgba colour) {
  for (std::size_t i = 2; i < points_px.size(); ++i) {
    add_triangle(sheet, flat(points_px[0]), flat(points_px[i - 1]), flat(points_px[i]), colour);
  }
}

void fill_disc(Sheet& sheet, const Point2& centre_px, double radius_px, Rgba colour) {
  add_disc(sheet, flat(centre_px), radius_px, colour);
}

void stroke(Sheet& sheet, std::span<const Point3> points_px, double width_px, Rgba colour,
            bool closed) {
  const std::vector<Point3> points = without_repeats(points_px, closed);
  const std::size_t count = points.size();
  if (count == 0) return;
  const std::size_t legs = closed && count > 2 ? count : count - 1;
  for (std::size_t i = 0; i < legs; ++i) {
    add_segment(sheet, points[i], points[(i + 1) % count], width_px, colour);
  }
  // Below this width a joint's roundness cannot be seen.
  constexpr double kRoundFrom_px = 1.25;
  if (width_px < kRoundFrom_px) return;
  const double radius_px = 0.5 * width_px;
  if (legs == 0) return add_disc(sheet, points[0], radius_px, colour);
  const auto along = [&](std::size_t leg) {
    return Point2((points[(leg + 1) % count] - points[leg]).head<2>());
  };
  for (std::size_t leg = 1; leg < legs; ++leg) {
    add_joint(sheet, points[leg], along(leg - 1), along(leg), radius_px, colour);
  }
  if (legs == count)
    return add_joint(sheet, points[0], along(legs - 1), along(0), radius_px, colour);
  add_end(sheet, points[0], -along(0), radius_px, colour);
  add_end(sheet, points[count - 1], along(legs - 1), radius_px, colour);
}

void stroke(Sheet& sheet, std::span<const Point2> points_px, double width_px, Rgba colour,
            bool closed) {
  std::vector<Point3> points;
  points.reserve(points_px.size());
  for (const Point2& p : points_px) points.push_back(flat(p));
  stroke(sheet, points, width_px, colour, closed);
}

void stroke_tapered(Sheet& sheet, std::span<const Point3> points_px,
                    std::span<const double> widths_px, Rgba colour) {
  for (std::size_t i = 1; i < points_px.size(); ++i) {
    add_segment(sheet, points_px[i - 1], points_px[i], 0.5 * (widths_px[i - 1] + widths_px[i]),
                colour);
  }
}

void hatch(Sheet& sheet, std::span<const std::vector<Point2>> rings_px, double spacing_px,
           double width_px, Rgba colour) {
  // The lines are x + y = level; along one, places are told by x - y.
  double low = 1e30;
  double high = -1e30;
  for (const auto& ring : rings_px) {
    for (const Point2& p : ring) {
      low = std::min(low, p.sum());
      high = std::max(high, p.sum());
    }
  }
  for (double level = std::ceil(low / spacing_px) * spacing_px; level < high; level += spacing_px) {
    std::vector<double> crossings;
    for (const auto& ring : rings_px) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2& a = ring[i];
        const Point2& b = ring[(i + 1) % ring.size()];
        if ((a.sum() <= level) == (b.sum() <= level)) continue;
        const Point2 p = a + (b - a) * ((level - a.sum()) / (b.sum() - a.sum()));
        crossings.push_back(p.x() - p.y());
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
      const Point2 from((level + crossings[i - 1]) / 2.0, (level - crossings[i - 1]) / 2.0);
      const Point2 to((level + crossings[i]) / 2.0, (level - crossings[i]) / 2.0);
      add_segment(sheet, flat(from), flat(to), width_px, colour);
    }
  }
}

void write_text(Sheet& sheet, Typeface& typeface, const Point2& p_px, std::string_view utf8,
                TextStyle style, Rgba colour, Align align) {
  const int width = align == Align::kLeft ? 0 : text_width_px(typeface, utf8, style);
  const double shift = align == Align::kCentre ? 0.5 * width : align == Align::kRight ? width : 0.0;
  auto pen = static_cast<float>(std::round(p_px.x() - shift));
  const auto base = static_cast<float>(std::round(p_px.y()));
  for (const char32_t letter : letters(utf8)) {
    const Glyph& glyph = typeface.glyph(letter, style);
    const float x = pen + static_cast<float>(glyph.left);
    const float y = base - static_cast<float>(glyph.top);
    const Eigen::Vector2f size(static_cast<float>(glyph.width), static_cast<float>(glyph.height));
    const Eigen::Vector2f texel(static_cast<float>(glyph.x), static_cast<float>(glyph.y));
    const auto corner = [&](float u, float v) {
      const Eigen::Vector2f offset = size.cwiseProduct(Eigen::Vector2f(u, v));
      sheet.vertices.push_back(
          {Eigen::Vector3f(x + offset.x(), y + offset.y(), 0.0F), texel + offset, colour});
    };
    corner(0, 0), corner(1, 0), corner(1, 1);
    corner(0, 0), corner(1, 1), corner(0, 1);
    pen += static_cast<float>(glyph.advance);
  }
}

std::vector<Point3> thinned(std::span<const Point3> points_px, double tolerance_px) {
  std::vector<Point3> kept;
  for (std::size_t i = 0; i < points_px.size(); ++i) {
    const bool last = i + 1 == points_px.size();
    if (kept.empty() || last || (points_px[i] - kept.back()).head<2>().norm() > tolerance_px) {
      kept.push_back(points_px[i]);
    }
  }
  return kept;
}

std::vector<Point3> simplified(std::span<const Point3> points_px, double tolerance_px) {
  using Line = boost::geometry::model::linestring<boost::geometry::model::d2::point_xy<double>>;
  Line line;
  line.reserve(points_px.size());
  for (const Point3& p : points_px) line.emplace_back(p.x(), p.y());
  Line simple;
  boost::geometry::simplify(line, simple, tolerance_px);
  std::vector<Point3> kept;
  kept.reserve(simple.size());
  for (const auto& p : simple) kept.emplace_back(p.x(), p.y(), 0.0);
  return kept;
}

void paint(const Sheet& sheet, const Typeface& typeface, const Canvas& canvas, bool test_depth) {
  if (sheet.vertices.empty()) return;
  const GlTexture ink(Typeface::kTextureWidth, typeface.texture_height(), 1, typeface.texels(),
                      false);
  const std::array<GlAttribute, 3> attributes = {
      {{3, GL_FLOAT, offsetof(SheetVertex, p_px)},
       {2, GL_FLOAT, offsetof(SheetVertex, texel)},
       {4, GL_UNSIGNED_BYTE, offsetof(SheetVertex, colour)}}};
  const GlTriangles triangles(std::as_bytes(std::span(sheet.vertices)), sizeof(SheetVertex),
                              attributes, {});
  canvas.programs.sheet.use();
  canvas.programs.sheet.set("frame_px", Eigen::Vector2f(canvas.size_px.cast<float>()));
  ink.bind();
  glViewport(-canvas.corner_px.x(), canvas.corner_px.y() + canvas.tile_px.y() - canvas.size_px.y(),
             canvas.size_px.x(), canvas.size_px.y());
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  if (test_depth) {
    glEnable(GL_DEPTH_TEST);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  triangles.draw();
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace headland
