// The page the pictures share: title, column of legends, scale bar, north arrow.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "render/camera.h"
#include "render/pictures.h"
#include "render/sheet.h"

namespace headland {

// Where things stand. Lengths scale with the picture so that its look stays.
struct Page {
  Eigen::Vector2i size_px = Eigen::Vector2i::Zero();
  double unit_px = 1.0;  // 1 at 1600 x 1000
  Box main;              // the map or view
  Box column;            // legends, right of it
  double px(double units) const { return units * unit_px; }
  TextStyle text(int units, bool bold = false) const;
};

// Throws InputError for a picture smaller than kMinPicture_px either way.
inline constexpr int kMinPicture_px = 240;
inline constexpr double kColumnWidth = 324.0;  // units
Page page_of(const PictureSize& size, double column_units = kColumnWidth);

Rgba grade_colour(Grade grade);

// The field's name, what the picture shows, the run in a line below, and the verdict with its first
// reason.
void write_title(Sheet& sheet, Typeface& typeface, const Page& page, const PictureScene& scene,
                 std::string_view what);

// Entries of the legend column from top to bottom; `y_px` is where the next one goes.
struct Legend {
  Sheet& sheet;
  Typeface& typeface;
  const Page& page;
  double y_px;
};
void legend_heading(Legend& legend, std::string_view text);
void legend_note(Legend& legend, std::string_view text);  // breaks lines at spaces
void legend_swatch(Legend& legend, Rgba colour, std::string_view label, std::string_view figure);
void legend_gap(Legend& legend, double units);

// The middle of the place for a symbol left of an entry's label; moves to the next entry.
Eigen::Vector2d legend_symbol(Legend& legend, std::string_view label, std::string_view figure = {});

// The largest of 1, 2, 5 times a power of ten that is at most `value` (> 0).
double round_down_to_125(double value);

// A scale bar with a round length, about `wanted_px` long, its left end at p_px; a north arrow.
void draw_scale_bar(Sheet& sheet, Typeface& typeface, const Page& page, double px_per_m,
                    double wanted_px, const Eigen::Vector2d& p_px);
void draw_north_arrow(Sheet& sheet, Typeface& typeface, const Page& page,
                      const Eigen::Vector2d& centre_px, const Eigen::Vector2d& north_px);

// "12.3 ha" or "840 m²".
std::string area_text(double area_m2);

}  // namespace headland
