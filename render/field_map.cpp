// draw_field_map: the driven coverage from above.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "render/map_base.h"
#include "render/pictures.h"
#include "render/track_arrows.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

// Nobody sees a line so far beside itself.
constexpr double kLineTolerance_px = 0.1;

// Widths of the path's lines: as wide as the distance between swaths leaves room for.
struct PathWidths {
  double planned_px = 1.0;
  double driven_px = 1.0;
};

PathWidths path_widths(const PictureScene& scene, const Page& page, const MapView& view) {
  const double spacing_px = scene.vehicle.implement.working_width_m > 0.0
                                ? scene.vehicle.implement.working_width_m * view.camera.px_per_m
                                : page.px(20);
  return {std::clamp(0.26 * spacing_px, 0.6, std::max(1.0, page.px(3.6))),
          std::clamp(0.09 * spacing_px, 0.35, std::max(1.0, page.px(1.3)))};
}

bool is_pass(PathKind kind) { return kind == PathKind::kSwath || kind == PathKind::kHeadlandPass; }

void draw_planned(Sheet& sheet, const PictureScene& scene, const MapView& view,
                  const PathWidths& widths) {
  // Turns on top: they are few and matter more.
  for (const bool passes : {true, false}) {
    for (const PathSegment& segment : scene.path.segments) {
      if (is_pass(segment.kind) != passes) continue;
      std::vector<Point2> line;
      for (const PathPoint& point : segment.points) line.push_back(point.p_W);
      stroke(sheet, simplified(map_line(view, line), kLineTolerance_px), widths.planned_px,
             passes ? colours::kPlannedPass : colours::kPlannedTurn);
    }
  }
}

void draw_driven(Sheet& sheet, const PictureScene& scene, const MapView& view,
                 const PathWidths& widths) {
  if (scene.run.samples.empty()) return;
  stroke(sheet, simplified(track_line(view, scene), kLineTolerance_px), widths.driven_px,
         colours::kDriven);
}

// Number of a reason in a disc of its grade's colour.
void draw_mark(Sheet& sheet, Typeface& typeface, const Page& page, const Point2& p_px, int number,
               Grade grade) {
  const double radius = page.px(11);
  fill_disc(sheet, p_px, radius + page.px(2), colours::kPaper);
  fill_disc(sheet, p_px, radius, grade_colour(grade));
  write_text(sheet, typeface, p_px + Point2(0.0, page.px(5)), fmt::format("{}", number),
             page.text(14, true), colours::kPaper, Align::kCentre);
}

// Where the verdict's reasons lie, numbered as in the legend.
void draw_reasons(Sheet& sheet, Typeface& typeface, const PictureScene& scene, const Page& page,
                  const MapView& view) {
  if (scene.verdict == nullptr) return;
  // The worst is first and is drawn last, on top.
  for (std::size_t i = scene.verdict->reasons.size(); i-- > 0;) {
    const Reason& reason = scene.verdict->reasons[i];
    if (!reason.p_W || !reason.p_W->allFinite()) continue;
    draw_mark(sheet, typeface, page, pixel_of(view.camera, *reason.p_W), static_cast<int>(i) + 1,
              reason.grade);
  }
}

void legend_reasons(Legend& legend, const PictureScene& scene) {
  if (scene.verdict == nullptr || scene.verdict->reasons.empty()) return;
  legend_heading(legend, "Verdict");
  int number = 0;
  for (const Reason& reason : scene.verdict->reasons) {
    const Point2 centre = legend_symbol(legend, reason.title);
    draw_mark(legend.sheet, legend.typeface, legend.page, centre, ++number, reason.grade);
  }
  legend_gap(legend, 10);
}

// Under way it is no fault that ground is left, nor is it known to be one without the record.
Rgba missed_colour(const PictureScene& scene) {
  return scene.moment_s || !scene.missing.empty() ? colours::kUnworked : colours::kMissed;
}

