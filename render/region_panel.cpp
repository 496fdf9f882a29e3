#include "render/region_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/decomposition.h"

namespace headland {
namespace {

// Light enough for lines and numbers on them.
constexpr std::array<Rgba, 8> kPartColours = {
    Rgba{214, 232, 208}, Rgba{250, 229, 200}, Rgba{210, 226, 244}, Rgba{246, 214, 220},
    Rgba{228, 220, 242}, Rgba{246, 243, 196}, Rgba{206, 236, 234}, Rgba{234, 226, 214}};

std::vector<Eigen::Vector2d> points_px(const RegionPanel& panel,
                                       const std::vector<Eigen::Vector2d>& points_W) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(points_W.size());
  for (const Eigen::Vector2d& p_W : points_W) points.push_back(place_px(panel, p_W));
  return points;
}

// Outlines need not be convex: they are filled piece by piece.
void fill_ground(Sheet& sheet, const RegionPanel& panel, const PolygonPart& ground, Rgba colour) {
  for (const Ring& piece : convex_pieces(ground)) {
    fill_convex(sheet, points_px(panel, piece), colour);
  }
}

void dashed(Sheet& sheet, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width_px,
            Rgba colour) {
  const double length = (to - from).norm();
  const double dash = 4.0 * width_px;
  for (double at = 0.0; at < length; at += 2.0 * dash) {
    const auto point = [&](double along) {
      return Eigen::Vector2d(from + std::min(along, length) / length * (to - from));
    };
    const std::array<Eigen::Vector2d, 2> ends = {point(at), point(at + dash)};
    stroke(sheet, ends, width_px, colour);
  }
}

// A place well inside the part.
Eigen::Vector2d label_W(const Ring& outline) {
  return widest_disc({{PolygonPart{outline, {}}}}).centre_W;
}

void write_number(Sheet& sheet, Typeface& typeface, const Eigen::Vector2d& p_px, int number,
                  int size_px) {
  const std::string text = fmt::format("{}", number);
  const TextStyle style{size_px, true};
  const double width = text_width_px(typeface, text, style);
  const double radius = std::max(0.75 * size_px, 0.5 * width + 0.25 * size_px);
  fill_disc(sheet, p_px, radius, {255, 255, 255, 215});
  write_text(sheet, typeface, {p_px.x(), p_px.y() + 0.36 * size_px}, text, style, colours::kInk,
             Align::kCentre);
}

void mark_place(Sheet& sheet, const Eigen::Vector2d& p_px, double size_px, Rgba colour) {
  fill_disc(sheet, p_px, size_px + 2.0, colours::kPaper);
  fill_disc(sheet, p_px, size_px, colour);
}

}  // namespace

Eigen::AlignedBox2d seen_box(const RegionGround& ground) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : ground.ground.outer) box.extend(p_W);
  if (ground.start_W) box.extend(*ground.start_W);
  if (ground.end_W) box.extend(*ground.end_W);
  const double margin_m = 0.03 * box.sizes().maxCoeff();
  box.extend(Eigen::Vector2d(box.min().array() - margin_m));
  box.extend(Eigen::Vector2d(box.max().array() + margin_m));
  return box;
}

Eigen::Vector2d place_px(const RegionPanel& panel, const Eigen::Vector2d& p_W) {
  return panel.corner_px + panel.px_per_m * Eigen::Vector2d(p_W.x() - panel.box_W.min().x(),
                                                            panel.box_W.max().y() - p_W.y());
}

void draw_region_panel(Sheet& sheet, Typeface& typeface, const RegionPanel& panel,
                       const std::vector<DrawnVisit>& visits) {
  const RegionGround& ground = panel.ground;
  const double panel_px = panel.px_per_m * panel.box_W.sizes().maxCoeff();
  const double line_px = std::clamp(panel_px / 500.0, 1.0, 2.4);
  for (std::size_t part = 0; part < ground.parts_W.size(); ++part) {
    fill_ground(sheet, panel, {ground.parts_W[part], {}}, kPartColours[part % kPartColours.size()]);
  }
  for (const Ring& piece : ground.dropped_W) {
    fill_ground(sheet, panel, {piece, {}}, colours::kDroppedPart);
    const std::array rings = {points_px(panel, piece)};
    hatch(sheet, rings, 6.0 * line_px, line_px, colours::kInkSoft);
  }
  for (const Ring& hole : ground.ground.holes) {
    const Ring turned(hole.rbegin(), hole.rend());
    fill_ground(sheet, panel, {turned, {}}, colours::kHoleGround);
  }
  for (const Ring& part : ground.parts_W) {
    stroke(sheet, points_px(panel, part), 0.7 * line_px, colours::kInkSoft, true);
  }
  stroke(sheet, points_px(panel, ground.ground.outer), 1.5 * line_px, colours::kInk, true);
  for (const Ring& hole : ground.ground.holes) {
    stroke(sheet, points_px(panel, hole), 1.5 * line_px, colours::kInk, true);
  }
  for (const DrawnVisit& visit : visits) {
    stroke(sheet, points_px(panel, visit.way_W), line_px, colours::kSweepLine);
  }
  const auto link = [&](const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W) {
    dashed(sheet, place_px(panel, from_W), place_px(panel, to_W), 1.3 * line_px,
           colours::kPartLink);
  };
  for (std::size_t i = 1; i < visits.size(); ++i) {
    link(visits[i - 1].way_W.back(), visits[i].way_W.front());
  }
  if (!visits.empty()) {
    const double mark_px = 4.0 * line_px;
    const Eigen::Vector2d first_W = ground.start_W.value_or(visits.front().way_W.front());
    const Eigen::Vector2d last_W = ground.end_W.value_or(visits.back().way_W.back());
    if (ground.start_W) link(first_W, visits.front().way_W.front());
    if (ground.end_W) link(visits.back().way_W.back(), last_W);
    mark_place(sheet, place_px(panel, first_W), mark_px, colours::kPlanStart);
    mark_place(sheet, place_px(panel, last_W), mark_px, colours::kPlanEnd);
  }
  // With many parts numbers would hide the plan.
  const double number_px =
      0.35 * panel_px / std::sqrt(1.0 + 4.0 * static_cast<double>(visits.size()));
  const int size_px = static_cast<int>(std::clamp(number_px, 9.0, std::max(9.0, panel_px / 45.0)));
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Ring& outline = ground.parts_W[static_cast<std::size_t>(visits[i].part)];
    write_number(sheet, typeface, place_px(panel, label_W(outline)), static_cast<int>(i) + 1,
                 size_px);
  }
}

}  // namespace headland
