#include "render/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluate/duration_text.h"
#include "render/text_lines.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kMargin = 36.0;        // units
constexpr double kTitleHeight = 116.0;  // units
constexpr int kBody = 15;               // text size, units
constexpr double kLine = 23.0;          // units from line to line
constexpr double kSwatchWidth = 26.0;   // units

// The grade in a box at the page's upper right corner, and why in a line of its own.
void write_verdict(Sheet& sheet, Typeface& typeface, const Page& page, const Verdict& verdict) {
  const TextStyle style = page.text(22, true);
  const std::string_view word = grade_name(verdict.grade);
  const double width = text_width_px(typeface, word, style) + page.px(28);
  const Box box{std::round(page.column.right() - width), std::round(page.px(24)), std::round(width),
                std::round(page.px(36))};
  fill_box(sheet, box, grade_colour(verdict.grade));
  write_text(sheet, typeface, {box.x + 0.5 * box.width, box.y + page.px(26)}, word, style,
             colours::kPaper, Align::kCentre);
  const TextStyle body = page.text(kBody, true);
  std::string why = "Every judged figure is within its limits.";
  Rgba colour = grade_colour(verdict.grade);
  if (!verdict.reasons.empty()) {
    why = verdict.reasons.front().text;
    colour = grade_colour(verdict.reasons.front().grade);
    if (verdict.reasons.size() > 1)
      why += fmt::format("  (and {} more)", verdict.reasons.size() - 1);
  }
  const double room = page.column.right() - page.main.x;
  write_text(sheet, typeface, {page.main.x, page.px(100)}, fitted_text(typeface, why, body, room),
             body, colour);
}

}  // namespace

Rgba grade_colour(Grade grade) {
  switch (grade) {
    case Grade::kPass:
      return colours::kPass;
    case Grade::kWarn:
      return colours::kWarn;
    case Grade::kFail:
      return colours::kFail;
  }
  return colours::kInk;
}

TextStyle Page::text(int units, bool bold) const {
  constexpr int kSmallest_px = 8;
  return {std::max(kSmallest_px, static_cast<int>(std::lround(px(units)))), bold};
}

Page page_of(const PictureSize& size, double column_units) {
  if (size.width < kMinPicture_px || size.height < kMinPicture_px) {
    throw InputError("picture", "size", fmt::format("{}x{}", size.width, size.height),
                     fmt::format("at least {} pixels wide and high", kMinPicture_px));
  }
  Page page;
  page.size_px = {size.width, size.height};
  page.unit_px = std::min(size.width / 1600.0, size.height / 1000.0);
  const double margin = std::round(page.px(kMargin));
  const double column = std::round(page.px(column_units));
  const double top = std::round(page.px(kTitleHeight));
  const double height = size.height - top - margin;
  page.main = {margin, top, size.width - 3.0 * margin - column, height};
  page.column = {size.width - margin - column, top, column, height};
  return page;
}

void write_title(Sheet& sheet, Typeface& typeface, const Page& page, const PictureScene& scene,
                 std::string_view what) {
  const double x = page.main.x;
  const double room = page.column.right() - x;
  const TextStyle big = page.text(28, true);
  const TextStyle plain = page.text(28);
  const std::string name = fitted_text(
      typeface, scene.field.name.empty() ? "Unnamed field" : scene.field.name, big, 0.6 * room);
  const double y = page.px(50);
  write_text(sheet, typeface, {x, y}, name, big, colours::kInk);
  write_text(sheet, typeface, {x + text_width_px(typeface, name, big) + page.px(14), y}, what,
             plain, colours::kInkSoft);

  const RunRecord& run = scene.run;
  std::string line = fmt::format("{:.2f} ha", field_area_m2(scene.field) / 1e4);
  if (!scene.vehicle.name.empty()) line += "  ·  " + scene.vehicle.name;
  if (scene.vehicle.implement.working_width_m > 0.0) {
    line += fmt::format("  ·  {:.3g} m working width", scene.vehicle.implement.working_width_m);
  }
  if (!scene.path_file.empty()) line += "  ·  " + scene.path_file;
  if (run.samples.empty()) {
    line += "  ·  not driven";
  } else {
    // Totals and outcome may be missing where the record is.
    line += run.duration_s > 0.0 || run.samples.back().time_s <= 0.0
                ? fmt::format("  ·  {:.2f} km in {}  ·  {}", run.distance_m / 1000.0,
                              duration_text(run.duration_s),
                              scene.moment_s ? "under way" : outcome_name(run.outcome))
                : fmt::format("  ·  {} on record, totals missing",
                              duration_text(run.samples.back().time_s));
  }
  const TextStyle body = page.text(kBody);
  write_text(sheet, typeface, {x, page.px(76)}, fitted_text(typeface, line, body, room), body,
             colours::kInkSoft);
  if (scene.verdict != nullptr) write_verdict(sheet, typeface, page, *scene.verdict);
  if (!scene.missing.empty()) {
    const TextStyle bold = page.text(kBody, true);
    write_text(sheet, typeface, {x, page.px(100)},
               fitted_text(typeface, "Record not whole: " + scene.missing, bold, room), bold,
               colours::kWarn);
  }
}