std::string_view missed_label(const PictureScene& scene) {
  if (scene.moment_s) return "Not yet";
  return scene.missing.empty() ? "Missed" : "Not on record";
}

void legend_coverage(Legend& legend, const PictureScene& scene) {
  const CoverageAreas areas = coverage_areas(scene.coverage);
  const double total_m2 = std::accumulate(areas.inside_m2.begin(), areas.inside_m2.end(), 0.0);
  const auto figure = [&](std::size_t i) {
    return total_m2 > 0.0 ? fmt::format("{}  {:4.1f} %", area_text(areas.inside_m2[i]),
                                        100.0 * areas.inside_m2[i] / total_m2)
                          : std::string();
  };
  legend_heading(legend, scene.run.samples.empty() ? "Coverage of the path" : "Driven coverage");
  legend_swatch(legend, colours::kOnce, "Once", figure(0));
  legend_swatch(legend, colours::kTwice, "Twice", figure(1));
  legend_swatch(legend, colours::kThrice, "3+ times", figure(2));
  legend_swatch(legend, missed_colour(scene), missed_label(scene), figure(3));
  if (areas.outside_m2 > 0.0) {
    legend_note(legend, fmt::format("{} worked outside the field.", area_text(areas.outside_m2)));
  }
  legend_gap(legend, 10);
}

void legend_path(Legend& legend, const PictureScene& scene) {
  const Page& page = legend.page;
  legend_heading(legend, "Path");
  const Point2 half(page.px(13), 0.0);
  const auto sample = [&](std::string_view label, Rgba colour, double width_px) {
    const Point2 centre = legend_symbol(legend, label);
    // On the ground's colour, as in the map: a white line on paper cannot be seen.
    fill_box(legend.sheet,
             {centre.x() - half.x(), centre.y() - page.px(7), 2 * half.x(), page.px(14)},
             colours::kOnce);
    stroke(legend.sheet, std::array{Point2(centre - half), Point2(centre + half)}, width_px,
           colour);
  };
  sample("Planned swath or headland pass", colours::kPlannedPass, page.px(3.6));
  sample("Planned turn or transit", colours::kPlannedTurn, page.px(3.6));
  if (!scene.run.samples.empty()) {
    sample("Driven", colours::kDriven, std::max(1.0, page.px(1.3)));
  }
  legend_start_and_end(legend, scene);
  legend_gap(legend, 10);
}

}  // namespace

Image draw_field_map(const PictureScene& scene, const PictureSize& size) {
  const Page page = page_of(size);
  Typeface typeface(kFontFile, kBoldFontFile);
  const MapView view = map_view(scene, page);

  MapSheets sheets;
  const PathWidths widths = path_widths(scene, page, view);
  draw_planned(sheets.map, scene, view, widths);
  draw_driven(sheets.map, scene, view, widths);
  draw_arrows(sheets.map, track_line(view, scene), track_arrows(page, colours::kDriven));
  draw_field_lines(sheets.map, scene, page, view);
  draw_start_and_end(sheets.map, scene, page, view);
  draw_reasons(sheets.map, typeface, scene, page, view);

  write_title(sheets.margin, typeface, page, scene, "Coverage");
  Legend legend{sheets.margin, typeface, page, page.column.y - page.px(4)};
  legend_reasons(legend, scene);
  legend_coverage(legend, scene);
  legend_path(legend, scene);
  legend_field(legend, scene);
  legend_relief(legend, scene, view);
  draw_map_frame(sheets.margin, typeface, page, view);

  SurfaceLook look;
  look.once = colours::kOnce;
  look.twice = colours::kTwice;
  look.thrice = colours::kThrice;
  look.missed = missed_colour(scene);
  const GlContext context;
  const MapGround ground(scene, view, coverage_classes(scene.coverage, true), look,
                         colours::kGround);
  return draw_map_page(page, typeface, view, ground, sheets);
}

}  // namespace headland