void legend_heading(Legend& legend, std::string_view text) {
  const Page& page = legend.page;
  const double x = page.column.x;
  legend.y_px += page.px(kLine);
  write_text(legend.sheet, legend.typeface, {x, legend.y_px - page.px(7)}, text,
             page.text(kBody, true), colours::kInk);
  const double rule_px = std::max(1.0, std::round(page.px(1.0)));
  fill_box(legend.sheet, {x, std::round(legend.y_px), page.column.width, rule_px}, colours::kRule);
  legend.y_px += page.px(6);
}

void legend_note(Legend& legend, std::string_view text) {
  const Page& page = legend.page;
  const TextStyle style = page.text(13);
  for (const std::string& line :
       lines_within(legend.typeface, text, style, legend.page.column.width)) {
    legend.y_px += page.px(19);
    write_text(legend.sheet, legend.typeface, {page.column.x, legend.y_px - page.px(4)}, line,
               style, colours::kInkSoft);
  }
}

Eigen::Vector2d legend_symbol(Legend& legend, std::string_view label, std::string_view figure) {
  const Page& page = legend.page;
  legend.y_px += page.px(kLine);
  const double base = legend.y_px - page.px(6);
  const TextStyle style = page.text(kBody);
  const double label_x = page.column.x + page.px(kSwatchWidth + 12);
  double room = page.column.right() - label_x;
  if (!figure.empty()) {
    write_text(legend.sheet, legend.typeface, {page.column.right(), base}, figure, style,
               colours::kInk, Align::kRight);
    room -= text_width_px(legend.typeface, figure, style) + page.px(8);
  }
  write_text(legend.sheet, legend.typeface, {label_x, base},
             fitted_text(legend.typeface, label, style, room), style, colours::kInk);
  return {page.column.x + page.px(0.5 * kSwatchWidth), base - page.px(5)};
}

void legend_swatch(Legend& legend, Rgba colour, std::string_view label, std::string_view figure) {
  const Eigen::Vector2d centre = legend_symbol(legend, label, figure);
  const double width = std::round(legend.page.px(kSwatchWidth));
  const double height = std::round(legend.page.px(15));
  const Box box{std::round(centre.x() - 0.5 * width), std::round(centre.y() - 0.5 * height), width,
                height};
  fill_box(legend.sheet, box, colour);
  frame_box(legend.sheet, box, 1.0, mix(colour, colours::kInk, 0.35));
}

void legend_gap(Legend& legend, double units) { legend.y_px += legend.page.px(units); }

double round_down_to_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0}) {
    if (value >= step * power) return step * power;
  }
  return power;
}

void draw_scale_bar(Sheet& sheet, Typeface& typeface, const Page& page, double px_per_m,
                    double wanted_px, const Eigen::Vector2d& p_px) {
  const double length_m = round_down_to_125(wanted_px / px_per_m);
  const double length_px = length_m * px_per_m;
  const double height = std::max(4.0, std::round(page.px(7)));
  const double x = std::round(p_px.x());
  const double y = std::round(p_px.y());
  constexpr int kPieces = 4;
  for (int i = 0; i < kPieces; ++i) {
    fill_box(sheet, {x + length_px * i / kPieces, y, length_px / kPieces, height},
             i % 2 == 0 ? colours::kInk : colours::kPaper);
  }
  frame_box(sheet, {x, y, length_px, height}, std::max(1.0, std::round(page.px(1))), colours::kInk);
  const TextStyle style = page.text(13);
  const double base = y + height + page.px(17);
  write_text(sheet, typeface, {x, base}, "0", style, colours::kInk, Align::kLeft);
  const std::string text = length_m >= 1000.0 ? fmt::format("{:g} km", length_m / 1000.0)
                                              : fmt::format("{:g} m", length_m);
  write_text(sheet, typeface, {x + length_px, base}, text, style, colours::kInk, Align::kRight);
}

void draw_north_arrow(Sheet& sheet, Typeface& typeface, const Page& page,
                      const Eigen::Vector2d& centre_px, const Eigen::Vector2d& north_px) {
  const Eigen::Vector2d north = north_px.normalized();
  const Eigen::Vector2d east(-north.y(), north.x());
  const double size = page.px(19);
  const Eigen::Vector2d tip = centre_px + size * north;
  const Eigen::Vector2d notch = centre_px - 0.45 * size * north;
  const Eigen::Vector2d left = centre_px - 0.8 * size * north - 0.55 * size * east;
  const Eigen::Vector2d right = centre_px - 0.8 * size * north + 0.55 * size * east;
  fill_convex(sheet, std::array<Eigen::Vector2d, 3>{tip, notch, left}, colours::kInk);
  fill_convex(sheet, std::array<Eigen::Vector2d, 3>{tip, right, notch}, colours::kPaper);
  stroke(sheet, std::array<Eigen::Vector2d, 4>{tip, right, notch, left},
         std::max(1.0, page.px(1.3)), colours::kInk, true);
  const Eigen::Vector2d letter = tip + page.px(11) * north + Eigen::Vector2d(0.0, page.px(5));
  write_text(sheet, typeface, letter, "N", page.text(kBody, true), colours::kInk, Align::kCentre);
}

std::string area_text(double area_m2) {
  return area_m2 >= 1e4 ? fmt::format("{:.2f} ha", area_m2 / 1e4)
                        : fmt::format("{:.0f} m²", area_m2);
}

}  // namespace headland
